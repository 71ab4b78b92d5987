// SPDX-License-Identifier: LGPL-2.1-or-later
// Random properties that are not of a law: weights and stiffness.
#include <waker/base/errors.h>
#include <waker/campaign/random_properties.h>

#include <cmath>

namespace Waker
{
  template <int dim>
  void
  RandomProperties<dim>::set_weights(const bool                is_random,
                                     std::vector<CellWeights> &weights,
                                     State<dim>               &state) const
  {
    for (std::size_t t = 0; t < targets.size(); ++t)
      {
        const FieldTarget<dim> &target = targets[t];
        if (target.moments.varied().kind != RandomProperty::Kind::unit_weight ||
            target.points.empty())
          continue;
        // Mean and deviation are the same everywhere.
        const double own =
          the_case->parameters.materials[target.material].unit_weight;
        const FieldLattice &lattice = fields->lattice(target.field);
        CellWeights         cells{target.material, lattice, {}};
        for (std::size_t c = 0; c < lattice.n(); ++c)
          cells.ratio.push_back(
            (is_random ? target.value(0,
                                      scores[target.field][c],
                                      fields->score_variance(target.field))
                       : target.mean[0]) /
            own);
        for (std::size_t i = 0; i < target.points.size(); ++i)
          {
            const double ratio = cells.ratio[target.cells[i]];
            if (!(ratio > 0. && std::isfinite(ratio)))
              throw NumericalFailure(target.path +
                                     ": a unit weight is not above 0");
            state.points.mass[target.points[i]] *= ratio;
            n_cut_off[t] += target.is_cut_off(value(target, i, is_random));
          }
        weights.push_back(std::move(cells));
      }
    if (weights.empty())
      return;
    const double gravity = the_case->parameters.gravity.density_acceleration();
    std::vector<double> &gamma =
      state.points.scalar(name_of(FieldProperty::unit_weight));
    for (std::size_t q = 0; q < gamma.size(); ++q)
      gamma[q] = gravity * state.points.mass[q] / state.points.volume[q];
  }


  template <int dim>
  bool
  RandomProperties<dim>::set_stiffness(const bool  is_random,
                                       State<dim> &state) const
  {
    bool is_set = false;
    for (std::size_t t = 0; t < targets.size(); ++t)
      {
        const FieldTarget<dim> &target = targets[t];
        if (target.moments.varied().kind != RandomProperty::Kind::stiffness)
          continue;
        is_set = true;
        state.points.scalar(target.moments.varied().name);
        std::vector<double> &ratio = state.points.scalar("stiffness ratio");
        std::vector<double> &moduli =
          state.points.scalar(target.moments.varied().name);
        const double own = the_case->parameters.materials[target.material]
                             .elastic.youngs_modulus;
        for (std::size_t i = 0; i < target.points.size(); ++i)
          {
            const std::size_t q = target.points[i];
            moduli[q]           = value(target, i, is_random);
            ratio[q]            = moduli[q] / own;
            if (!(ratio[q] > 0. && std::isfinite(ratio[q])))
              throw NumericalFailure(target.path +
                                     ": a Young's modulus is not above 0");
            n_cut_off[t] += target.is_cut_off(moduli[q]);
          }
      }
    return is_set;
  }


  template void
  RandomProperties<2>::set_weights(const bool,
                                   std::vector<CellWeights> &,
                                   State<2> &) const;
  template void
  RandomProperties<3>::set_weights(const bool,
                                   std::vector<CellWeights> &,
                                   State<3> &) const;
  template bool
  RandomProperties<2>::set_stiffness(const bool, State<2> &) const;
  template bool
  RandomProperties<3>::set_stiffness(const bool, State<3> &) const;
} // namespace Waker
