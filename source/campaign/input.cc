// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/sizes.h>
#include <waker/campaign/input.h>
#include <waker/statistics/histograms.h>

#include <algorithm>

namespace Waker
{
  void
  ReliabilityParameters::check(const unsigned int dim) const
  {
    fields.check(dim);
    campaign.check();
    sweep.check();
    analysis.check();
    for (const unsigned int number : snapshots.realisations)
      if (number >= campaign.realisations)
        throw UserError("Snapshots/Realisations",
                        "contains " + std::to_string(number),
                        "numbers from 0 to Campaign/Realisations - 1, " +
                          std::to_string(campaign.realisations - 1));

    // One mark per realisation and scenario is kept: see Progress.
    const double n = double(campaign.realisations) * sweep.list().size();
    checked_count("Campaign/Realisations",
                  n,
                  "realisations in all scenarios",
                  1e8,
                  "as many as a campaign may need at most");
  }


  void
  Input::prepare_materials()
  {
    for (const RandomFieldParameters &field : reliability.fields.fields)
      if (field.property == FieldProperty::youngs_modulus)
        {
          const std::vector<std::string> names = field.material_names();
          const auto is_named                  = [&](const std::string &name) {
            return std::find(names.begin(), names.end(), name) != names.end();
          };
          for (MaterialParameters &material : simulation.materials)
            if (names.empty() || is_named(material.name) || is_named("all"))
              material.elastic.varies = true;
        }
  }


  void
  Input::check() const
  {
    simulation.check();
    // The fields of a section are those of its case in space.
    reliability.check(simulation.in_space ? 3 : simulation.dimension);

    // No width or height of a dyke is larger than the box.
    const HistogramParameters &bins       = reliability.analysis.histograms;
    const auto                 check_bins = [&](const std::string &name,
                                const double       width,
                                const unsigned int direction) {
      checked_count("Histograms/" + name,
                    (simulation.grid.upper_corner[direction] -
                     simulation.grid.lower_corner[direction]) /
                      width,
                    "bins over the size of the box",
                    most_bins,
                    "wider bins");
    };
    check_bins("Width bin", bins.width_bin, 0);
    check_bins("Height bin", bins.height_bin, 1);
    check_bins("Resistance bin", bins.resistance_bin, 0);
  }
} // namespace Waker
