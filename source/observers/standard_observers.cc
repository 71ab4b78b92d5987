// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/measures/watched.h>
#include <waker/observers/observer.h>

#include <string>

namespace Waker
{
  namespace
  {
    const char axis[] = {'x', 'y', 'z'};


    template <int dim>
    class NewtonObserver : public Observer<dim>
    {
    public:
      void
      observe(const StepView<dim> &view, Row &row) override
      {
        row.add("Time step (s)", view.state.last_dt);
        row.add("Newton iterations", view.report.newton_iterations);
        row.add("Linear iterations", view.report.linear_iterations);
        row.add("Residual",
                view.report.residuals.empty() ? 0.
                                              : view.report.residuals.back());
        row.add("Unconverged steps so far", view.state.unconverged_steps);
      }
    };


    template <int dim>
    class DykeObserver : public Observer<dim>
    {
    public:
      void
      observe(const StepView<dim> &view, Row &row) override
      {
        const DykeGeometry &dyke = view.state.failure.geometry;
        row.add("Dyke height H (m)", dyke.height);
        row.add("Dyke width W (m)", dyke.width);
        row.add("Parts at the water level", dyke.parts.size());
        if (!view.the_case.sections.empty())
          {
            row.add("z of H (m)", dyke.height_z);
            row.add("z of W (m)", dyke.width_z);
          }
        row.add("Mean plastic strain increment",
                view.report.mean_plastic_strain);
        row.add("Displacement rate, rms (m/s)", view.report.displacement_rate);
      }
    };


    template <int dim>
    class EnergyObserver : public Observer<dim>
    {
    public:
      void
      observe(const StepView<dim> &view, Row &row) override
      {
        const EnergyAccount &e = view.state.energy;
        row.add("Kinetic energy (kJ)", e.kinetic);
        row.add("Elastic energy (kJ)", e.elastic);
        row.add("Plastic dissipation (kJ)", e.dissipation);
        row.add("Potential energy released (kJ)", e.gravity_work);
        row.add("Work of the water (kJ)", e.load_work);
        row.add("Work of the supports (kJ)", e.support_work);
        row.add("Work withheld by the ramp (kJ)", e.ramp_work);
        row.add("Mapping loss (kJ)", e.mapping_loss);
        row.add("Energy remainder (kJ)", e.remainder());
      }
    };


    template <int dim>
    class ForceObserver : public Observer<dim>
    {
    public:
      ForceObserver()
      {
        for (unsigned int d = 0; d < dim; ++d)
          {
            names[0][d] = std::string("Momentum ") + axis[d] + " (kN s)";
            names[1][d] = std::string("Reaction ") + axis[d] + " (kN)";
            names[2][d] = std::string("Water force ") + axis[d] + " (kN)";
          }
      }

      void
      observe(const StepView<dim> &view, Row &row) override
      {
        const Tensor<1, dim> &p = view.totals.momentum;
        for (unsigned int d = 0; d < dim; ++d)
          row.add(names[0][d], p[d]);
        // Of a step: there has been none at the start.
        const bool known = view.state.step > 0;
        for (unsigned int d = 0; d < dim; ++d)
          row.add(names[1][d], known ? view.report.reaction[d] : nan);
        for (unsigned int d = 0; d < 2; ++d)
          row.add(names[2][d], view.scene.water_resultant.force[d]);
      }

    private:
      std::string names[3][dim];
    };


    /// Slides, and what they have left; no columns if nobody watches them.
    template <int dim>
    class SlidingObserver : public Observer<dim>
    {
    public:
      void
      observe(const StepView<dim> &view, Row &row) override
      {
        if (!view.the_case.parameters.sliding.watch)
          return;
        const SlidingMasses &sliding = view.state.sliding;
        row.add("Sliding masses", sliding.masses.size());
        row.add("Relative failure volume", sliding.relative_failure_volume());
        row.add("Largest displacement of stable soil (m)",
                sliding.largest_displacement);
        row.add("Retrogression distance (m)", sliding.retrogression);
        if (dim == 3)
          row.add("Damaged crest width (m)", sliding.damaged_crest_width);
      }
    };


    /// Forces of the walls off the grid on the soil, and what sliding along
    /// them takes; no columns without walls.
    template <int dim>
    class WallObserver : public Observer<dim>
    {
    public:
      void
      observe(const StepView<dim> &view, Row &row) override
      {
        const std::vector<std::string> &names = view.scene.walls.names();
        for (unsigned int w = 0; w < names.size(); ++w)
          {
            const Tensor<1, dim> force =
              view.scene.walls.force(w, view.state.wall_tractions);
            for (unsigned int d = 0; d < dim; ++d)
              row.add("Wall " + names[w] + " " + axis[d] + " (kN)", force[d]);
          }
        if (view.scene.walls.have_friction())
          row.add("Friction on walls (kJ)", view.state.energy.friction);
      }
    };


