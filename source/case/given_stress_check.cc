// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given_stress_check.h"

#include <waker/base/errors.h>
#include <waker/base/places.h>
#include <waker/base/text.h>

#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// As the user writes it.
    std::string
    stress_text(const SymmetricTensor<2, 3> &stress, const unsigned int dim)
    {
      constexpr unsigned int places[6][2] = {
        {0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
      std::ostringstream text;
      text.precision(4);
      for (unsigned int k = 0; k < (dim == 2 ? 4 : 6); ++k)
        text << (k == 0 ? "" : "; ") << stress[places[k][0]][places[k][1]];
      return text.str();
    }
  } // namespace


  template <int dim>
  void
  check_given_stress(const Parameters                &parameters,
                     const Materials                 &materials,
                     const std::vector<unsigned int> &layers,
                     const MaterialPoints<dim>       &points)
  {
    for (unsigned int l = 0; l < parameters.layers.size(); ++l)
      {
        const LayerParameters &layer = parameters.layers[l];
        if (layer.stress_components(dim).empty())
          continue;
        std::size_t n_points = 0, n_outside = 0, worst = 0;
        double      largest = 0.;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            if (layers[p] != l)
              continue;
            ++n_points;
            const Material &law       = *materials[points.material[p]];
            const auto      variables = variables_of(points, materials, p);
            if (is_borne(law, variables, points.stress[p]))
              continue;
            ++n_outside;
            const double excess =
              stress_excess(law, variables, points.stress[p]);
            // Not a number is the worst, and the first of them stays.
            if (!std::isnan(largest) && !(excess <= largest))
              {
                largest = excess;
                worst   = p;
              }
          }
        if (n_outside == 0)
          continue;
        std::ostringstream what;
        what.precision(4);
        what << "is " << stress_text(points.stress[worst], dim)
             << " kPa at the point " << place_text(points.position[worst])
             << " m: " << largest
             << " kPa outside the yield surface of its material, the worst of "
             << n_outside << " such points of the layer's " << n_points;
        throw UserError("Soil profile/" + layer.name + "/Initial stress",
                        what.str(),
                        "a stress that the law bears, or more strength");
      }
  }


  template void
  check_given_stress(const Parameters &,
                     const Materials &,
                     const std::vector<unsigned int> &,
                     const MaterialPoints<2> &);
  template void
  check_given_stress(const Parameters &,
                     const Materials &,
                     const std::vector<unsigned int> &,
                     const MaterialPoints<3> &);
} // namespace Waker
