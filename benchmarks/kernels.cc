// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The parts of a step, each alone, on a dyke in motion at the first guess of
// Newton's method.
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_gmres.h>

#include <waker/case/scene.h>
#include <waker/mapping/transfer.h>
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/double_mapped_tangent.h>
#include <waker/mechanics/soil.h>
#include <waker/mechanics/system_operator.h>

#include "dyke.h"
#include <functional>
#include <string>
#include <type_traits>

namespace WakerBenchmarks
{
  namespace
  {
    /// The moment at which the parts are timed.
    template <int dim>
    struct Moment
    {
      explicit Moment(const Size size)
        : dyke(WakerBenchmarks::dyke<dim>(size, Motion::moving))
        , the_case(*dyke.the_case)
        , points(dyke.state.points)
        , scene(the_case)
        , stress_update(the_case.materials,
                        make_point_motion<dim>(the_case.parameters.mapping))
        , dt(dyke.time_step)
      {
        scene.set(points);
        NodalState &nodes = scene.nodes;
        nodes.increment.equ(dt, nodes.velocity);
        nodes.increment.add(0.5 * dt * dt, nodes.acceleration);
        for (const unsigned int dof : the_case.fixities.removed_list())
          nodes.increment.begin()[dof] = 0.;
        stress_update.begin(points, scene.weights);
        stress_update.evaluate(points,
                               scene.weights,
                               nodes.increment,
                               nodes.internal_force);
      }

      const Dyke<dim>    &dyke;
      const Case<dim>    &the_case;
      MaterialPoints<dim> points;
      Scene<dim>          scene;
      StressUpdate<dim>   stress_update;
      double              dt;
    };


    template <int dim>
    void
    time_weights(benchmark::State &timer, Moment<dim> &m)
    {
      for (auto _ : timer)
        m.scene.weights.reinit(m.points);
    }


    template <int dim>
    void
    time_to_nodes(benchmark::State &timer, Moment<dim> &m)
    {
      for (auto _ : timer)
        to_nodes(m.points, m.scene.weights, m.scene.nodes);
    }


    template <int dim>
    void
    time_to_points(benchmark::State &timer, Moment<dim> &m)
    {
      // The points must stay where they are, however often this is done.
      m.scene.nodes.increment        = 0.;
      m.scene.nodes.new_acceleration = 0.;
      for (auto _ : timer)
        benchmark::DoNotOptimize(
          to_particles(m.scene.nodes, m.scene.weights, m.dt, m.points));
    }


    template <int dim>
    void
    time_stress(benchmark::State &timer, Moment<dim> &m)
    {
      m.stress_update.begin(m.points, m.scene.weights);
      for (auto _ : timer)
        m.stress_update.evaluate(m.points,
                                 m.scene.weights,
                                 m.scene.nodes.increment,
                                 m.scene.nodes.internal_force);
    }


    template <typename Tangent, int dim>
    void
    time_tangent_set_up(benchmark::State &timer, Moment<dim> &m)
    {
      Tangent tangent(m.scene.weights);
      for (auto _ : timer)
        tangent.reinit(m.stress_update, m.points);
    }


    template <typename Tangent, int dim>
    void
    time_tangent_product(benchmark::State &timer, Moment<dim> &m)
    {
      Tangent tangent(m.scene.weights);
      tangent.reinit(m.stress_update, m.points);
      NodalVector product;
      product.reinit(m.scene.nodes.velocity);
      for (auto _ : timer)
        tangent.vmult(product, m.scene.nodes.velocity);
    }


    /// deal.II's GMRES with the preconditioner of ours: why there is ours.
    class DealGmres
    {
    public:
      void
      prepare(const Operator &system, const NodalVector &b)
      {
        NodalVector &diagonal = preconditioner.get_vector();
        diagonal.reinit(b);
        system.add_diagonal(diagonal);
        for (double &entry : diagonal)
          entry = entry != 0. ? 1. / entry : 0.;
      }

      LinearReport
      solve(const Operator    &system,
            NodalVector       &x,
            const NodalVector &b,
            const double       tolerance,
            const unsigned int max_iterations)
      {
        SolverControl            control(max_iterations,
                              tolerance * b.l2_norm(),
                              false,
                              false);
        SolverGMRES<NodalVector> gmres(
          control, SolverGMRES<NodalVector>::AdditionalData(30, true));
        x = 0.;
        gmres.solve(system, x, b, preconditioner);
        return {control.last_step(), true};
      }

    private:
      DiagonalMatrix<NodalVector> preconditioner;
    };


