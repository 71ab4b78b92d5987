// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/weights.h>

#include <sstream>

namespace Waker
{
  template <int dim>
  Weights<dim>::Weights(const BackgroundGrid<dim> &grid,
                        const ShapeFunctions       functions)
    : grid(&grid)
    , shape_functions(functions)
  {}


  template <int dim>
  void
  Weights<dim>::reinit(const MaterialPoints<dim> &points)
  {
    const std::size_t n = points.n_points();
    weights.resize(n);
    const double         inverse_h = grid->inverse_cell_size();
    const Point<dim>     origin    = grid->lattice_origin();
    const auto          &offset    = grid->offset(); // of a window
    const bool           gimp      = shape_functions == ShapeFunctions::gimp;
    std::array<int, dim> last_base; // a stencil must end on the grid
    for (unsigned int d = 0; d < dim; ++d)
      last_base[d] =
        offset[d] + static_cast<int>(grid->n_nodes_per_direction()[d]) - 3;

    for (std::size_t p = 0; p < n; ++p)
      {
        PointWeights<dim> &w = weights[p];
        w.base               = 0;
        bool inside          = true;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double x = points.position[p][d] - origin[d];
            // False also for a position that is not a number, which must not
            // become a node's number.
            if (!(x >= offset[d] * grid->cell_size() &&
                  x <= (last_base[d] + 2) * grid->cell_size()))
              {
                inside = false;
                continue;
              }
            Weights1D w1 =
              gimp ? gimp_weights(x, points.half_size[p][d], inverse_h)
                   : linear_weights(x, inverse_h);
            // In the last cell the third node would be off the grid: move the
            // stencil one node down, its unused entry to the front.
            if (w1.base == last_base[d] + 1 && w1.value[2] == 0.)
              {
                w1.base -= 1;
                for (unsigned int i = 2; i > 0; --i)
                  {
                    w1.value[i]    = w1.value[i - 1];
                    w1.gradient[i] = w1.gradient[i - 1];
                  }
                w1.value[0] = w1.gradient[0] = 0.;
              }
            if (w1.base < offset[d] || w1.base > last_base[d])
              {
                inside = false;
                continue;
              }
            w.base +=
              static_cast<unsigned int>(w1.base - offset[d]) * grid->stride(d);
            for (unsigned int i = 0; i < 3; ++i)
              {
                w.value[d][i]    = w1.value[i];
                w.gradient[d][i] = w1.gradient[i];
              }
          }
        if (!inside)
          {
            std::ostringstream message;
            message << "material point " << points.id[p]
                    << " left the background grid at (" << points.position[p]
                    << ") m";
            throw NumericalFailure(message.str());
          }
      }
  }


  template class Weights<2>;
  template class Weights<3>;
} // namespace Waker
