// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/double_mapped_tangent.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Indices (i, j) of the independent stresses, as in Kinematics.
    template <int dim>
    std::array<std::array<unsigned int, 2>, dim *(dim + 1) / 2>
    stress_indices()
    {
      if constexpr (dim == 2)
        return {{{{0, 0}}, {{1, 1}}, {{0, 1}}}};
      else
        return {{{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{0, 2}}, {{1, 2}}}};
    }


    /// From the gradient of a vector to engineering strains.
    template <int dim>
    void
    engineering_strain(const double (&H)[dim][dim],
                       double (&e)[dim * (dim + 1) / 2])
    {
      const auto indices = stress_indices<dim>();
      for (unsigned int a = 0; a < indices.size(); ++a)
        {
          const unsigned int i = indices[a][0], j = indices[a][1];
          e[a] = i == j ? H[i][i] : H[i][j] + H[j][i];
        }
    }
  } // namespace


  template <int dim>
  DoubleMappedTangent<dim>::DoubleMappedTangent(const Weights<dim> &weights)
    : weights(&weights)
    , element_of_cell(weights.background_grid().n_nodes(), -1)
  {
    const auto  &grid  = weights.background_grid();
    const double xi[2] = {0.5 - 0.5 / std::sqrt(3.), 0.5 + 0.5 / std::sqrt(3.)};
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        vertex_offsets[v] = 0;
        for (unsigned int d = 0; d < dim; ++d)
          vertex_offsets[v] += (v >> d & 1) * grid.stride(d);
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


  template <int dim>
  void
  DoubleMappedTangent<dim>::reinit(const StressUpdate<dim>   &stress_update,
                                   const MaterialPoints<dim> &points)
  {
    const auto  &grid = weights->background_grid();
    const double h    = grid.cell_size();
    stress_update.material_tangents(points, material_tangents);
    for (const Element &element : elements)
      element_of_cell[element.node] = -1;
    elements.clear();

    const auto indices = stress_indices<dim>();
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const PointWeights<dim> &w = (*weights)[p];
        double                   D[n_stresses][n_stresses];
        for (unsigned int a = 0; a < n_stresses; ++a)
          for (unsigned int b = 0; b < n_stresses; ++b)
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
                elements.back().node = node;
                std::fill_n(&elements.back().D[0][0][0],
                            n_gauss * n_stresses * n_stresses,
                            0.);
              }
            Element &element = elements[number];
            for (unsigned int v = 0; v < n_vertices; ++v)
              {
                double share = 1.;
                for (unsigned int d = 0; d < dim; ++d)
                  share *= part[d][cell >> d & 1][v >> d & 1];
                for (unsigned int a = 0; a < n_stresses; ++a)
                  for (unsigned int b = 0; b < n_stresses; ++b)
                    element.D[v][a][b] += share * D[a][b];
              }
          }
      }

    // Nodes to Gauss points. D_i carries n / V_e, a Gauss weight V_e / n: they
    // cancel.
    for (Element &element : elements)
      for (unsigned int a = 0; a < n_stresses; ++a)
        for (unsigned int b = 0; b < n_stresses; ++b)
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


  template <int dim>
  void
  DoubleMappedTangent<dim>::vmult(NodalVector       &dst,
                                  const NodalVector &src) const
  {
    const auto          indices = stress_indices<dim>();
    const double *const u       = src.begin();
    dst                         = 0.;
    double *const f             = dst.begin();
    for (const Element &element : elements)
      for (unsigned int g = 0; g < n_gauss; ++g)
        {
          double H[dim][dim] = {};
          for (unsigned int v = 0; v < n_vertices; ++v)
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                H[c][d] += u[dim * (element.node + vertex_offsets[v]) + c] *
                           shape_gradients[g][v][d];
          double strain[n_stresses];
          engineering_strain<dim>(H, strain);
          double P[dim][dim];
          for (unsigned int a = 0; a < n_stresses; ++a)
            {
              double s = 0.;
              for (unsigned int b = 0; b < n_stresses; ++b)
                s += element.D[g][a][b] * strain[b];
              P[indices[a][0]][indices[a][1]] = s;
              P[indices[a][1]][indices[a][0]] = s;
            }
          for (unsigned int v = 0; v < n_vertices; ++v)
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                f[dim * (element.node + vertex_offsets[v]) + c] +=
                  P[c][d] * shape_gradients[g][v][d];
        }
  }


  template <int dim>
  void
  DoubleMappedTangent<dim>::add_diagonal(NodalVector &diagonal) const
  {
    double *const f = diagonal.begin();
    for (const Element &element : elements)
      for (unsigned int g = 0; g < n_gauss; ++g)
        for (unsigned int v = 0; v < n_vertices; ++v)
          for (unsigned int c = 0; c < dim; ++c)
            {
              double H[dim][dim] = {};
              for (unsigned int d = 0; d < dim; ++d)
                H[c][d] = shape_gradients[g][v][d];
              double strain[n_stresses];
              engineering_strain<dim>(H, strain);
              double sum = 0.;
              for (unsigned int a = 0; a < n_stresses; ++a)
                for (unsigned int b = 0; b < n_stresses; ++b)
                  sum += strain[a] * element.D[g][a][b] * strain[b];
              f[dim * (element.node + vertex_offsets[v]) + c] += sum;
            }
  }


  template class DoubleMappedTangent<2>;
  template class DoubleMappedTangent<3>;
} // namespace Waker
