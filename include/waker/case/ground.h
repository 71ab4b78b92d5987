// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_ground_h
#define waker_case_ground_h

#include <waker/loads/pore_water.h>
#include <waker/loads/quick_loads.h>
#include <waker/particles/place_expression.h>
#include <waker/particles/soil_depths.h>

#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  struct Parameters;

  /**
   * The ground at t = 0, before anything moves: how deep a place lies in it,
   * and what lies on it. The vertical stress is the weight of the column of
   * soil and water over the place, whatever slopes beside it, and now, not on
   * usual days, what quick loads bring; effective where there is a phreatic
   * line (compression positive).
   */
  template <int dim>
  class Ground
  {
  public:
    /// @param pore_water is kept by reference
    /// @throws UserError as make_material_points()
    Ground(const BackgroundGrid<dim> &grid,
           const Parameters          &parameters,
           const PoreWater<dim>      &pore_water);

    /// The mean ratio of the unit weights of soil to those of its material, of
    /// a vertical line from `low` to `high` (m) at x.
    using WeightRatio = std::function<double(const unsigned int material,
                                             const Point<dim>  &x,
                                             const double       low,
                                             const double       high)>;

    /// @param layer number of the layer that the place belongs to; one that
    /// there is not (of soil that flows in): all is NaN
    /// @param weight_ratio of soil whose weight varies; empty: 1
    InGround
    at(const Point<dim>  &x,
       const unsigned int layer,
       const WeightRatio &weight_ratio = {}) const;

    /// sigma'_v (kPa) at a place under other heads of the water in the ground;
    /// the soil weighs what it does at t = 0. NaN in a layer that there is not.
    double
    vertical_stress_under(const Heads       &heads,
                          const Point<dim>  &x,
                          const unsigned int layer) const;

    /// Why a vertical stress, at() a place, is no number or below 0: " (uplift:
    /// the water there, 40 kPa by Head lines/deep, carries more than the soil
    /// above weighs)". "" if it is neither.
    std::string
    why_uplifted(const Point<dim>  &x,
                 const unsigned int layer,
                 const InGround    &place) const;

    /// The points' scalar "pore pressure of loads" (kPa), of quick loads; made
    /// if there are any.
    /// @param layers number of each point's layer
    void
    record_loads(const std::vector<unsigned int> &layers,
                 MaterialPoints<dim>             &points) const;

    /// @param path of a parameter that asks for the vertical stress
    /// @param what it is, for the error
    /// @param otherwise what else it may be, likewise
    /// @throws UserError path: there is no gravity; or water stands outside,
    /// and there is no phreatic line
    void
    require_stress(const std::string &path,
                   const std::string &what,
                   const std::string &otherwise) const;

    /// Is the vertical stress known?
    bool
    knows_stress() const
    {
      return has_gravity && stress_is_known;
    }

    const SoilDepths<dim> &
    depths() const
    {
      return soil_depths;
    }

    /// Is an expression one that the ground can answer?
    /// @param path of the parameter
    /// @throws UserError path: it asks for the vertical stress, and there is no
    /// gravity; or water stands outside, and there is no phreatic line
    void
    check(const PlaceExpression<dim> &expression,
          const std::string          &path) const;

  private:
    struct SoilOfLayer
    {
      double       above_line, below_line; // unit weight, kN/m^3
      unsigned int material, material_below_line;
    };

    using Column = std::vector<typename SoilDepths<dim>::InLayer>;

    /// The water at a place, and over it.
    struct WaterAt
    {
      double line;     // m, of its surface; -infinity: there is none
      double pressure; // kPa
    };

    /// sigma'_v (kPa) at x under what of its column lies over it.
    /// @param line below which the soil is wet (m); -infinity: nowhere
    double
    vertical_stress(const Column      &column,
                    const Point<dim>  &x,
                    const double       line,
                    const WaterAt     &water,
                    const WeightRatio &weight_ratio) const;

    /// The same at t = 0, or on usual days.
    double
    vertical_stress(const Column         &column,
                    const Point<dim>     &x,
                    const PoreWater<dim> &water,
                    const WeightRatio    &weight_ratio) const;

    /// Of quick loads, in the water there (kPa).
    double
    load_pressure(const Point<dim> &x, const unsigned int layer) const;

    SoilDepths<dim>          soil_depths;
    QuickLoads<dim>          quick_loads;
    std::vector<SoilOfLayer> soils; // by layer
    const PoreWater<dim>    *pore_water;
    PoreWater<dim>           daily_pore_water;
    double                   water_weight; // kN/m^3
    bool                     has_gravity;
    bool                     stress_is_known;
    PoreWaterParameters      lines;                // for their names
    std::string              names_of_quick_loads; // with commas
  };
} // namespace Waker

#endif
