// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/measures/moving_body.h>
#include <waker/measures/two_means.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Waker
{
  namespace
  {
    /// Further than this many distances is as far as this.
    constexpr double far_away = 5.;


    /// Numbers the connected bodies of marked cells; 0 is no body.
    template <int dim>
    class CellBodies
    {
    public:
      CellBodies(const BackgroundGrid<dim> &grid,
                 const std::vector<bool>   &marked)
        : numbers(grid.n_nodes(), 0)
      {
        std::vector<unsigned int> open;
        for (unsigned int start = 0; start < marked.size(); ++start)
          if (marked[start] && numbers[start] == 0)
            {
              ++n_bodies;
              numbers[start] = n_bodies;
              open.push_back(start);
              while (!open.empty())
                {
                  const unsigned int cell = open.back();
                  open.pop_back();
                  const auto index = grid.node_index(cell);
                  for (unsigned int d = 0; d < dim; ++d)
                    for (const int step : {-1, 1})
                      {
                        const int next = index[d] + step;
                        if (next < 0 ||
                            next >=
                              static_cast<int>(grid.n_nodes_per_direction()[d]))
                          continue;
                        const unsigned int neighbour =
                          cell + step * static_cast<int>(grid.stride(d));
                        if (marked[neighbour] && numbers[neighbour] == 0)
                          {
                            numbers[neighbour] = n_bodies;
                            open.push_back(neighbour);
                          }
                      }
                }
            }
      }

      unsigned int
      of_cell(const unsigned int cell) const
      {
        return numbers[cell];
      }

      unsigned int
      n() const
      {
        return n_bodies;
      }

    private:
      std::vector<unsigned int> numbers; // by cell
      unsigned int              n_bodies = 0;
    };


    /// Volume, and length along z (m), of points as they lay at t = 0.
    template <int dim>
    struct Extent
    {
      double volume = 0.;
      double first  = std::numeric_limits<double>::max();
      double last   = std::numeric_limits<double>::lowest();

      void
      add(const MaterialPoints<dim> &points, const std::size_t q)
      {
        volume += points.volume[q];
        if constexpr (dim == 3)
          {
            const double z    = points.initial_position[q][2];
            const double half = points.half_size[q][2];
            first             = std::min(first, z - half);
            last              = std::max(last, z + half);
          }
      }

      double
      area() const
      {
        return dim == 2 ? volume : volume > 0. ? volume / (last - first) : 0.;
      }
    };


    /**
     * The quick answer of nearly every step: false only if no body of the share
     * s of the volume V is a distance d further than the rest. Let B be such a
     * body, with displacements u (as far as they count) and the volume V_B >=
     * s V. The rest has not moved backwards, so the mean of u in B is above d,
     * and some u is. Whatever else B is made of, for any c < d, here d/2,
     *
     *   sum_all V_q max(u_q - c, 0) >= sum_B V_q (u_q - c)
     *                               >= V_B (d - c) >= s V (d - c).
     *
     * (That all of B has moved by d/2 would not follow: the border of two means
     * lies half way between them, but the mean above it is that of all bodies,
     * and less than that of the one that has moved furthest.)
     */
    template <int dim>
    bool
    may_have_moved(const Body<dim> &body,
                   const int        direction,
                   const double     distance,
                   const double     least_share)
    {
      const MaterialPoints<dim> &points  = body.own();
      const double               square  = distance * distance;
      const double               half    = 0.5 * distance;
      double                     largest = 0., volume = 0., moved = 0.;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        {
          const Tensor<1, dim> u =
            points.position[q] - points.initial_position[q];
          const double norm = direction * u[0] > 0. ? u.norm_square() : 0.;
          volume += points.volume[q];
          if (norm > half * half)
            moved += points.volume[q] *
                     (std::min(std::sqrt(norm), far_away * distance) - half);
          largest = std::max(largest, norm);
        }
      double sums[] = {volume, moved};
      body.sum(sums, 2);
      volume  = sums[0];
      moved   = sums[1];
      largest = body.largest(largest);
      // In space a small part of the whole may be a large cross-section. The
      // sums are rounded.
      return largest > square &&
             (dim == 3 || moved >= least_share * volume * half * (1. - 1e-9));
    }


    /// Where the body ends on the crest, seen from what remains of it.
    template <int dim>
    double
    find_crest_cut(const MaterialPoints<dim> &points,
                   const double               cell_size,
                   const int                  direction,
                   const std::vector<bool>   &in_body)
    {
      double top = std::numeric_limits<double>::lowest();
      for (std::size_t q = 0; q < points.n_points(); ++q)
        top =
          std::max(top, points.initial_position[q][1] + points.half_size[q][1]);
      double cut = nan;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        if (in_body[q] && points.initial_position[q][1] > top - cell_size)
          {
            const double end = points.initial_position[q][0] -
                               direction * points.half_size[q][0];
            if (std::isnan(cut) || direction * (end - cut) < 0.)
              cut = end;
          }
      return cut;
    }
  } // namespace


  template <int dim>
  MovingBody
  largest_moving_body(const std::common_type_t<Body<dim>> &body,
                      const BackgroundGrid<dim>           &grid,
                      const int                            direction,
                      const double                         distance,
                      const double                         least_share)
  {
    if (!may_have_moved(body, direction, distance, least_share))
      return {};
    const MaterialPoints<dim> &points = body.whole();

    const std::size_t   n = points.n_points();
    std::vector<double> displacement(n);
    Extent<dim>         profile;
    for (std::size_t q = 0; q < n; ++q)
      {
        const Tensor<1, dim> u =
          points.position[q] - points.initial_position[q];
        displacement[q] =
          direction * u[0] > 0. ? std::min(u.norm(), far_away * distance) : 0.;
        profile.add(points, q);
      }
    const TwoMeans split   = two_means(displacement, points.volume);
    const auto     cell_of = [&](const std::size_t q) {
      return grid.node(grid.cell_index(points.initial_position[q]));
    };
    std::vector<bool> marked(grid.n_nodes(), false);
    for (std::size_t q = 0; q < n; ++q)
      if (displacement[q] >= split.threshold)
        marked[cell_of(q)] = true;
    const CellBodies<dim>    bodies(grid, marked);
    std::vector<Extent<dim>> extents(bodies.n() + 1);
    std::vector<double>      moved(bodies.n() + 1, 0.);
    for (std::size_t q = 0; q < n; ++q)
      if (displacement[q] >= split.threshold)
        {
          const unsigned int b = bodies.of_cell(cell_of(q));
          extents[b].add(points, q);
          moved[b] += points.volume[q] * displacement[q];
        }

    unsigned int largest = 0;
    for (unsigned int b = 1; b <= bodies.n(); ++b)
      if (extents[b].volume > extents[largest].volume)
        largest = b;
    if (largest == 0)
      return {};
    MovingBody slide;
    slide.area  = extents[largest].area();
    slide.share = slide.area / profile.area();
    slide.distance =
      moved[largest] / extents[largest].volume - split.lower_mean;
    std::vector<bool> in_body(n);
    for (std::size_t q = 0; q < n; ++q)
      in_body[q] = displacement[q] >= split.threshold &&
                   bodies.of_cell(cell_of(q)) == largest;
    slide.crest_cut =
      find_crest_cut(points, grid.cell_size(), direction, in_body);
    return slide;
  }


  template MovingBody
  largest_moving_body(const Body<2> &,
                      const BackgroundGrid<2> &,
                      const int,
                      const double,
                      const double);
  template MovingBody
  largest_moving_body(const Body<3> &,
                      const BackgroundGrid<3> &,
                      const int,
                      const double,
                      const double);
} // namespace Waker
