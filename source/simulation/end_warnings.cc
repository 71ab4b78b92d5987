// SPDX-License-Identifier: LGPL-2.1-or-later
#include "end_warnings.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace Waker
{
  namespace
  {
    /// What keeps a dyke moving may be the method: work goes in that comes out
    /// as mapping loss. "" if it is not that.
    template <int dim>
    std::string
    energy_from_the_mapping(const State<dim> &state,
                            const Parameters &parameters,
                            const Outcome     outcome)
    {
      const EnergyAccount &e    = state.energy;
      const double         work = std::abs(e.gravity_work + e.load_work);
      if (outcome != Outcome::still_moving ||
          !(std::abs(e.mapping_loss) > 0.5 * work))
        return "";
      std::ostringstream text;
      text.precision(3);
      text << "Time stepping/Time step: the dyke still moves, and the mapping "
              "loss of "
           << e.mapping_loss
           << " kJ is more than half of the work of weight and loads, " << work
           << " kJ: try a smaller time step";
      if (parameters.water.stands() &&
          parameters.surface.method != SurfaceMethod::contour)
        text << ", or Surface/Method = contour if only a little soil moves "
                "under the water";
      return text.str();
    }


    /// A load that points carry may leave with them.
    template <int dim>
    void
    warn_of_lost_loads(const LoadProgrammes<dim> &programmes,
                       const std::vector<double> &shares,
                       Log                       &log)
    {
      for (std::size_t i = 0; i < shares.size(); ++i)
        {
          const double lost = shares[i];
          if (lost < 1e-3)
            continue;
          std::ostringstream text;
          text.precision(3);
          text << "load " << programmes.names()[i].name << ": " << 100. * lost
               << " % of it has left the grid with the soil that carried it; "
                  "its factor counts all of it";
          log.warning(text.str());
        }
    }


    template <int dim>
    void
    warn_of_idle_walls(const Case<dim>  &the_case,
                       const Scene<dim> &scene,
                       Log              &log)
    {
      const std::vector<unsigned int> now = scene.walls.idle();
      for (const unsigned int w : the_case.idle_walls)
        if (std::find(now.begin(), now.end(), w) != now.end())
          log.warning("Walls/" + the_case.parameters.walls[w].name +
                      ": no soil touched it at the start, nor does any at the "
                      "end: it may have held nothing");
    }
  } // namespace


  template <int dim>
  void
  warn_at_end(const StepView<dim> &view, const Outcome outcome, Log &log)
  {
    const std::string pumped =
      energy_from_the_mapping(view.state, view.the_case.parameters, outcome);
    if (!pumped.empty())
      log.warning(pumped);
    warn_of_lost_loads(view.the_case.programmes, view.totals.lost_loads, log);
    warn_of_idle_walls(view.the_case, view.scene, log);
  }


  template void
  warn_at_end(const StepView<2> &, const Outcome, Log &);
  template void
  warn_at_end(const StepView<3> &, const Outcome, Log &);
} // namespace Waker
