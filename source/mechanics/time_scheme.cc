// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/choice.h>
#include <waker/base/errors.h>
#include <waker/base/last_change.h>
#include <waker/base/text.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace Waker
{
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_time_scheme(const SchemeInput<dim> &input)
  {
    switch (input.time.scheme)
      {
        case Scheme::newmark:
        case Scheme::static_at_rest:
          return make_newmark(input);
        case Scheme::explicit_steps:
          return make_explicit(input);
        case Scheme::quasi_static:
          return make_quasi_static(input);
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }


  SchemeTraits
  scheme_traits(const TimeParameters &time)
  {
    SchemeTraits traits;
    switch (time.scheme)
      {
        case Scheme::newmark:
          traits.has_inertia = true;
          traits.is_implicit = true;
          break;
        case Scheme::explicit_steps:
          traits.has_inertia      = true;
          traits.is_implicit      = false;
          traits.start_of_impulse = 0.;
          break;
        case Scheme::quasi_static:
          traits.has_inertia = false;
          traits.is_implicit = true;
          break;
        case Scheme::static_at_rest:
          traits.has_inertia    = true;
          traits.is_implicit    = true;
          traits.has_long_steps = true;
          break;
      }
    traits.moves_points = traits.has_inertia || time.move_points;
    return traits;
  }


  void
  require_implicit(const TimeParameters &time, const std::string &what)
  {
    if (scheme_traits(time).is_implicit)
      return;
    std::vector<std::string> allowed;
    for (const Scheme scheme : all_choices<Scheme>())
      {
        TimeParameters other;
        other.scheme = scheme;
        if (scheme_traits(other).is_implicit)
          allowed.emplace_back(name_of(scheme));
      }
    throw UserError("Time stepping/Scheme",
                    std::string("is ") + name_of(time.scheme) + ", but " + what,
                    either(allowed));
  }


  double
  first_time_step(const TimeParameters &time,
                  const Materials      &materials,
                  const double          cell_size)
  {
    return scheme_traits(time).is_implicit
             ? time.time_step
             : time.courant_number * cell_size / wave_speed(materials);
  }


  std::optional<double>
  chosen_courant_number(const TimeParameters &time,
                        const Materials      &materials,
                        const double          cell_size)
  {
    const SchemeTraits scheme = scheme_traits(time);
    if (!scheme.is_implicit || !scheme.has_inertia)
      return {};
    return wave_speed(materials) * time.time_step / cell_size;
  }


  double
  full_loads_from(const TimeParameters &time)
  {
    return !scheme_traits(time).has_inertia && time.load_duration > 0.
             ? time.load_duration
             : LastChange::never;
  }


  template <int dim>
  void
  StepReport<dim>::check_finite(const double time) const
  {
    const std::pair<const char *, double> values[] = {
      {"displacement rate", displacement_rate},
      {"plastic strain", mean_plastic_strain},
      {"kinetic energy", kinetic_energy},
      {"elastic energy", elastic_energy},
      {"dissipation", dissipation},
      {"friction", friction},
      {"work of the weight", gravity_work},
      {"work of the loads", load_work},
      {"work of the supports", support_work},
      {"work of the ramp", ramp_work},
      {"mapping loss", mapping_loss}};
    for (const auto &[name, value] : values)
      if (!std::isfinite(value))
        {
          std::ostringstream message;
          message << "the " << name << " of the step that ends at t = " << time
                  << " s is not finite";
          throw NumericalFailure(message.str());
        }
  }


  template <int dim>
  void
  StepReport<dim>::sum(const NodeExchange &ranks, const std::size_t n_points)
  {
    if (ranks.is_one_rank())
      return;
    double n = static_cast<double>(n_points);
    mean_plastic_strain *= n;
    std::vector<double *> sums{&n,
                               &mean_plastic_strain,
                               &gravity_work,
                               &load_work,
                               &support_work,
                               &ramp_work,
                               &mapping_loss,
                               &dissipation,
                               &friction,
                               &kinetic_energy,
                               &elastic_energy};
    for (unsigned int d = 0; d < dim; ++d)
      sums.push_back(&reaction[d]);
    std::vector<double> numbers;
    for (const double *const sum : sums)
      numbers.push_back(*sum);
    ranks.sum(numbers.data(), numbers.size());
    for (std::size_t k = 0; k < sums.size(); ++k)
      *sums[k] = numbers[k];
    mean_plastic_strain /= std::max(n, 1.);
  }


  template <int dim>
  void
  SchemeInput<dim>::find_motion(const double         t,
                                const double         dt,
                                std::vector<double> &removed_increments) const
  {
    grid.exchange().together([&]() {
      fixities.removed_increments(t, dt, removed_increments);
      std::vector<double> of_springs(fixities.penalties().size());
      fixities.penalty_increments(t, dt, of_springs);
    });
  }


  double
  residual_ramp(const double t, const double duration)
  {
    return duration > 0. ? std::min(1., t / duration) : 1.;
  }


  namespace
  {
    /// Of a wave of compression (kPa), with the water in the pores.
    double
    constrained_modulus(const Material &material)
    {
      return material.bulk_modulus() + material.pore_fluid_stiffness() +
             4. / 3. * material.shear_modulus();
    }
  } // namespace


  double
  wave_speed(const Materials &materials)
  {
    double fastest = 0.;
    for (const auto &m : materials)
      fastest = std::max(fastest, constrained_modulus(*m) / m->density());
    return std::sqrt(fastest);
  }


  double
  stiffest_modulus(const Materials &materials)
  {
    double stiffest = 0.;
    for (const auto &m : materials)
      stiffest = std::max(stiffest, constrained_modulus(*m));
    return stiffest;
  }


  template struct StepReport<2>;
  template struct StepReport<3>;
  template struct SchemeInput<2>;
  template struct SchemeInput<3>;
  template std::unique_ptr<TimeScheme<2>>
  make_time_scheme(const SchemeInput<2> &);
  template std::unique_ptr<TimeScheme<3>>
  make_time_scheme(const SchemeInput<3> &);
} // namespace Waker
