// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_loaded_block_h
#define waker_tests_loaded_block_h

#include <waker/case/parameters.h>

#include "named.h"
#include "output_temporary_folder.h"

namespace Waker
{
  /// A block from 1 to 4 m, 2 m high, on cells of 0.5 m; a load on the middle
  /// of its top, in a box that is 0.1 m thick.
  template <int dim>
  class LoadedBlock
  {
  public:
    LoadedBlock()
    {
      parameters.dimension         = dim;
      parameters.grid.lower_corner = std::vector<double>(dim, 0.);
      parameters.grid.upper_corner = std::vector<double>(dim, 5.);
      parameters.grid.cell_size    = 0.5;
      parameters.materials.resize(1);
      parameters.materials[0].name  = "soil";
      parameters.materials[0].model = MaterialModel::linear_elastic;
      parameters.layers.resize(1);
      parameters.layers[0].name     = "block";
      parameters.layers[0].material = "soil";
      parameters.layers[0].polygon  = "1, 1; 4, 1; 4, 3; 1, 3";
      if (dim == 3)
        parameters.layers[0].extent = {1., 4.};
      parameters.gravity.acceleration   = 0.;
      parameters.gravity.initial_stress = false;
      std::ofstream(folder.file("outline"))
        << "1 1\n4 1\n4 3\n1 3\n1 1\n"; // for 2D
    }

    /// @param value of a vector: "x; y; z"; of a pressure: one
    TractionParameters &
    load(const std::string &method, const std::string &value)
    {
      TractionParameters t;
      t.name   = method;
      t.method = Named{method};
      t.kind   = value.find(';') != std::string::npos ? TractionKind::vector
                                                      : TractionKind::pressure;
      t.value  = value;
      t.from   = {1.7, 2.95};
      t.to     = {2.9, 3.05};
      if (dim == 3)
        {
          t.from.push_back(1.6);
          t.to.push_back(3.1);
        }
      if (method == name_of(TractionMethod::proximity_field))
        {
          // It is smooth, and not quite on the block.
          t.from[1] = 2.8;
          t.to[1]   = 3.2;
        }
      if (method == name_of(TractionMethod::user_surface))
        t.surface_file = folder.file("outline");
      parameters.tractions.push_back(t);
      return parameters.tractions.back();
    }

    TemporaryFolder folder;
    Parameters      parameters;
  };
} // namespace Waker

#endif
