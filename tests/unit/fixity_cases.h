// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_fixity_cases_h
#define waker_tests_fixity_cases_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/fixity_conflicts.h>

#include "named.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

/// Boundary conditions on a small grid.
namespace FixityCases
{
  using namespace Waker;

  /// 4 x 3 cells of 0.5 m: nodes 7 x 6 with the margin.
  inline BackgroundGrid<2>
  small_grid()
  {
    return BackgroundGrid<2>(Point<2>(1., 0.),
                             Point<2>(3., 1.5),
                             0.5,
                             MPI_COMM_SELF);
  }


  inline FixityParameters
  fixity(const std::string &region,
         const std::string &type         = "fixed",
         const std::string &displacement = "")
  {
    FixityParameters f;
    f.name         = "base";
    f.region       = Named{region};
    f.type         = Named{type};
    f.displacement = displacement;
    return f;
  }


  /// The path of the error that these conditions cause, "" if none.
  template <int dim>
  inline std::string
  where_it_fails(const BackgroundGrid<dim> &grid, const FixityParameters &f)
  {
    try
      {
        const Fixities<dim> fixities(grid, {f});
      }
    catch (const UserError &e)
      {
        return e.where;
      }
    return "";
  }
} // namespace FixityCases

#endif
