// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/statistics/columns.h>
#include <waker/statistics/mass_class.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    using A = AnalysedRecord;


    /// Of a record that does not know sliding masses there is nothing to say.
    template <typename Function>
    double
    of_sliding(const A &a, const Function &f)
    {
      return a.record->sliding_masses ? f(*a.record->sliding_masses) : nan;
    }


    /// Of the first mass, if there is one.
    template <typename Function>
    double
    of_first_mass(const A &a, const Function &f)
    {
      return of_sliding(a, [&](const SlidingMasses &s) {
        return s.masses.empty() ? nan : f(s.masses.front());
      });
    }


    /// -1: they were not watched.
    std::int32_t
    count(const A &a, const MassClass mass_class)
    {
      if (!a.record->sliding_masses)
        return -1;
      const std::vector<MassClass> classes =
        classify_masses(*a.record->sliding_masses);
      return static_cast<std::int32_t>(
        std::count(classes.begin(), classes.end(), mass_class));
    }
  } // namespace



  const std::vector<Column<AnalysedRecord, std::int32_t>>
    sliding_count_columns = {
      {"n_masses",
       "1",
       "number of sliding masses",
       [](const A &a) {
         return a.record->sliding_masses
                  ? static_cast<std::int32_t>(
                      a.record->sliding_masses->masses.size())
                  : std::int32_t(-1);
       }},
      {"n_masses_remnant",
       "1",
       "of which beside the sheared face of the first, or small",
       [](const A &a) { return count(a, MassClass::remnant); }},
      {"n_masses_side",
       "1",
       "of which beside the first along the slope",
       [](const A &a) { return count(a, MassClass::side); }},
      {"n_masses_behind_centred",
       "1",
       "of which behind the first, centred on it",
       [](const A &a) { return count(a, MassClass::behind_centred); }},
      {"n_masses_behind_off_centre",
       "1",
       "of which behind the first, off its centre",
       [](const A &a) { return count(a, MassClass::behind_off_centre); }}};



  const std::vector<Column<AnalysedRecord, double>> sliding_columns = {
    {"residual_width_z",
     "m",
     "z of the narrowest section at the end; 3D",
     [](const A &a) { return a.record->residual_width_z.value_or(nan); }},
    {"residual_height_z",
     "m",
     "z of the lowest section at the end; 3D",
     [](const A &a) { return a.record->residual_height_z.value_or(nan); }},
    {"load",
     "1",
     "factor of the first load programme at the end, in its unit (m of soil)",
     [](const A &a) { return a.record->load.value_or(nan); }},
    {"load_stop_time",
     "s",
     "when that was stopped for good: then it is the ultimate load; -1: never",
     [](const A &a) { return a.record->load_stop_time.value_or(nan); }},
    {"body_volume",
     "m3",
     "volume of the whole body at t = 0; in 2D of 1 m of it",
     [](const A &a) {
       return of_sliding(a, [](const auto &s) { return s.whole_volume; });
     }},
    {"stable_volume",
     "m3",
     "volume that has not become a sliding mass",
     [](const A &a) {
       return of_sliding(a, [](const auto &s) { return s.stable_volume(); });
     }},
    {"relative_failure_volume",
     "1",
     "volume of all sliding masses, of that of the body",
     [](const A &a) {
       return of_sliding(a, [](const auto &s) {
         return s.relative_failure_volume();
       });
     }},
    {"retrogression_distance",
     "m",
     "largest distance from the edge of the crest to its first stable soil",
     [](const A &a) {
       return of_sliding(a, [](const auto &s) { return s.retrogression; });
     }},
    {"damaged_crest_width",
     "m",
     "length along z at which some of the crest has failed; 3D",
     [](const A &a) {
       return of_sliding(a,
                         [](const auto &s) { return s.damaged_crest_width; });
     }},
    {"first_mass_time",
     "s",
     "time at which the first sliding mass broke loose",
     [](const A &a) {
       return of_first_mass(a, [](const auto &m) { return m.time; });
     }},
    {"first_mass_volume",
     "m3",
     "its volume",
     [](const A &a) {
       return of_first_mass(a, [](const auto &m) { return m.volume; });
     }},
    {"first_mass_width", "m", "its length along z; 3D", [](const A &a) {
       return of_first_mass(a, [](const auto &m) { return m.width; });
     }}};



  const std::vector<Column<SlidingMass, double>> mass_columns = {
    {"mass_time",
     "s",
     "time at which the mass broke loose",
     [](const SlidingMass &m) { return m.time; }},
    {"mass_volume",
     "m3",
     "its volume; in 2D of 1 m of it",
     [](const SlidingMass &m) { return m.volume; }},
    {"mass_width",
     "m",
     "its length along z; 3D",
     [](const SlidingMass &m) { return m.width; }},
    {"mass_x",
     "m",
     "x of its centre at t = 0",
     [](const SlidingMass &m) { return m.centre[0]; }},
    {"mass_y",
     "m",
     "y of its centre at t = 0",
     [](const SlidingMass &m) { return m.centre[1]; }},
    {"mass_z",
     "m",
     "z of its centre at t = 0; 3D",
     [](const SlidingMass &m) { return m.centre[2]; }},
    {"mass_x_from",
     "m",
     "least x of it at t = 0",
     [](const SlidingMass &m) { return m.lower[0]; }},
    {"mass_x_to",
     "m",
     "largest x of it at t = 0",
     [](const SlidingMass &m) { return m.upper[0]; }},
    {"mass_z_from",
     "m",
     "least z of it at t = 0; 3D",
     [](const SlidingMass &m) { return m.lower[2]; }},
    {"mass_z_to",
     "m",
     "largest z of it at t = 0; 3D",
     [](const SlidingMass &m) { return m.upper[2]; }}};
} // namespace Waker
