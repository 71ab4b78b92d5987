// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_loaded_bar_h
#define waker_tests_loaded_bar_h

#include <waker/case/case.h>
#include <waker/case/scene.h>

#include "named.h"
#include "output_temporary_folder.h"
#include <sstream>

namespace Waker
{
  /// The bar of fig. 3.3 of Remmerswaal 2023: 3 x 1 m, from x on, on a grid of
  /// 1 m, with 2 x 2 points per cell, sigma_xx = -1 kPa, no weight.
  class LoadedBar
  {
  public:
    explicit LoadedBar(const double         x,
                       const ShapeFunctions functions = ShapeFunctions::gimp)
    {
      parameters.grid.lower_corner = {0., 0.};
      parameters.grid.upper_corner = {6., 1.};
      parameters.grid.cell_size    = 1.;
      MaterialParameters material;
      material.name                   = "elastic";
      material.model                  = MaterialModel::linear_elastic;
      material.elastic.youngs_modulus = 1000.;
      material.elastic.poissons_ratio = 0.;
      parameters.materials            = {material};
      LayerParameters layer;
      layer.name           = "bar";
      layer.material       = "elastic";
      layer.initial_stress = "-1; 0; 0; 0";
      std::ostringstream polygon;
      polygon.precision(17);
      polygon << x << ", 0; " << x + 3 << ", 0; " << x + 3 << ", 1; " << x
              << ", 1";
      layer.polygon               = polygon.str();
      parameters.layers           = {layer};
      parameters.points.placement = Placement::rows;
      for (const char *const region : {"bottom", "top"})
        {
          FixityParameters roller;
          roller.name   = region;
          roller.region = Named{region};
          roller.type   = FixityType::roller;
          parameters.fixities.push_back(roller);
        }
      parameters.gravity.acceleration   = 0.;
      parameters.gravity.initial_stress = false;
      parameters.mapping.functions      = functions;

      std::ofstream file(folder.file("bar"));
      file.precision(17);
      file << x << " 0\n"
           << x + 3 << " 0\n"
           << x + 3 << " 1\n"
           << x << " 1\n"
           << x << " 0\n";
    }

    /// A pressure of 1 kPa on both ends.
    void
    load(const std::string &method)
    {
      TractionParameters traction;
      traction.name   = method;
      traction.method = Named{method};
      traction.kind   = TractionKind::pressure;
      traction.value  = "1";
      // Where points lie on a corner the closest one may be above or below it.
      if (method == name_of(TractionMethod::user_surface) ||
          method == name_of(TractionMethod::fixed_points))
        traction.surface_file = folder.file("bar");
      parameters.tractions.push_back(traction);
    }

    TemporaryFolder folder;
    Parameters      parameters;
  };


  /// Largest |F_ext - F_int| of the nodes, for each of the tractions (kN).
  template <int dim>
  std::vector<double>
  inconsistency(Scene<dim> &scene)
  {
    std::vector<double> largest(scene.tractions.size());
    for (std::size_t i = 0; i < largest.size(); ++i)
      {
        const NodalVector &force = *scene.tractions.view(i).nodal_force;
        for (unsigned int k = 0; k < force.locally_owned_size(); ++k)
          // The rollers carry what is across.
          if (k % dim == 0)
            largest[i] =
              std::max(largest[i],
                       std::abs(force.begin()[k] -
                                scene.nodes.internal_force.begin()[k]));
      }
    return largest;
  }
} // namespace Waker

#endif
