// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_random_properties_h
#define waker_campaign_random_properties_h

#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/fields/marginal.h>
#include <waker/fields/random_fields.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Gives the points of a realisation their properties: white noise -> fields
   * -> values at the points, by their initial place. One object serves all
   * realisations of a case; it is not for two threads at a time.
   */
  template <int dim>
  class RandomProperties
  {
  public:
    /// @throws UserError "Random fields/..."
    RandomProperties(const Case<dim>              &the_case,
                     const RandomFieldsParameters &parameters);

    std::size_t
    n_noise() const
    {
      return fields == nullptr ? 0 : fields->n_noise();
    }

    /// Set the properties of the points of `state`, a copy of the case's first
    /// one. @param noise n_noise() standard normal numbers
    /// @throws NumericalFailure "Random fields/...": a value is not finite
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

    /// Lines for the log: fields, cells per scale of fluctuation.
    std::vector<std::string>
    description() const;

    /// What is likely not meant: fewer than 4 cells per scale of fluctuation,
    /// limits that cut off more than a hundredth of a distribution.
    std::vector<std::string>
    warnings() const;

  private:
    /// Where one field goes.
    struct Target
    {
      std::string              path; // "Random fields/strength"
      std::string              property;
      Marginal                 marginal;
      std::vector<std::size_t> points; // that get it
      std::vector<std::size_t> cells;  // of its lattice, one per point
      std::vector<double>      mean;   // of the property's unit, one per point
      std::vector<double>      standard_deviation;
      /// The residual strength that goes along, and its ratio to the property,
      /// one per point; else empty.
      std::string         residual;
      std::vector<double> residual_ratio;
    };

    void
    set_residual(const Target &target, State<dim> &state) const;

    std::unique_ptr<RandomFields>            fields; // none: deterministic
    std::vector<Target>                      targets;
    std::string                              unit_of_first;
    mutable std::vector<std::vector<double>> scores;
  };


  /// The white noise of realisation i of a campaign: the first n numbers of
  /// the key (seed, i, stream 0).
  std::vector<double>
  realisation_noise(const std::uint64_t seed,
                    const std::uint64_t realisation,
                    const std::size_t   n);
} // namespace Waker

#endif
