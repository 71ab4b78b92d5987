// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_carried_h
#define waker_simulation_carried_h

#include <waker/case/case.h>
#include <waker/case/state.h>

namespace Waker
{
  /// What the material carries along beside its points: their support domains,
  /// if they stretch, and the vertices of surfaces and loads that ride.
  template <int dim>
  class Carried
  {
  public:
    /// @param the_case must outlive this object
    explicit Carried(const Case<dim> &the_case);

    /// After a step, of which the points have taken the stress.
    /// @param grid on several ranks the window of those who load nodes
    /// @param mass, increment of its nodes
    /// @param points whose domains move: on several ranks those of this one
    /// @return number of domains that were held at the length of a cell
    std::size_t
    move(const BackgroundGrid<dim> &grid,
         const std::vector<double> &mass,
         const NodalVector         &increment,
         MaterialPoints<dim>       &points,
         State<dim>                &state) const;

  private:
    const Case<dim> *the_case;
    bool             rides;
  };
} // namespace Waker

#endif
