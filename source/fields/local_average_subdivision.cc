// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/sizes.h>
#include <waker/fields/covariance_factor.h>
#include <waker/fields/local_average_subdivision.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  struct LocalAverageSubdivision::Factor
  {
    Eigen::MatrixXd L;
  };



  LocalAverageSubdivision::LocalAverageSubdivision(
    const FieldLattice &lattice,
    const Correlation  &correlation,
    const std::string  &path,
    const unsigned int  maximum_stage_0)
    : lattice(lattice)
    , k(lattice.n_cells)
    , factor(std::make_unique<Factor>())
  {
    const unsigned int dim = correlation.dim();
    const std::size_t  largest =
      maximum_stage_0 > 0 ? maximum_stage_0 : default_stage_0(dim);
    unsigned int m = 0;
    while (std::size_t(k[0]) * k[1] * k[2] > largest)
      {
        ++m;
        for (unsigned int d = 0; d < dim; ++d)
          k[d] = ((lattice.n_cells[d] - 1) >> m) + 1; // rounded upwards
      }

    double cells = double(k[0]) * k[1] * k[2];
    for (unsigned int i = 0; i < m * dim; ++i)
      cells *= 2;
    if (cells > double(maximum_cells))
      throw UserError(path + "/Generator",
                      "local average subdivision of " +
                        std::to_string(lattice.n_cells[0]) + " x " +
                        std::to_string(lattice.n_cells[1]) + " x " +
                        std::to_string(lattice.n_cells[2]) +
                        " cells needs a field of " + std::to_string(k[0]) +
                        " x " + std::to_string(k[1]) + " x " +
                        std::to_string(k[2]) + " times 2^" + std::to_string(m) +
                        " in each direction",
                      "at most " + std::to_string(maximum_cells) +
                        " cells, or another generator");

    require_memory(path + "/Cell size",
                   "makes " + std::to_string(std::uint64_t(cells)) +
                     " cells of the subdivision",
                   3. * sizeof(double) * cells, // noise, and two stages
                   "larger cells of the field");

    std::array<double, 3> size = lattice.cell_size;
    for (unsigned int d = 0; d < dim; ++d)
      size[d] *= double(std::size_t(1) << m);
    factor->L =
      covariance_factor(covariance_matrix(correlation.table(size, k), k), path);

    std::array<unsigned int, 3> parents = k;
    for (unsigned int stage = 0; stage < m; ++stage)
      {
        for (unsigned int d = 0; d < dim; ++d)
          size[d] /= 2;
        stages.emplace_back(correlation, parents, size, path);
        for (unsigned int d = 0; d < dim; ++d)
          parents[d] *= 2;
      }
    fine.resize(std::size_t(cells));
    coarse.resize(fine.size());
  }



  LocalAverageSubdivision::~LocalAverageSubdivision() = default;



  std::size_t
  LocalAverageSubdivision::n_noise() const
  {
    return fine.size();
  }



  void
  LocalAverageSubdivision::generate(const double *noise, double *values) const
  {
    const Eigen::MatrixXd                  &L = factor->L;
    const Eigen::Map<const Eigen::VectorXd> u(noise, L.cols());
    Eigen::Map<Eigen::VectorXd>(fine.data(), L.rows()).noalias() = L * u;

    noise += L.rows();
    for (const SubdivisionStage &stage : stages)
      {
        coarse.swap(fine);
        stage.subdivide(coarse.data(), noise, fine.data());
        noise += stage.n_noise();
      }

    // The part at the lower corner.
    const std::array<unsigned int, 3> &n   = lattice.n_cells;
    const std::size_t                  n_x = std::size_t(k[0]) << stages.size();
    const std::size_t                  n_y =
      lattice.dim > 1 ? std::size_t(k[1]) << stages.size() : 1;
    for (unsigned int z = 0; z < n[2]; ++z)
      for (unsigned int y = 0; y < n[1]; ++y)
        std::copy_n(fine.data() + n_x * (y + n_y * z),
                    n[0],
                    values + std::size_t(n[0]) * (y + std::size_t(n[1]) * z));
  }



  std::string
  LocalAverageSubdivision::description() const
  {
    std::string text = "local average subdivision of ";
    for (unsigned int d = 0; d < lattice.dim; ++d)
      text += (d > 0 ? " x " : "") + std::to_string(k[d]);
    return text + " cells, " + std::to_string(stages.size()) + " times";
  }
} // namespace Waker
