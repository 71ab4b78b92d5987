// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/factory.h>
#include <waker/materials/undrained_soil.h>

#include <utility>

namespace Waker
{
  namespace
  {
    std::unique_ptr<Material>
    make_law(const MaterialParameters &p,
             const double              gravity,
             const double              cell_size)
    {
      const double           density = p.unit_weight / gravity;
      const SofteningMeasure measure = p.softening_measure(cell_size);
      switch (p.model)
        {
          case MaterialModel::linear_elastic:
            {
              auto law =
                std::make_unique<LinearElastic>(density,
                                                p.elastic.youngs_modulus,
                                                p.elastic.poissons_ratio);
              if (p.elastic.varies)
                law->let_stiffness_vary();
              return law;
            }
          case MaterialModel::von_mises_softening:
            return make_von_mises_softening(density,
                                            p.elastic,
                                            p.von_mises,
                                            measure,
                                            "Materials/" + p.name + "/");
          case MaterialModel::mohr_coulomb:
            return make_mohr_coulomb(density,
                                     p.elastic,
                                     p.mohr_coulomb,
                                     measure,
                                     "Materials/" + p.name + "/");
          case MaterialModel::modified_cam_clay:
            return make_modified_cam_clay(density,
                                          p.elastic,
                                          p.cam_clay,
                                          p.mohr_coulomb.friction_angle,
                                          p.von_mises.strength.pop,
                                          "Materials/" + p.name + "/");
        }
      AssertThrow(false, ExcInternalError());
      return nullptr;
    }
  } // namespace


  std::unique_ptr<Material>
  make_material(const MaterialParameters &p,
                const double              gravity,
                const double              cell_size)
  {
    std::unique_ptr<Material> law = make_law(p, gravity, cell_size);
    if (p.pore_fluid_stiffness > 0.)
      return std::make_unique<UndrainedSoil>(std::move(law),
                                             p.pore_fluid_stiffness);
    return law;
  }
} // namespace Waker