    /// The first linear system of the step, to the accuracy of a run.
    template <typename Tangent, int dim, bool by_deal = false>
    void
    time_linear_solve(benchmark::State &timer, Moment<dim> &m)
    {
      const NewtonParameters &newton  = m.the_case.parameters.newton;
      const NodalState       &nodes   = m.scene.nodes;
      const auto             &removed = m.the_case.fixities.removed_list();

      NodalVector R, correction;
      correction.reinit(nodes.external_force);
      R = nodes.external_force;
      R -= nodes.internal_force;
      // As in NewtonSolver: less the inertia of Newmark's end of the step.
      for (unsigned int dof = 0; dof < m.the_case.grid.n_dofs(); ++dof)
        R.begin()[dof] -= nodes.mass[dof / dim] *
                          (4. / (m.dt * m.dt) * nodes.increment.begin()[dof] -
                           4. / m.dt * nodes.velocity.begin()[dof] -
                           nodes.acceleration.begin()[dof]);
      for (const unsigned int dof : removed)
        R.begin()[dof] = 0.;

      using Consistent = ConsistentTangent<dim>;
      Soil<dim> soil(m.scene.weights,
                     StressUpdate<dim>(m.the_case.materials,
                                       make_point_motion<dim>(
                                         m.the_case.parameters.mapping)),
                     std::is_same_v<Tangent, Consistent>
                       ? Waker::Tangent::consistent
                       : Waker::Tangent::double_mapping);
      soil.begin(m.points, nodes, 0., m.dt);
      NodalVector internal;
      internal.reinit(nodes.internal_force);
      soil.add_force(nodes.increment, internal);
      soil.linearise();
      const Resistances<dim> resistances = {&soil};
      ReachedNodes           reached(m.the_case.grid);
      reached.reinit(nodes.mass);
      const SystemOperator<dim> system(
        resistances, 1., 4. / (m.dt * m.dt), nodes.mass, reached, removed);
      LinearSolver ours(m.the_case.grid.n_dofs(), m.the_case.grid.exchange());
      DealGmres    deal;
      LinearReport report;
      for (auto _ : timer)
        {
          if constexpr (by_deal)
            {
              deal.prepare(system, R);
              report = deal.solve(system,
                                  correction,
                                  R,
                                  newton.linear_tolerance,
                                  newton.maximum_linear_iterations);
              continue;
            }
          ours.prepare(system);
          report = ours.solve(system,
                              correction,
                              R,
                              newton.linear_tolerance,
                              newton.maximum_linear_iterations);
        }
      timer.counters["iterations"] = report.iterations;
      if (!report.converged)
        timer.SkipWithError("the linear solver does not converge");
    }


    template <int dim>
    void
    time_detection(benchmark::State &timer, Moment<dim> &m)
    {
      for (auto _ : timer)
        {
          // The section for the observers, in space the body for the water.
          m.scene.surfaces.reset(m.points);
          m.scene.surfaces.section();
          if (dim == 3)
            m.scene.surfaces.facets();
        }
    }


    template <int dim>
    void
    time_water(benchmark::State &timer, Moment<dim> &m)
    {
      NodalVector force;
      force.reinit(m.scene.nodes.external_force);
      for (auto _ : timer)
        {
          m.scene.water.find(m.scene.surfaces, 0.);
          m.scene.water.add_nodal_forces(m.scene.nodes.mass,
                                         m.the_case.full_node_mass,
                                         force);
        }
    }
  } // namespace


  template <int dim>
  void
  register_kernels(const Size size)
  {
    using Consistent   = ConsistentTangent<dim>;
    using DoubleMapped = DoubleMappedTangent<dim>;
    using Kernel       = void (*)(benchmark::State &, Moment<dim> &);
    const std::pair<const char *, Kernel> kernels[] = {
      {"weights", time_weights<dim>},
      {"points to nodes", time_to_nodes<dim>},
      {"nodes to points", time_to_points<dim>},
      {"stress and internal force", time_stress<dim>},
      {"consistent tangent: set-up", time_tangent_set_up<Consistent, dim>},
      {"consistent tangent: product", time_tangent_product<Consistent, dim>},
      {"consistent tangent: solve", time_linear_solve<Consistent, dim>},
      {"consistent tangent: solve by deal.II",
       time_linear_solve<Consistent, dim, true>},
      {"double mapping: set-up", time_tangent_set_up<DoubleMapped, dim>},
      {"double mapping: product", time_tangent_product<DoubleMapped, dim>},
      {"double mapping: solve", time_linear_solve<DoubleMapped, dim>},
      {"surface detection", time_detection<dim>},
      {"water load", time_water<dim>}};
    for (const auto &[name, kernel] : kernels)
      benchmark::RegisterBenchmark(
        (std::string(label<dim>(size)) + "/" + name).c_str(),
        [size, kernel = kernel](benchmark::State &timer) {
          Moment<dim> moment(size);
          kernel(timer, moment);
          count_points(timer, moment.points.n_points());
        })
        ->Unit(benchmark::kMillisecond);
  }


  template void
  register_kernels<2>(const Size);
  template void
  register_kernels<3>(const Size);
} // namespace WakerBenchmarks
