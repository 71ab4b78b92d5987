// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_parameters_h
#define waker_case_parameters_h

#include <waker/base/numbers.h>
#include <waker/case/initial_stress_parameters.h>
#include <waker/control/load_programme_parameters.h>
#include <waker/control/parameters.h>
#include <waker/loads/parameters.h>
#include <waker/loads/pore_water.h>
#include <waker/loads/traction_parameters.h>
#include <waker/materials/factory.h>
#include <waker/mechanics/parameters.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/wall_parameters.h>
#include <waker/output/parameters.h>
#include <waker/particles/flow_parameters.h>
#include <waker/particles/point_loads.h>
#include <waker/particles/soil_profile.h>
#include <waker/surface/parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  /// Section "Grid".
  struct GridParameters
  {
    std::vector<double> lower_corner = {-6., 0.}; // m
    std::vector<double> upper_corner = {42., 6.}; // m
    double              cell_size    = 0.25;      // m

    void
    add_parameters(ParameterHandler &prm);
    /// That the corners have `dim` numbers and the box is one; that it is a
    /// multiple of the cell size is for BackgroundGrid to see.
    /// @throws UserError "Grid/..."
    void
    check(const unsigned int dim) const;

    /// Of the box (m).
    double
    longest_side() const;
  };

  /// Section "Ranks".
  struct RankParameters
  {
    /// Points of the rank that has most, over the mean: above it they are dealt
    /// out anew.
    double largest_imbalance = 1.1;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Ranks/..."
    void
    check() const;
  };

  /// Section "Strength reduction".
  struct StrengthReductionParameters
  {
    double         lower_factor = 0.5;  // known or hoped to be stable
    double         upper_factor = 3.;   // known or hoped to fail
    double         tolerance    = 0.01; // width of the final bracket
    FailureReading reading      = FailureReading::by_displacement;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Strength reduction/..."
    void
    check() const;
  };

  /**
   * Everything that a .prm file says, in plain structs. Made by
   * `program/`; the struct must not move after its entries are declared.
   */
  struct Parameters
  {
    unsigned int dimension = 2;
    /// Of a case in space: z (m) of the section to be computed in plane strain,
    /// or "none". See case/cross_section.h.
    std::string                          cross_section = "none";
    GridParameters                       grid;
    MaterialPointParameters              points;
    std::vector<MaterialParameters>      materials;
    std::vector<LayerParameters>         layers;
    std::vector<FixityParameters>        fixities;
    GravityParameters                    gravity;
    InitialStressParameters              initial_stress;
    WaterParameters                      water;
    PoreWaterParameters                  pore_water;
    SurfaceParameters                    surface;
    std::vector<TractionParameters>      tractions;
    std::vector<PointLoadParameters>     point_loads;
    std::vector<LoadProgrammeParameters> load_programmes;
    std::vector<WallParameters>          walls;
    OutflowParameters                    outflow;
    std::vector<OutletParameters>        outlets;
    std::vector<InflowParameters>        inflows;
    MappingParameters                    mapping;
    TimeParameters                       time;
    NewtonParameters                     newton;
    InitialFailureParameters             initial_failure;
    SlidingMassParameters                sliding;
    StopParameters                       stop;
    StrengthReductionParameters          strength_reduction;
    RankParameters                       ranks;
    OutputParameters                     output;

    /// If this is the section of a case in space: that case, and z (m).
    std::shared_ptr<const Parameters> in_space;
    double                            section_z = nan;

    /// The .prm text of all values used, and its hash: they go with every
    /// output. Set by the reader; `hash` leaves "Output" and "Stop rules" and
    /// the end time out (and "Strength reduction", "Ranks"): a run may be
    /// resumed with other values of those.
    std::string text;
    std::string hash;

    /**
     * All checks of single structs, and those between them: vectors of the
     * right length, layers of known materials, water below the crest, a
     * support for the static step. What needs the grid (layers inside it,
     * overlaps) is checked where points are made.
     *
     * @throws UserError with the path of the parameter
     */
    void
    check() const;
  };
} // namespace Waker

#endif
