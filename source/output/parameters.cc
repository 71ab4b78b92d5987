// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/output/parameters.h>

namespace Waker
{
  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Directory",
                      directory,
                      "Folder that the run writes; made if it is not there. "
                      "One that holds files already needs --overwrite or "
                      "--resume.",
                      Patterns::Anything());
    prm.add_parameter("Interval",
                      interval,
                      "Simulated time between ParaView files (s). 0: only the "
                      "first and the last state.",
                      Patterns::Double(0.));
    prm.add_parameter("Particles",
                      particles,
                      "Write particles.pvd: the material points.",
                      Patterns::Bool());
    prm.add_parameter(
      "Surface",
      surface,
      "Write surface.pvd: the detected surface; with tractions, "
      "tractions.pvd: what they load.",
      Patterns::Bool());
    prm.add_parameter("Grid",
                      grid,
                      "Write grid.pvd: the background grid.",
                      Patterns::Bool());
    prm.add_parameter(
      "Top view",
      top_view,
      "Write top_view.pvd: the ground as seen from above, two by two squares "
      "a cell of the grid, each with the fields of the point that lies "
      "highest there; in 3D also ground_lines.pvd: where the crest ends, "
      "scarps, and the outline of what has moved.",
      Patterns::Bool());
    prm.add_parameter("Checkpoint interval",
                      checkpoint_interval,
                      "Simulated time between checkpoints (s). 0: only when "
                      "the run is interrupted.",
                      Patterns::Double(0.));
  }


  void
  OutputParameters::check() const
  {
    if (directory.empty())
      throw UserError("Output/Directory", "is empty", "the name of a folder");
    if (!(interval >= 0.))
      throw UserError("Output/Interval",
                      "is " + in_digits(interval) + " s",
                      "0 or a positive time");
    if (!(checkpoint_interval >= 0.))
      throw UserError("Output/Checkpoint interval",
                      "is " + in_digits(checkpoint_interval) + " s",
                      "0 or a positive time");
  }
} // namespace Waker
