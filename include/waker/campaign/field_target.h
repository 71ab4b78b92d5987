// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_field_target_h
#define waker_campaign_field_target_h

#include <waker/campaign/field_moments.h>
#include <waker/campaign/field_place.h>
#include <waker/fields/marginal.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// Where one random field goes in one material.
  template <int dim>
  struct FieldTarget
  {
    /// All points of the material, with mean and deviation of their place.
    /// @param field_number of the field among all
    /// @throws UserError "Random fields/<name>/..."
    FieldTarget(const Case<dim>             &the_case,
                const RandomFieldParameters &field,
                const unsigned int           field_number,
                const unsigned int           material,
                const FieldPlace<dim>       &place,
                const FieldLattice          &lattice);

    /// Of the i-th point.
    /// @param score of its cell, of this variance
    double
    value(const std::size_t i, const double score, const double variance) const
    {
      return standard_deviation[i] > 0.
               ? marginal.value(score, mean[i], standard_deviation[i], variance)
               : mean[i];
    }

    /// Is a value one that a limit has cut off?
    bool
    is_cut_off(const double value) const
    {
      return value == minimum || value == maximum;
    }

    /// What is likely not meant: the limits cut off more than a hundredth of
    /// the distribution, or its spread is that of no soil. A field may have
    /// several materials, so each line names its own.
    std::vector<std::string>
    warnings(const std::string &material_name) const;

    /// A weight or a stiffness: can the case do with it?
    /// @throws UserError path + "/Property", path + "/Minimum"
    void
    check_stiffness(const Case<dim>             &the_case,
                    const RandomFieldParameters &parameters) const;

    std::string              path; // "Random fields/strength"
    unsigned int             field;
    unsigned int             material;
    FieldMoments<dim>        moments;
    double                   minimum, maximum; // of the property's unit
    Marginal                 marginal;
    std::vector<std::size_t> points; // of the material
    std::vector<std::size_t> cells;  // of the field's lattice, one per point
    std::vector<double>      mean;   // of the property's unit, one per point
    std::vector<double>      standard_deviation;
  };


  /// The target of a field that a measurement belongs to, and the layer.
  template <int dim>
  struct MeasuredPlace
  {
    const FieldTarget<dim> *target; // none: the field has no points there
    unsigned int            layer;
  };

  /// @param targets of all fields
  /// @param cell of the field's lattice that holds x
  template <int dim>
  MeasuredPlace<dim>
  measured_place(const Case<dim>                     &the_case,
                 const std::vector<FieldTarget<dim>> &targets,
                 const unsigned int                   field,
                 const std::size_t                    cell,
                 const Point<dim>                    &x);

  /// Normal score of a measured value.
  /// @param variance of the scores
  /// @throws UserError path of the field + "/Measurements"
  template <int dim>
  double
  measured_score(const MeasuredPlace<dim> &at,
                 const std::string        &path,
                 const Point<dim>         &x,
                 const double              value,
                 const double              variance);
} // namespace Waker

#endif
