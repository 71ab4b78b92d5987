// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_body_h
#define waker_particles_body_h

#include <waker/grid/node_exchange.h>
#include <waker/particles/material_points.h>

#include <functional>
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

    /// @param fetch gives the whole body, whose points know their places
    Body(const MaterialPoints<dim>                   &own,
         const NodeExchange                          &ranks,
         std::function<const MaterialPoints<dim> &()> fetch)
      : own_points(&own)
      , ranks(&ranks)
      , fetch(std::move(fetch))
    {}

    /// Those of this rank.
    const MaterialPoints<dim> &
    own() const
    {
      return *own_points;
    }

    /// All of them: position, velocity, half_size, volume, and what never
    /// changes.
    const MaterialPoints<dim> &
    whole() const
    {
      return ranks == nullptr ? *own_points : fetch();
    }

    void
    sum(double *const numbers, const unsigned int n) const
    {
      if (ranks != nullptr)
        ranks->sum(numbers, n);
    }

    double
    largest(const double number) const
    {
      return ranks != nullptr ? ranks->largest(number) : number;
    }

  private:
    const MaterialPoints<dim>                   *own_points;
    const NodeExchange                          *ranks = nullptr;
    std::function<const MaterialPoints<dim> &()> fetch;
  };
} // namespace Waker

#endif
