// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/base/sizes.h>
#include <waker/fields/circulant_embedding.h>

#include <algorithm>
#include <cmath>
#include <fftw3.h>
#include <numeric>
#include <sstream>

namespace Waker
{
  using namespace dealii;

  namespace
  {
    /// The smallest size >= n that FFTW likes: 2^a 3^b 5^c 7^d.
    unsigned int
    fast_size(unsigned int n)
    {
      for (;; ++n)
        {
          unsigned int rest = n;
          for (const unsigned int factor : {2u, 3u, 5u, 7u})
            while (rest % factor == 0)
              rest /= factor;
          if (rest == 1)
            return n;
        }
    }


    std::string
    cells(const std::array<unsigned int, 3> &n, const unsigned int dim)
    {
      std::string text = std::to_string(n[0]);
      for (unsigned int d = 1; d < dim; ++d)
        text += " x " + std::to_string(n[d]);
      return text + " cells";
    }
  } // namespace


  /**
   * The Hartley transform of an array on the torus in one direction after the
   * other, the first one last. Of the result we want the lattice only, so the
   * later passes leave out lines that nobody will read.
   */
  struct CirculantEmbedding::Transform
  {
    double *data = nullptr;
    using Plans  = std::array<fftw_plan, 3>; // one per direction
    Plans                       whole;       // all lines
    Plans                       part;        // those that the lattice needs
    std::array<unsigned int, 3> length;      // of the lines of each plan
    std::size_t                 n;

    Transform(const std::array<unsigned int, 3> &torus,
              const std::array<unsigned int, 3> &wanted)
      : n(std::size_t(torus[0]) * torus[1] * torus[2])
    {
      // FFTW's alignment: the plan, and so the rounding, depends on it.
      data = fftw_alloc_real(n);
      AssertThrow(data != nullptr, ExcMessage("Out of memory for the torus."));

      length       = {{torus[2], torus[1], torus[0]}};
      const int m0 = torus[0], m1 = torus[1], m2 = torus[2];
      const int n1 = wanted[1], n2 = wanted[2];
      // {length, stride}, {the lines: count, stride} in the other directions
      part  = {{plan({m2, m0 * m1}, {m1, m0}, {m0, 1}),
                plan({m1, m0}, {n2, m0 * m1}, {m0, 1}),
                plan({m0, 1}, {n2, m0 * m1}, {n1, m0})}};
      whole = {{plan({m2, m0 * m1}, {m1, m0}, {m0, 1}),
                plan({m1, m0}, {m2, m0 * m1}, {m0, 1}),
                plan({m0, 1}, {m2, m0 * m1}, {m1, m0})}};
    }

    ~Transform()
    {
      for (const fftw_plan p : whole)
        fftw_destroy_plan(p);
      for (const fftw_plan p : part)
        fftw_destroy_plan(p);
      fftw_free(data);
    }

    /// In directions of one cell there is nothing to transform.
    void
    execute(const Plans &plans) const
    {
      for (unsigned int i = 0; i < 3; ++i)
        if (length[i] > 1)
          fftw_execute(plans[i]);
    }

    Transform(const Transform &) = delete;
    Transform &
    operator=(const Transform &) = delete;

  private:
    struct Direction
    {
      int n, stride;
    };

    fftw_plan
    plan(const Direction line, const Direction outer, const Direction inner)
    {
      const fftw_iodim    transform{line.n, line.stride, line.stride};
      const fftw_iodim    loops[2] = {{outer.n, outer.stride, outer.stride},
                                      {inner.n, inner.stride, inner.stride}};
      const fftw_r2r_kind kind     = FFTW_DHT;
      // FFTW_ESTIMATE: the other flags choose a plan by the clock, and with it
      // the last bits.
      const fftw_plan result = fftw_plan_guru_r2r(
        1, &transform, 2, loops, data, data, &kind, FFTW_ESTIMATE);
      AssertThrow(result != nullptr, ExcMessage("FFTW has no such plan."));
      return result;
    }
  };


