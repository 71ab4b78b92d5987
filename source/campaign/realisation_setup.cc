// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/log.h>
#include <waker/campaign/random_properties.h>
#include <waker/campaign/realisation_setup.h>

#include <cstdio>

namespace Waker
{
  namespace
  {
    /// "<title>: mean 12.7, least 9.1 kPa" (or its unit) of the first field's
    /// property.
    template <int dim>
    std::string
    mean_and_least(const std::string           &title,
                   const RandomProperties<dim> &properties,
                   const State<dim>            &state)
    {
      const auto [mean, least] = properties.mean_and_least(state);
      char text[80];
      std::snprintf(text, sizeof text, ": mean %.3f, least %.3f ", mean, least);
      return title + text + properties.unit();
    }
  } // namespace


  std::string
  realisation_title(const Input &input, const std::uint64_t realisation)
  {
    return "realisation " + std::to_string(realisation) + " of seed " +
           std::to_string(input.reliability.campaign.seed);
  }


  template <int dim>
  InitialSetup<dim>
  realisation_setup(const Input        &input,
                    const std::uint64_t realisation,
                    const std::string  &title)
  {
    return [&input, realisation, title](const Case<dim> &the_case,
                                        State<dim>      &state) {
      const RandomProperties<dim> properties(the_case,
                                             input.reliability.fields);
      properties.apply(realisation_noise(input.reliability.campaign.seed,
                                         realisation,
                                         properties.n_noise())
                         .data(),
                       state);
      std::vector<std::string> lines = properties.description();
      lines.push_back(mean_and_least("This is " + title, properties, state));
      for (const std::string &line : properties.cut_off(state))
        lines.push_back(line);
      for (const std::string &warning : properties.warnings())
        lines.push_back(Log::warning_mark + warning);
      return lines;
    };
  }


  template <int dim>
  InitialSetup<dim>
  means_setup(const Input &input)
  {
    return [&input](const Case<dim> &the_case, State<dim> &state) {
      const RandomProperties<dim> properties(the_case,
                                             input.reliability.fields);
      properties.apply_means(state);
      std::vector<std::string> lines = {
        mean_and_least("Nothing is random: the points have the means of the "
                       "random fields",
                       properties,
                       state)};
      for (const RandomFieldParameters &field : input.reliability.fields.fields)
        if (!field.measurements.empty())
          lines.push_back("Random fields/" + field.name +
                          "/Measurements is left out: the mean does not know "
                          "it");
      return lines;
    };
  }


  template InitialSetup<2>
  realisation_setup(const Input &, const std::uint64_t, const std::string &);
  template InitialSetup<3>
  realisation_setup(const Input &, const std::uint64_t, const std::string &);
  template InitialSetup<2>
  means_setup(const Input &);
  template InitialSetup<3>
  means_setup(const Input &);
} // namespace Waker
