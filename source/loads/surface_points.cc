// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/surface_points.h>

#include <algorithm>
#include <array>
#include <limits>

namespace Waker
{
  namespace
  {
    constexpr double far = std::numeric_limits<double>::max();

    /// What ranks tell each other of a point.
    template <int dim>
    struct Told
    {
      std::uint64_t           id;
      std::array<double, dim> position;
      std::uint32_t           rank, place;
    };


    template <int dim>
    double
    radius_of(const Facet<dim> &facet, const Point<dim> &centre)
    {
      double radius = 0.;
      for (const Point<dim> &x : facet.vertices)
        radius = std::max(radius, x.distance(centre));
      return radius;
    }


    /// From a box.
    template <int dim>
    double
    distance(const Point<dim> &x, const Point<dim> &low, const Point<dim> &high)
    {
      Tensor<1, dim> away;
      for (unsigned int d = 0; d < dim; ++d)
        away[d] = std::max({low[d] - x[d], x[d] - high[d], 0.});
      return away.norm();
    }
  } // namespace


  template <int dim>
  SurfacePoints<dim>::SurfacePoints(const BackgroundGrid<dim> &grid,
                                    const BackgroundGrid<dim> &window)
    : grid(&grid)
    , window(&window)
    , shares(grid)
    , own_shares(grid)
  {}


  template <int dim>
  void
  SurfacePoints<dim>::find(const MaterialPoints<dim>              &points,
                           const std::vector<const Facets<dim> *> &facets)
  {
    if (window->exchange().is_one_rank())
      {
        shares.sort(points.position);
        return;
      }
    balls.clear();
    for (const Facets<dim> *const list : facets)
      for (const Facet<dim> &facet : *list)
        {
          const Point<dim> centre = facet.centroid();
          balls.push_back({centre, radius_of(facet, centre), far});
        }
    own_shares.sort(points.position);
    find_radii(points);
    tell_all(points);
  }


  template <int dim>
  void
  SurfacePoints<dim>::find_radii(const MaterialPoints<dim> &points)
  {
    const NodeExchange &ranks = window->exchange();
    const auto          agree = [&]() {
      std::vector<double> nearest;
      for (const Ball &ball : balls)
        nearest.push_back(-ball.radius);
      ranks.largest(nearest.data(), nearest.size());
      for (std::size_t f = 0; f < balls.size(); ++f)
        balls[f].radius = -nearest[f];
    };
    constexpr int n_rings = 3; // where there is soil near a surface
    for (Ball &ball : balls)
      if (window->has_cell(window->nearest_cell(ball.centre)))
        if (const std::uint32_t p = own_shares.nearest(ball.centre, n_rings);
            p != PointShares<dim>::none)
          ball.radius = ball.centre.distance(points.position[p]);
    agree();
    // No soil there: each rank looks at all of its points.
    bool any_far = false;
    for (Ball &ball : balls)
      if (ball.radius == far)
        {
          any_far = true;
          for (const Point<dim> &x : points.position)
            ball.radius = std::min(ball.radius, ball.centre.distance(x));
        }
    if (any_far)
      agree();
    for (Ball &ball : balls)
      ball.radius = (1. + 1e-9) * (ball.radius + 2. * ball.facet_radius) +
                    1e-9 * grid->cell_size();
  }


  template <int dim>
  void
  SurfacePoints<dim>::tell_all(const MaterialPoints<dim> &points)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        low[d]  = far;
        high[d] = -far;
      }
    const auto stretch = [&](const Point<dim> &x) {
      for (unsigned int d = 0; d < dim; ++d)
        {
          low[d]  = std::min(low[d], x[d]);
          high[d] = std::max(high[d], x[d]);
        }
    };
    for (const Point<dim> &x : points.position)
      stretch(x);
    std::vector<bool> may_be_closest(points.n_points(), false);
    for (const Ball &ball : balls)
      if (distance(ball.centre, low, high) <= ball.radius)
        own_shares.visit_within(ball.centre,
                                ball.radius,
                                [&](const std::uint32_t p) {
                                  may_be_closest[p] = true;
                                });

    const NodeExchange &ranks = window->exchange();
    const unsigned int  rank =
      Utilities::MPI::this_mpi_process(ranks.communicator());
    std::vector<Told<dim>> told;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (may_be_closest[p])
        {
          told.push_back({points.id[p], {}, rank, std::uint32_t(p)});
          for (unsigned int d = 0; d < dim; ++d)
            told.back().position[d] = points.position[p][d];
        }
    told = ranks.all_gather(told);
    // Of two that are as close, the one with the lower id.
    std::sort(told.begin(), told.end(), [](const auto &a, const auto &b) {
      return a.id < b.id;
    });
    positions.resize(told.size());
    place.resize(told.size());
    for (unsigned int d = 0; d < dim; ++d)
      {
        low[d]  = far;
        high[d] = -far;
      }
    for (std::size_t k = 0; k < told.size(); ++k)
      {
        for (unsigned int d = 0; d < dim; ++d)
          positions[k][d] = told[k].position[d];
        place[k] = told[k].rank == rank ? told[k].place : not_here;
        if (place[k] != not_here)
          stretch(positions[k]);
      }
    shares.sort(positions);
  }


  template <int dim>
  void
  SurfacePoints<dim>::split(const Facet<dim> &facet, const Visitor &visit)
  {
    if (window->exchange().is_one_rank())
      {
        shares.split(facet, visit);
        return;
      }
    if (positions.empty())
      return; // there is no soil
    // Is any own point near enough?
    const Point<dim> centre = facet.centroid();
    const double closest = centre.distance(positions[shares.nearest(centre)]);
    const double radius  = closest + 2. * radius_of(facet, centre);
    if (distance(centre, low, high) >
        (1. + 1e-9) * radius + 1e-9 * grid->cell_size())
      return;
    shares.split(facet, [&](const Facet<dim> &piece, const std::uint32_t k) {
      if (place[k] != not_here)
        visit(piece, place[k]);
    });
  }


  template class SurfacePoints<2>;
  template class SurfacePoints<3>;
} // namespace Waker
