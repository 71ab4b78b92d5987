// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_dependent_properties_h
#define waker_campaign_dependent_properties_h

#include <waker/campaign/field_target.h>
#include <waker/case/initial_properties.h>
#include <waker/case/state.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// Unit weight of a material over its own, by cell of its random field.
  struct CellWeights
  {
    unsigned int        material;
    FieldLattice        lattice;
    std::vector<double> ratio;
  };

  /// Their means along vertical lines; of other materials it is 1.
  /// @param weights is kept by reference
  template <int dim>
  typename Ground<dim>::WeightRatio
  weight_ratio(const Case<dim>                &the_case,
               const std::vector<CellWeights> &weights);


  /**
   * What follows at a point from random fields of other properties: the
   * undrained strength of coefficients (S, POP, ...), and whatever asks for the
   * vertical stress of unit weights. By the same expressions as the case's own
   * (InitialProperties).
   */
  template <int dim>
  class DependentProperties
  {
  public:
    /// @param the_case must outlive this object
    /// @throws UserError "Random fields/<name>/Property": a field of what
    /// follows from others that have fields
    DependentProperties(const Case<dim>                     &the_case,
                        const std::vector<FieldTarget<dim>> &targets);

    /// Set them, after the coefficients have been.
    /// @param ratio of the unit weights; empty: they do not vary
    /// @throws NumericalFailure one is not a number
    void
    set(const typename Ground<dim>::WeightRatio &ratio,
        State<dim>                              &state) const;

  private:
    /// A variable that goes along with another one, in its ratio to it.
    struct Along
    {
      unsigned int        variable, with;
      std::vector<double> ratio; // one per point
    };

    struct Soil
    {
      unsigned int             material;
      std::vector<std::size_t> points;
      std::vector<InGround>    places;       // one per point, with own weights
      std::vector<std::string> coefficients; // that vary; empty: none of them
      std::vector<std::string> variables;
      std::vector<Along>       along;
    };

    const Case<dim>       *the_case;
    InitialProperties<dim> own;
    std::vector<Soil>      soils;
  };
} // namespace Waker

#endif