    /// What the tractions put on the soil; no columns without tractions.
    template <int dim>
    class TractionObserver : public Observer<dim>
    {
    public:
      void
      observe(const StepView<dim> &view, Row &row) override
      {
        const Tractions<dim> &tractions = view.scene.tractions;
        for (std::size_t i = 0; i < tractions.size(); ++i)
          {
            const auto        resultant = tractions.resultant(i);
            const std::string name      = "Traction " + tractions.view(i).name;
            for (unsigned int d = 0; d < dim; ++d)
              row.add(name + " " + axis[d] + " (kN)", resultant.force[d]);
            row.add(name + (dim == 2 ? " length (m)" : " area (m^2)"),
                    resultant.measure);
          }
      }
    };


    /// What load programmes do, and what most of them watch; no columns
    /// without.
    template <int dim>
    class LoadObserver : public Observer<dim>
    {
    public:
      void
      observe(const StepView<dim> &view, Row &row) override
      {
        const State<dim>            &state = view.state;
        const std::vector<LoadName> &names = view.the_case.programmes.names();
        for (std::size_t i = 0; i < names.size(); ++i)
          {
            const LoadRecord &load = state.loads[i];
            const std::string name = "Load " + names[i].name;
            row.add(name + " (" + names[i].unit + ")", load.factor);
            row.add(name + " held", load.held);
            row.add(name + " stopped", load.is_stopped());
          }
        if (names.empty())
          return;
        row.add("Largest settlement (m)", view.totals.settlement);
        row.add("Largest settlement rate (m/s)", state.settlement_rate);
      }
    };


    /// Mass and momentum of a body with open faces; no columns without.
    template <int dim>
    class FlowObserver : public Observer<dim>
    {
    public:
      FlowObserver()
      {
        for (unsigned int d = 0; d < dim; ++d)
          {
            const std::string unit = std::string(1, axis[d]) + " (kN s)";
            names[0][d]            = "Momentum in " + unit;
            names[1][d]            = "Momentum out " + unit;
            names[2][d]            = "Impulse " + unit;
            names[3][d]            = "Momentum remainder " + unit;
          }
      }

      void
      observe(const StepView<dim> &view, Row &row) override
      {
        if (!view.the_case.flow.is_used())
          return;
        const FlowAccount<dim> &flow = view.state.flow;
        const double            mass = view.totals.mass;
        row.add("Points", view.state.points.n_points());
        row.add("Mass (Mg)", mass);
        row.add("Mass in (Mg)", flow.mass_in);
        row.add("Mass out (Mg)", flow.mass_out);
        row.add("Mass remainder (Mg)",
                mass - flow.mass_start - flow.mass_in + flow.mass_out);
        const Tensor<1, dim> &p         = view.totals.momentum;
        const Tensor<1, dim>  remainder = p - flow.momentum_start -
                                         flow.impulse - flow.momentum_in +
                                         flow.momentum_out;
        for (unsigned int d = 0; d < dim; ++d)
          row.add(names[0][d], flow.momentum_in[d]);
        for (unsigned int d = 0; d < dim; ++d)
          row.add(names[1][d], flow.momentum_out[d]);
        for (unsigned int d = 0; d < dim; ++d)
          row.add(names[2][d], flow.impulse[d]);
        for (unsigned int d = 0; d < dim; ++d)
          row.add(names[3][d], remainder[d]);
        row.add("Energy in (kJ)", view.state.energy.inflow);
        row.add("Energy out (kJ)", view.state.energy.outflow);
      }

    private:
      std::string names[4][dim];
    };
  } // namespace


  template <int dim>
  std::vector<std::unique_ptr<Observer<dim>>>
  standard_observers()
  {
    std::vector<std::unique_ptr<Observer<dim>>> observers;
    observers.push_back(std::make_unique<NewtonObserver<dim>>());
    observers.push_back(std::make_unique<DykeObserver<dim>>());
    observers.push_back(std::make_unique<EnergyObserver<dim>>());
    observers.push_back(std::make_unique<ForceObserver<dim>>());
    observers.push_back(std::make_unique<SlidingObserver<dim>>());
    observers.push_back(std::make_unique<WallObserver<dim>>());
    observers.push_back(std::make_unique<TractionObserver<dim>>());
    observers.push_back(std::make_unique<LoadObserver<dim>>());
    observers.push_back(std::make_unique<FlowObserver<dim>>());
    return observers;
  }


  template std::vector<std::unique_ptr<Observer<2>>>
  standard_observers();
  template std::vector<std::unique_ptr<Observer<3>>>
  standard_observers();
} // namespace Waker
