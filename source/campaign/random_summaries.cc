// SPDX-License-Identifier: LGPL-2.1-or-later
// What is said and kept of the random properties of a realisation.
#include <waker/base/random_numbers.h>
#include <waker/campaign/random_properties.h>

#include <string>

namespace Waker
{
  template <int dim>
  std::vector<std::string>
  RandomProperties<dim>::warnings() const
  {
    if (fields == nullptr)
      return {};
    std::vector<std::string> lines = fields->warnings();
    for (const FieldTarget<dim> &target : targets)
      for (const std::string &warning : target.warnings(
             the_case->parameters.materials[target.material].name))
        lines.push_back(warning);
    return lines;
  }


  template <int dim>
  std::optional<std::vector<FieldSummary>>
  RandomProperties<dim>::summaries(const State<dim> &state) const
  {
    if (names.empty() || (names.size() == 1 && average_deviations[0] == 0.))
      return {};
    std::vector<FieldSummary> list;
    for (unsigned int f = 0; f < names.size(); ++f)
      {
        const auto [mean, least] = mean_and_least(f, state);
        list.push_back({names[f],
                        average_deviations[f] > 0.
                          ? averages[f] / average_deviations[f]
                          : nan,
                        mean,
                        least});
      }
    return list;
  }


  std::vector<double>
  realisation_noise(const std::uint64_t seed,
                    const std::uint64_t realisation,
                    const std::size_t   n)
  {
    std::vector<double> noise(n);
    white_noise({seed, realisation, 0}, 0, n, noise.data());
    return noise;
  }


  template std::vector<std::string>
  RandomProperties<2>::warnings() const;
  template std::vector<std::string>
  RandomProperties<3>::warnings() const;
  template std::optional<std::vector<FieldSummary>>
  RandomProperties<2>::summaries(const State<2> &) const;
  template std::optional<std::vector<FieldSummary>>
  RandomProperties<3>::summaries(const State<3> &) const;
} // namespace Waker
