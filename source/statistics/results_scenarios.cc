// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/fragility.h>
#include <waker/statistics/results_scenarios.h>

#include <algorithm>
#include <type_traits>

namespace Waker
{
  namespace
  {
    /// Of one member of all scenarios.
    template <typename Function>
    auto
    collect(const CampaignInfo &info, const Function &member)
    {
      std::vector<std::decay_t<decltype(member(info.scenarios[0]))>> values;
      for (const ScenarioInfo &scenario : info.scenarios)
        values.push_back(member(scenario));
      return values;
    }


    void
    write(Hdf5File               &file,
          const std::string      &name,
          const std::string      &units,
          const std::string      &long_name,
          const Hdf5File::Values &values,
          Hdf5File::Attributes    attributes = {})
    {
      attributes.insert(attributes.begin(),
                        {{"units", units}, {"long_name", long_name}});
      file.write_variable(name, {"scenario"}, values, attributes);
    }


    void
    write_probability(Hdf5File                              &file,
                      const std::string                     &name,
                      const std::string                     &long_name,
                      const std::vector<BoundedProbability> &values)
    {
      std::vector<double>      estimate, low, high;
      std::vector<std::int8_t> kind;
      for (const BoundedProbability &p : values)
        {
          estimate.push_back(p.estimate);
          low.push_back(p.low);
          high.push_back(p.high);
          kind.push_back(static_cast<std::int8_t>(kind_of(p.estimate)));
        }
      write(file, name, "1", long_name, estimate);
      write(file,
            name + "_low",
            "1",
            long_name + ", lower end of the 95 % interval",
            low);
      write(file,
            name + "_high",
            "1",
            long_name + ", upper end of the 95 % interval",
            high);
      write(file,
            name + "_kind",
            "1",
            long_name + ": what the estimate says",
            kind,
            {{"flag_values", std::vector<std::int8_t>{0, 1, 2, 3}},
             {"flag_meanings", "estimate upper_bound lower_bound unknown"}});
    }
  } // namespace


  void
  write_scenarios(Hdf5File &file, const CampaignInfo &info)
  {
    using Info = ScenarioInfo;
    write(file,
          "scenario_value",
          "1",
          info.swept_parameter.empty()
            ? "value of the swept parameter: there is none"
            : "value of " + info.swept_parameter,
          collect(info, [](const Info &s) { return s.value; }));
    write(file,
          "water_level",
          "m",
          "water level",
          collect(info, [](const Info &s) { return s.water_level; }));
    write(file,
          "crest_level",
          "m",
          "level of the crest as drawn",
          collect(info, [](const Info &s) { return s.crest_level; }));
    write(file,
          "base_level",
          "m",
          "level of the lowest corner of the soil profile",
          collect(info, [](const Info &s) { return s.base_level; }));

    std::size_t n_axes = 2;
    for (const Info &scenario : info.scenarios)
      n_axes = std::max(n_axes, scenario.scales.size());
    for (std::size_t d = 0; d < std::min<std::size_t>(n_axes, 3); ++d)
      {
        const char axis = "xyz"[d];
        write(file,
              std::string("scale_") + axis,
              "m",
              std::string("scale of fluctuation in ") + axis +
                " of the first random field",
              collect(info, [d](const Info &s) {
                return d < s.scales.size() ? s.scales[d] : nan;
              }));
      }
    write(file,
          "scenario_hash",
          "1",
          "hash of all that decides the realisations",
          collect(info, [](const Info &s) { return s.hash; }));
  }


  void
  write_estimates(Hdf5File                  &file,
                  const CampaignInfo        &info,
                  const std::vector<Record> &records)
  {
    std::vector<std::vector<Record>> by_scenario(info.scenarios.size());
    for (const Record &record : records)
      by_scenario.at(record.scenario).push_back(record);
    std::vector<ScenarioEstimate> estimates;
    for (const std::vector<Record> &some : by_scenario)
      estimates.push_back(estimate(some));

    const auto write_count = [&](const std::string &name,
                                 const std::string &long_name,
                                 const auto        &count) {
      std::vector<std::int64_t> values;
      for (const ScenarioEstimate &e : estimates)
        values.push_back(static_cast<std::int64_t>(count(e)));
      write(file, name, "1", long_name, values);
    };
    using Scenario = ScenarioEstimate;
    write_count("n", "realisations that count", [](const Scenario &e) {
      return e.n;
    });
    write_count("n_S1", "initial failures", [](const Scenario &e) {
      return e.by_any.initial.count;
    });
    write_count("n_F", "floods", [](const Scenario &e) {
      return e.by_any.flooding.count;
    });

    struct Named
    {
      std::string name;
      std::string long_name;
      Proportion (*of)(const ScenarioEstimate &);
    };
    const std::vector<Named> proportions = {
      {"P_S1",
       "probability of initial failure",
       [](const Scenario &e) { return e.by_any.initial; }},
      {"P_S1_geometry",
       "probability of initial failure by width or height",
       [](const Scenario &e) { return e.by_geometry.initial; }},
      {"P_S1_thesis",
       "probability of initial failure as W < W_i",
       [](const Scenario &e) { return e.by_width.initial; }},
      {"P_S1_displacement",
       "probability of initial failure by displacement",
       [](const Scenario &e) { return e.by_displacement.initial; }},
      {"P_inner_slide",
       "probability of a slide of the inner slope by displacement",
       [](const Scenario &e) { return e.inner_slides; }},
      {"P_outer_slide",
       "probability of a slide of the outer slope by displacement",
       [](const Scenario &e) { return e.outer_slides; }},
      {"P_F",
       "probability of flooding",
       [](const Scenario &e) { return e.by_any.flooding; }},
      {"P_F_given_S1",
       "probability of flooding after initial failure",
       [](const Scenario &e) { return e.by_any.flooding_given; }},
      {"P_F_given_S1_thesis",
       "probability of flooding after initial failure as W < W_i",
       [](const Scenario &e) { return e.by_width.flooding_given; }}};
    for (const Named &named : proportions)
      {
        std::vector<BoundedProbability> values;
        for (const ScenarioEstimate &e : estimates)
          values.push_back(bounded(named.of(e)));
        write_probability(file, named.name, named.long_name, values);
      }

    const std::vector<FragilityPoint> points =
      fragility_points(info, by_scenario);
    std::vector<BoundedProbability> monotone;
    for (const ScenarioInfo &scenario : info.scenarios)
      {
        const auto point =
          std::find_if(points.begin(), points.end(), [&](const auto &p) {
            return p.water_level == scenario.water_level;
          });
        monotone.push_back(point != points.end()
                             ? flooding_curve(points).at(*point)
                             : BoundedProbability{nan, nan, nan});
      }
    write_probability(file,
                      "P_F_monotone",
                      "probability of flooding, made to rise with the water "
                      "level",
                      monotone);
  }
} // namespace Waker