  CirculantEmbedding::CirculantEmbedding(const FieldLattice &lattice,
                                         const Correlation  &correlation,
                                         const std::string  &path,
                                         const std::size_t   maximum_cells)
    : lattice(lattice)
    , n_torus{{1, 1, 1}}
  {
    Assert(correlation.dim() == lattice.dim,
           ExcMessage("One scale of fluctuation per direction."));

    for (unsigned int d = 0; d < lattice.dim; ++d)
      n_torus[d] = fast_size(std::max(1u, 2 * (lattice.n_cells[d] - 1)));

    std::array<unsigned int, 3> tried{{0, 0, 0}};
    while (true)
      {
        const std::size_t n = std::size_t(n_torus[0]) * n_torus[1] * n_torus[2];
        if (n > maximum_cells)
          {
            std::ostringstream problem;
            if (tried[0] == 0)
              problem << "circulant embedding needs a torus of "
                      << cells(n_torus, lattice.dim);
            else
              problem << "circulant embedding on a torus of "
                      << cells(tried, lattice.dim) << " has a share of "
                      << negative << " of negative eigenvalues";
            throw UserError(path + "/Generator",
                            problem.str(),
                            "a share below 1e-6 on at most " +
                              std::to_string(maximum_cells) +
                              " cells; choose smaller scales of fluctuation, "
                              "'separable Markov', or the generator "
                              "'local average subdivision' or 'Cholesky'");
          }

        require_memory(path + "/Cell size",
                       "makes a torus of " + cells(n_torus, lattice.dim),
                       bytes_per_cell * n,
                       "larger cells of the field");
        transform = std::make_unique<Transform>(n_torus, lattice.n_cells);

        // First row of the circulant matrix: the lag on a torus is the shorter
        // way round.
        const std::array<unsigned int, 3> n_lags{
          {n_torus[0] / 2 + 1, n_torus[1] / 2 + 1, n_torus[2] / 2 + 1}};
        const std::vector<double> covariance =
          correlation.table(lattice.cell_size, n_lags);
        std::size_t number = 0;
        for (unsigned int k = 0; k < n_torus[2]; ++k)
          for (unsigned int j = 0; j < n_torus[1]; ++j)
            for (unsigned int i = 0; i < n_torus[0]; ++i)
              transform->data[number++] =
                covariance[std::min(i, n_torus[0] - i) +
                           std::size_t(n_lags[0]) *
                             (std::min(j, n_torus[1] - j) +
                              std::size_t(n_lags[1]) *
                                std::min(k, n_torus[2] - k))];
        transform->execute(transform->whole);

        double lost = 0.;
        root.resize(n);
        for (std::size_t i = 0; i < n; ++i)
          {
            const double eigenvalue = transform->data[i];
            if (!std::isfinite(eigenvalue))
              throw UserError(path + "/Scales of fluctuation",
                              "the covariance on " +
                                cells(n_torus, lattice.dim) +
                                " has an eigenvalue that is not finite",
                              "scales and cells of sizes that one can measure");
            lost += std::max(0., -eigenvalue);
            root[i] = std::sqrt(std::max(0., eigenvalue)) / n;
          }
        negative = lost / (n * covariance[0]);
        if (negative < tolerance)
          break;

        // Grow where the correlation half-way round is largest: it is the kink
        // there that makes eigenvalues negative.
        tried                = n_torus;
        unsigned int widest  = 0;
        double       largest = -1.;
        for (unsigned int d = 0; d < lattice.dim; ++d)
          if (lattice.n_cells[d] > 1)
            {
              std::array<double, 3> half{{0., 0., 0.}};
              half[d]          = 0.5 * n_torus[d] * lattice.cell_size[d];
              const double rho = correlation.between_points(half);
              if (rho > largest)
                {
                  largest = rho;
                  widest  = d;
                }
            }
        n_torus[widest] = fast_size(n_torus[widest] + n_torus[widest] / 4 + 1);
      }
  }


  CirculantEmbedding::~CirculantEmbedding() = default;


  std::size_t
  CirculantEmbedding::n_noise() const
  {
    return root.size();
  }


  void
  CirculantEmbedding::generate(const double *noise, double *values) const
  {
    const std::array<unsigned int, 3> &n    = lattice.n_cells;
    double *const                      data = transform->data;

    // The first numbers belong to the cells of the lattice, the others to the
    // padding: a larger torus has the same noise where it matters.
    const double *padding = noise + lattice.n();
    double       *line    = data;
    for (unsigned int k = 0; k < n_torus[2]; ++k)
      for (unsigned int j = 0; j < n_torus[1]; ++j, line += n_torus[0])
        {
          unsigned int inside = 0;
          if (j < n[1] && k < n[2])
            {
              inside = n[0];
              std::copy_n(noise, inside, line);
              noise += inside;
            }
          std::copy_n(padding, n_torus[0] - inside, line + inside);
          padding += n_torus[0] - inside;
        }
    transform->execute(transform->whole);
    for (std::size_t i = 0; i < root.size(); ++i)
      data[i] *= root[i];
    transform->execute(transform->part);

    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j, values += n[0])
        std::copy_n(data + std::size_t(n_torus[0]) *
                             (j + std::size_t(n_torus[1]) * k),
                    n[0],
                    values);
  }


  std::string
  CirculantEmbedding::description() const
  {
    std::string text = "circulant embedding on " + cells(n_torus, lattice.dim) +
                       " (" + bytes_text(bytes_per_cell * root.size()) + ")";
    if (negative > 0.)
      {
        std::ostringstream share;
        share << ", negative eigenvalues cut off: " << negative
              << " of the trace";
        text += share.str();
      }
    return text;
  }


  const std::array<unsigned int, 3> &
  CirculantEmbedding::torus() const
  {
    return n_torus;
  }


  double
  CirculantEmbedding::negative_share() const
  {
    return negative;
  }
} // namespace Waker
