// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_random_properties_h
#define waker_campaign_random_properties_h

#include <waker/campaign/dependent_properties.h>
#include <waker/campaign/field_target.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/fields/random_fields.h>
#include <waker/store/record.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  /**
   * Gives the points of a realisation their properties: white noise -> fields
   * -> values at the points, by their initial place, and what follows from
   * these (strengths, masses, the initial stress). One object serves all
   * realisations of a case; it is not for two threads at a time.
   */
  template <int dim>
  class RandomProperties
  {
  public:
    /// @param the_case must outlive this object
    /// @throws UserError "Random fields/..."
    RandomProperties(const Case<dim>              &the_case,
                     const RandomFieldsParameters &parameters);

    std::size_t
    n_noise() const
    {
      return fields == nullptr ? 0 : fields->n_noise();
    }

    /// Set the properties of the points of `state`, a copy of the case's first
    /// one. Of several ranks the first one generates the fields. Collective.
    /// @param noise n_noise() standard normal numbers; none on other ranks
    /// @throws NumericalFailure "Random fields/...": a value is not finite; or
    /// soil of varying weight does not come to rest in the gravity step
    void
    apply(const double *noise, State<dim> &state) const;

    /// Give them the means of the fields instead, with their trend. What is
    /// measured is of no account.
    void
    apply_means(State<dim> &state) const;

    /// Mass average and least value (of its unit()) of the first field's
    /// property in the points that have it; 0 without fields.
    std::pair<double, double>
    mean_and_least(const State<dim> &state) const;

    /// Unit of the first field's property; empty without fields.
    const std::string &
    unit() const
    {
      return unit_of_first;
    }

    /// Lines for the log: fields, cells per scale of fluctuation; of a field
    /// for all materials those that have no such property.
    std::vector<std::string>
    description() const;

    /// What is likely not meant: fewer than 4 cells per scale of fluctuation,
    /// limits that cut off more than a hundredth of a distribution.
    std::vector<std::string>
    warnings() const;

    /// Average and least value of each field that apply() has set, for the
    /// record; nothing of one field without an average of its own.
    std::optional<std::vector<FieldSummary>>
    summaries(const State<dim> &state) const;

    /// At how many points of `state`, that apply() has set last, a drawn value
    /// is one that the law would refuse, as a dilatancy angle above the
    /// friction angle, which counts as the most that the law takes, or an OCR
    /// below 1, which counts as 1. Nothing without fields.
    std::optional<std::uint64_t>
    n_beyond_law(const State<dim> &state) const;

    /// "Random fields/pop: 12 of 3400 points are cut off at a limit", of the
    /// points of `state`, that apply() has set last; a line per field with such
    /// points, and one for each property that is beyond its law.
    std::vector<std::string>
    cut_off(const State<dim> &state) const;

  private:
    /// The residual strength that goes along, and its ratio to the property of
    /// a target, one per point.
    struct Residual
    {
      std::size_t         target;
      std::string         name;
      std::vector<double> ratio;
    };

    /// A variable or a coefficient that is beyond the law of a material.
    struct BeyondLaw
    {
      unsigned int     material;
      std::size_t      n_of; // points of the material
      MaterialVariable variable;
      std::size_t      n = 0; // points at which it is
      double           value; // at the first of them
      std::string      allowed;
    };

    std::vector<BeyondLaw>
    beyond_laws(const State<dim> &state) const;

    /// Is there a field of this property for this material?
    bool
    has_field(const unsigned int material, const std::string &name) const;

    void
    find_residuals();

    /// @throws UserError "Random fields/<name>/Mean": with the means a point
    /// has what its law cannot start with, as a dilatancy angle above the
    /// friction angle, or an OCR below 1
    void
    check_means() const;

    /// Of the fields, or their means.
    void
    set(const bool is_random, State<dim> &state) const;

    void
    set_weights(const bool                is_random,
                std::vector<CellWeights> &weights,
                State<dim>               &state) const;

    /// Of the points; a coefficient is new to them.
    std::vector<double> &
    scalar_of(const RandomProperty &property, State<dim> &state) const;

    /// @return is there a field of it?
    bool
    set_stiffness(const bool is_random, State<dim> &state) const;

    double
    value(const FieldTarget<dim> &target,
          const std::size_t       i,
          const bool              is_random) const;

    std::pair<double, double>
    mean_and_least(const unsigned int field, const State<dim> &state) const;

    const Case<dim>              *the_case;
    std::unique_ptr<RandomFields> fields;   // none: deterministic
    std::vector<std::string>      names;    // of the fields
    std::vector<std::string>      left_out; // lines, see description()
    std::vector<double> average_deviations; // of scores; 0: no average
    std::vector<FieldTarget<dim>>           targets;
    std::vector<Residual>                   residuals;
    std::optional<DependentProperties<dim>> dependent;
    std::string                             unit_of_first;
    // Work space, and what the last realisation had.
    mutable std::vector<std::vector<double>> scores;
    mutable std::vector<double>              averages;
    mutable std::vector<std::size_t>         n_cut_off; // by target
  };


  /// The white noise of realisation i of a campaign: the first n numbers of
  /// the key (seed, i, stream 0).
  std::vector<double>
  realisation_noise(const std::uint64_t seed,
                    const std::uint64_t realisation,
                    const std::size_t   n);
} // namespace Waker

#endif
