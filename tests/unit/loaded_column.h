// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_loaded_column_h
#define waker_tests_loaded_column_h

#include <waker/simulation/run_to_end.h>

#include <string>

namespace Waker
{
  /// An elastic column without Poisson's effect, 2 m wide and 4 m high, on a
  /// fixed base between rollers, under its weight; and a load programme
  /// "surcharge" on all of its top.
  struct LoadedColumn
  {
    static constexpr double stiffness   = 1000.; // kPa
    static constexpr double unit_weight = 20.;   // kN/m^3
    static constexpr double height      = 4.;    // m
    static constexpr double width       = 2.;    // m

    explicit LoadedColumn(const double cell_size = 0.5)
    {
      Parameters &p            = parameters;
      p.grid.lower_corner      = {0., 0.};
      p.grid.upper_corner      = {2., 5.};
      p.grid.cell_size         = cell_size;
      MaterialParameters m     = {};
      m.name                   = "elastic";
      m.model                  = MaterialModel::linear_elastic;
      m.unit_weight            = unit_weight;
      m.elastic.youngs_modulus = stiffness;
      m.elastic.poissons_ratio = 0.;
      p.materials              = {m};
      LayerParameters layer;
      layer.name     = "column";
      layer.material = "elastic";
      layer.polygon  = "0, 0; 2, 0; 2, 4; 0, 4";
      p.layers       = {layer};
      for (const auto &[region, type] :
           {std::make_pair(FixityRegion::bottom, FixityType::fixed),
            std::make_pair(FixityRegion::left, FixityType::roller),
            std::make_pair(FixityRegion::right, FixityType::roller)})
        {
          FixityParameters fixity;
          fixity.name   = name_of(region);
          fixity.region = region;
          fixity.type   = type;
          p.fixities.push_back(fixity);
        }
      p.time.time_step     = 0.01;
      p.time.end_time      = 2.;
      p.time.ramp_duration = 0.;
      p.newton.tolerance   = 1e-8;

      LoadProgrammeParameters load;
      load.name               = "surcharge";
      load.weight.from        = {0.};
      load.weight.to          = {2.};
      load.weight.unit_weight = unit_weight;
      load.rate               = 0.5;
      p.load_programmes       = {load};
    }

    LoadProgrammeParameters &
    load()
    {
      return parameters.load_programmes[0];
    }

    StopReason
    run()
    {
      parameters.check();
      const Case<2> the_case(parameters, MPI_COMM_SELF);
      state = initial_state(the_case);
      Realisation<2>   realisation(the_case, state);
      const StopReason stop = run_to_end(realisation);
      unrest                = realisation.unrest();
      reaction              = realisation.view().report.reaction[1];
      return stop;
    }

    Parameters parameters;
    State<2>   state;
    Unrest     unrest;
    double     reaction = 0.; // of the base at the end, kN
  };
} // namespace Waker

#endif
