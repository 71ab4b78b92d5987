// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_body_h
#define waker_particles_body_h

#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>

#include <functional>
#include <memory>
#include <utility>

namespace Waker
{
  /**
   * The points of a body, for those who look at all of it. On one rank these
   * are points, and no more. On several ranks each has some of them, and what
   * is a sum over points, or the largest of something, is found by each for its
   * own; who needs to see all of their places asks for whole(), which the ranks
   * then have to tell each other.
   *
   * All functions but own() are collective.
   */
  template <int dim>
  class Body
  {
  public:
    /// On one rank. Not explicit: points are a body.
    Body(const MaterialPoints<dim> &points)
      : own_points(&points)
    {}

    /// @param window of the rank, on the grid
    /// @param fetch gives the whole body, whose points know their places
    Body(const MaterialPoints<dim>                   &own,
         std::shared_ptr<const BackgroundGrid<dim>>   window,
         std::function<const MaterialPoints<dim> &()> fetch)
      : own_points(&own)
      , own_window(std::move(window))
      , fetch(std::move(fetch))
    {}

    /// Those of this rank.
    const MaterialPoints<dim> &
    own() const
    {
      return *own_points;
    }

    /// All of them: position, velocity, half_size, volume; where they began,
    /// and what sliding masses look at.
    const MaterialPoints<dim> &
    whole() const
    {
      return own_window == nullptr ? *own_points : fetch();
    }

    /// The nodes that the own points reach; null on one rank, where these are
    /// all.
    const std::shared_ptr<const BackgroundGrid<dim>> &
    window() const
    {
      return own_window;
    }

    void
    sum(double *const numbers, const unsigned int n) const
    {
      if (own_window != nullptr)
        own_window->exchange().sum(numbers, n);
    }

    double
    largest(const double number) const
    {
      return own_window != nullptr ? own_window->exchange().largest(number)
                                   : number;
    }

  private:
    const MaterialPoints<dim>                   *own_points;
    std::shared_ptr<const BackgroundGrid<dim>>   own_window;
    std::function<const MaterialPoints<dim> &()> fetch;
  };
} // namespace Waker

#endif
