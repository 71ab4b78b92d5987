// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/surface/parameters.h>

#include <string>
#include <utility>

namespace Waker
{
  void
  SurfaceParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Method",
               method,
               "How the surface of the soil is found: the proximity "
               "field of the points, or the contour of their support "
               "domains. Water loads it, and the dyke is measured on "
               "it.");
    prm.add_parameter("Prismatic",
                      prismatic,
                      "In 3D: take the body as prismatic along z, and find its "
                      "surface in the x-y plane, as for a slice in plane "
                      "strain. Layers whose Top, Bottom or Extent make it "
                      "another body along z are warned of.",
                      Patterns::Bool());
    prm.add_parameter("Kernel radius",
                      kernel_radius,
                      "Radius of the kernel of the proximity field, in cells, "
                      "0.5 to 2. A larger one gives a smoother surface but "
                      "rounds corners and closes gaps narrower than itself; "
                      "below 0.75 the surface follows single points.",
                      Patterns::Double(0.5, 2.));
    prm.add_parameter("Threshold",
                      threshold,
                      "Value of the proximity field at the surface, 0.05 to "
                      "0.95 (the field is about 1 inside the body). With 0.5 "
                      "a flat face has no mean offset; less moves the surface "
                      "outwards.",
                      Patterns::Double(0.05, 0.95));
    prm.add_parameter("Mirror",
                      mirror,
                      "Mirror the kernels at fixed faces of the grid. Without, "
                      "the field is halved there and the surface curls inward.",
                      Patterns::Bool());
    prm.add_parameter("Minimum gap width",
                      minimum_gap_width,
                      "Contour: horizontal gaps between support domains that "
                      "are narrower than this are filled, as a share of the "
                      "smallest domain's width, 0 (none) to below 1.",
                      Patterns::Double(0.));
    prm.add_parameter("Minimum gap height",
                      minimum_gap_height,
                      "Contour: vertical gaps lower than this are filled, as a "
                      "share of the smallest domain's height, 0 to below 1.",
                      Patterns::Double(0.));
    prm.add_parameter("Symmetric filling",
                      symmetric_filling,
                      "Contour: fill gaps alike from both sides. Off: from the "
                      "left, as in the thesis.",
                      Patterns::Bool());
  }


  void
  SurfaceParameters::check() const
  {
    require_positive("Surface/Kernel radius", kernel_radius);
    if (!(threshold > 0. && threshold < 1.))
      throw UserError("Surface/Threshold",
                      "is " + in_digits(threshold),
                      "above 0 and below 1");
    for (const auto &[name, share] :
         {std::make_pair("width", minimum_gap_width),
          std::make_pair("height", minimum_gap_height)})
      if (!(share >= 0. && share < 1.))
        throw UserError(std::string("Surface/Minimum gap ") + name,
                        "is " + in_digits(share) +
                          ": gaps as large as a support domain would be filled",
                        "0 (none) to below 1, in domains");
  }
} // namespace Waker
