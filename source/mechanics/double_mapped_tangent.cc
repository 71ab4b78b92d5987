// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/double_mapped_tangent.h>
#include <waker/mechanics/filled_cells.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Waker
{
  /// The elements' stiffnesses, for one way to make strains.
  template <int dim>
  class ElementTangents
  {
  public:
    virtual ~ElementTangents() = default;

    virtual void
    reinit(const std::vector<SymmetricTensor<4, 3>> &material_tangents,
           const Weights<dim>                       &weights,
           const MaterialPoints<dim>                &points) = 0;

    /// f += K u
    virtual void
    vmult_add(const double *u, double *f) const = 0;

    virtual void
    add_diagonal(double *diagonal) const = 0;
  };


  namespace
  {
    /// Indices (i, j) of n independent strains and stresses: those in dim
    /// dimensions, or in 2D also zz.
    template <unsigned int n>
    constexpr std::array<std::array<unsigned int, 2>, n>
    component_indices()
    {
      if constexpr (n == 3)
        return {{{{0, 0}}, {{1, 1}}, {{0, 1}}}};
      else if constexpr (n == 4)
        return {{{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}}};
      else
        return {{{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{0, 2}}, {{1, 2}}}};
    }


    /// @tparam n strains
    /// @tparam mean is the dilatation that of the element's centre?
    template <int dim, unsigned int n, bool mean>
    class Q1Tangents : public ElementTangents<dim>
    {
    public:
      Q1Tangents(const BackgroundGrid<dim> &grid, const BBarCells cells)
        : b_bar_cells(cells)
        , element_of_cell(grid.n_nodes(), -1)
      {
        const double xi[2] = {0.5 - 0.5 / std::sqrt(3.),
                              0.5 + 0.5 / std::sqrt(3.)};
        for (unsigned int v = 0; v < n_vertices; ++v)
          {
            vertex_offsets[v] = 0;
            for (unsigned int d = 0; d < dim; ++d)
              vertex_offsets[v] += (v >> d & 1) * grid.stride(d);
            // At the centre each other direction's value is a half.
            for (unsigned int d = 0; d < dim; ++d)
              centre_gradients[v][d] = ((v >> d & 1) ? 1. : -1.) *
                                       grid.inverse_cell_size() /
                                       (1 << (dim - 1));
          }
        for (unsigned int g = 0; g < n_gauss; ++g)
          for (unsigned int v = 0; v < n_vertices; ++v)
            {
              shape_values[g][v] = 1.;
              for (unsigned int d = 0; d < dim; ++d)
                shape_gradients[g][v][d] = 1.;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double t     = xi[g >> d & 1];
                  const double value = (v >> d & 1) ? t : 1. - t;
                  const double slope =
                    ((v >> d & 1) ? 1. : -1.) * grid.inverse_cell_size();
                  shape_values[g][v] *= value;
                  for (unsigned int e = 0; e < dim; ++e)
                    shape_gradients[g][v][e] *= (e == d) ? slope : value;
                }
            }
      }

      void
      reinit(const std::vector<SymmetricTensor<4, 3>> &material_tangents,
             const Weights<dim>                       &weights,
             const MaterialPoints<dim>                &points) override;

      void
      vmult_add(const double *u, double *f) const override;

      void
      add_diagonal(double *f) const override;

    private:
      static constexpr unsigned int n_vertices = 1 << dim;
      static constexpr unsigned int n_gauss    = n_vertices;

      struct Element
      {
        unsigned int node;  // lower left
        double       share; // of its volume with soil, then of B-bar
        /// First the sums over points at the nodes, then the values at the
        /// Gauss points times their weight (kN m^(dim-2)).
        double D[n_gauss][n][n];
      };

      /// Engineering strains of a gradient, with its mean dilatation.
      static void
      strain_of(const double (&H)[dim][dim],
                const double centre_dilatation,
                const double share,
                double (&e)[n])
      {
        constexpr auto indices = component_indices<n>();
        double         d       = 0.;
        if constexpr (mean)
          {
            d = centre_dilatation;
            for (unsigned int c = 0; c < dim; ++c)
              d -= H[c][c];
            d *= share / 3.;
          }
        for (unsigned int a = 0; a < n; ++a)
          {
            const unsigned int i = indices[a][0], j = indices[a][1];
            e[a] = i != j ? H[i][j] + H[j][i] : i < dim ? H[i][i] + d : d;
          }
      }

      BBarCells            b_bar_cells;
      std::vector<int>     element_of_cell; // by lower left node
      std::vector<Element> elements;        // the active ones
      /// N_i at the Gauss points, and their gradients there and at the centre
      /// (1/m).
      double shape_values[n_gauss][n_vertices];
      double shape_gradients[n_gauss][n_vertices][dim];
      double centre_gradients[n_vertices][dim];
      std::array<unsigned int, n_vertices> vertex_offsets; // in node numbers
    };


    template <int dim, unsigned int n, bool mean>
    void
    Q1Tangents<dim, n, mean>::reinit(
      const std::vector<SymmetricTensor<4, 3>> &material_tangents,
      const Weights<dim>                       &weights,
      const MaterialPoints<dim>                &points)
    {
      const double h    = weights.background_grid().cell_size();
      const double full = std::pow(h, dim);
      for (const Element &element : elements)
        element_of_cell[element.node] = -1;
      elements.clear();

      constexpr auto indices = component_indices<n>();
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const PointWeights<dim> &w = weights[p];
          double                   D[n][n];
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              D[a][b] = points.volume[p] *
                        material_tangents[p][indices[a][0]][indices[a][1]]
                                         [indices[b][0]][indices[b][1]];

          // Averages of N over the part of the domain in the first and second
          // cell of the stencil, for that cell's lower and upper node. The
          // domain's share of a cell is its weight's slope times h.
          double part[dim][2][2];
          for (unsigned int d = 0; d < dim; ++d)
            {
              part[d][0][0] = w.value[d][0];
              part[d][0][1] = -w.gradient[d][0] * h - w.value[d][0];
              part[d][1][0] = w.gradient[d][2] * h - w.value[d][2];
              part[d][1][1] = w.value[d][2];
            }
          for (unsigned int cell = 0; cell < n_vertices; ++cell)
            {
              bool touched = true;
              for (unsigned int d = 0; d < dim; ++d)
                touched = touched && w.gradient[d][2 * (cell >> d & 1)] != 0.;
              if (!touched)
                continue;
              const unsigned int node   = w.base + vertex_offsets[cell];
              int               &number = element_of_cell[node];
              if (number < 0)
                {
                  number = elements.size();
                  elements.emplace_back();
                  elements.back().node  = node;
                  elements.back().share = 0.;
                  std::fill_n(&elements.back().D[0][0][0], n_gauss * n * n, 0.);
                }
              Element &element = elements[number];
              double   volume  = points.volume[p];
              for (unsigned int d = 0; d < dim; ++d)
                volume *= std::abs(w.gradient[d][2 * (cell >> d & 1)]) * h;
              element.share += volume / full;
              for (unsigned int v = 0; v < n_vertices; ++v)
                {
                  double share = 1.;
                  for (unsigned int d = 0; d < dim; ++d)
                    share *= part[d][cell >> d & 1][v >> d & 1];
                  for (unsigned int a = 0; a < n; ++a)
                    for (unsigned int b = 0; b < n; ++b)
                      element.D[v][a][b] += share * D[a][b];
                }
            }
        }

      // Of a cell that several ranks have points in, each has a part of D, and
      // all need the whole share.
      const NodeExchange &ranks = weights.background_grid().exchange();
      if (mean && !ranks.is_one_rank())
        {
          std::vector<double> shares(element_of_cell.size(), 0.);
          for (const Element &element : elements)
            shares[element.node] = element.share;
          ranks.sum({{shares.data(), 1}});
          for (Element &element : elements)
            element.share = shares[element.node];
        }

      // Nodes to Gauss points. D_i carries n / V_e, a Gauss weight V_e / n:
      // they cancel.
      for (Element &element : elements)
        {
          element.share =
            FilledCells<dim>::share_of_cell(element.share, b_bar_cells);
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              {
                double gauss[n_gauss];
                for (unsigned int g = 0; g < n_gauss; ++g)
                  {
                    gauss[g] = 0.;
                    for (unsigned int v = 0; v < n_vertices; ++v)
                      gauss[g] += shape_values[g][v] * element.D[v][a][b];
                  }
                for (unsigned int g = 0; g < n_gauss; ++g)
                  element.D[g][a][b] = gauss[g];
              }
        }
    }


    template <int dim, unsigned int n, bool mean>
    void
    Q1Tangents<dim, n, mean>::vmult_add(const double *u, double *f) const
    {
      constexpr auto indices = component_indices<n>();
      for (const Element &element : elements)
        {
          double centre = 0.; // dilatation
          if constexpr (mean)
            for (unsigned int v = 0; v < n_vertices; ++v)
              for (unsigned int c = 0; c < dim; ++c)
                centre += u[dim * (element.node + vertex_offsets[v]) + c] *
                          centre_gradients[v][c];
          for (unsigned int g = 0; g < n_gauss; ++g)
            {
              double H[dim][dim] = {};
              for (unsigned int v = 0; v < n_vertices; ++v)
                for (unsigned int c = 0; c < dim; ++c)
                  for (unsigned int d = 0; d < dim; ++d)
                    H[c][d] += u[dim * (element.node + vertex_offsets[v]) + c] *
                               shape_gradients[g][v][d];
              double strain[n];
              strain_of(H, centre, element.share, strain);
              double P[3][3], q = 0.;
              for (unsigned int a = 0; a < n; ++a)
                {
                  double s = 0.;
                  for (unsigned int b = 0; b < n; ++b)
                    s += element.D[g][a][b] * strain[b];
                  P[indices[a][0]][indices[a][1]] = s;
                  P[indices[a][1]][indices[a][0]] = s;
                  if (mean && indices[a][0] == indices[a][1])
                    q += element.share * s / 3.;
                }
              for (unsigned int v = 0; v < n_vertices; ++v)
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    double &force =
                      f[dim * (element.node + vertex_offsets[v]) + c];
                    for (unsigned int d = 0; d < dim; ++d)
                      force += P[c][d] * shape_gradients[g][v][d];
                    if constexpr (mean)
                      force +=
                        q * (centre_gradients[v][c] - shape_gradients[g][v][c]);
                  }
            }
        }
    }


    template <int dim, unsigned int n, bool mean>
    void
    Q1Tangents<dim, n, mean>::add_diagonal(double *f) const
    {
      for (const Element &element : elements)
        for (unsigned int g = 0; g < n_gauss; ++g)
          for (unsigned int v = 0; v < n_vertices; ++v)
            for (unsigned int c = 0; c < dim; ++c)
              {
                double H[dim][dim] = {};
                for (unsigned int d = 0; d < dim; ++d)
                  H[c][d] = shape_gradients[g][v][d];
                double strain[n];
                strain_of(H, centre_gradients[v][c], element.share, strain);
                double sum = 0.;
                for (unsigned int a = 0; a < n; ++a)
                  for (unsigned int b = 0; b < n; ++b)
                    sum += strain[a] * element.D[g][a][b] * strain[b];
                f[dim * (element.node + vertex_offsets[v]) + c] += sum;
              }
    }


    template <int dim>
    std::unique_ptr<ElementTangents<dim>>
    make_element_tangents(const PointMotion<dim>    &motion,
                          const BackgroundGrid<dim> &grid)
    {
      if (motion.has_mean_dilatation())
        return std::make_unique<Q1Tangents<dim, dim == 2 ? 4 : 6, true>>(
          grid, motion.b_bar_cells());
      return std::make_unique<Q1Tangents<dim, dim *(dim + 1) / 2, false>>(
        grid, motion.b_bar_cells());
    }
  } // namespace


  template <int dim>
  DoubleMappedTangent<dim>::DoubleMappedTangent(const Weights<dim> &weights)
    : weights(&weights)
  {}


  template <int dim>
  DoubleMappedTangent<dim>::~DoubleMappedTangent() = default;


  template <int dim>
  void
  DoubleMappedTangent<dim>::reinit(const StressUpdate<dim>   &stress_update,
                                   const MaterialPoints<dim> &points)
  {
    if (!elements)
      elements = make_element_tangents(stress_update.point_motion(),
                                       weights->background_grid());
    symmetric = stress_update.has_symmetric_tangents();
    stress_update.material_tangents(points, material_tangents);
    elements->reinit(material_tangents, *weights, points);
  }


  template <int dim>
  void
  DoubleMappedTangent<dim>::vmult(NodalVector       &dst,
                                  const NodalVector &src) const
  {
    dst = 0.;
    elements->vmult_add(src.begin(), dst.begin());
  }


  template <int dim>
  void
  DoubleMappedTangent<dim>::add_diagonal(NodalVector &diagonal) const
  {
    elements->add_diagonal(diagonal.begin());
  }


  template class DoubleMappedTangent<2>;
  template class DoubleMappedTangent<3>;
} // namespace Waker
