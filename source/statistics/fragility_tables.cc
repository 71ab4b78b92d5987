// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/csv_table.h>
#include <waker/statistics/report_tables.h>

namespace Waker
{
  namespace
  {
    std::string
    titles_with_index(const std::string &event)
    {
      return titles_of("P_" + event) + ",beta_" + event + ",beta_" + event +
             "_low,beta_" + event + "_high";
    }


    void
    add_with_index(CsvTable &table, const BoundedProbability &p)
    {
      const BoundedIndex beta = reliability_index(p);
      table.cells(p).cell(beta.estimate).cell(beta.low).cell(beta.high);
    }


    /// What beta is where the probability is so.
    EstimateKind
    kind_of_index(const double probability)
    {
      const EstimateKind kind = kind_of(probability);
      return kind == EstimateKind::upper_bound   ? EstimateKind::lower_bound
             : kind == EstimateKind::lower_bound ? EstimateKind::upper_bound
                                                 : kind;
    }
  } // namespace


  namespace ReportTables
  {
    std::string
    fragility(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("water_level,freeboard,n,n_S1" + titles_with_index("S1") +
                     ",n_F" + titles_with_index("F") +
                     titles_with_index("F_monotone") +
                     ",n_undecided,n_S1_not_final,P_S1_if_none_failed_low,"
                     "P_S1_if_all_failed_high,P_F_if_none_failed_low,"
                     "P_F_if_all_failed_high");
      if (points.empty())
        return table.finish();
      const BoundedCurve monotone = flooding_curve(points);
      for (const FragilityPoint &point : points)
        {
          table.row().cell(point.water_level).cell(point.freeboard);
          table.cell(point.flooding.n).cell(point.initial.count);
          add_with_index(table, bounded(point.initial));
          table.cell(point.flooding.count);
          add_with_index(table, bounded(point.flooding));
          add_with_index(table, monotone.at(point));
          table.cell(point.n_lost).cell(point.n_not_final);
          for (const auto &[p, bounds] :
               {std::pair(point.initial, point.initial_bounds),
                std::pair(point.flooding, point.flooding_bounds)})
            table.cell(bounds ? bounds->low : p.low)
              .cell(bounds ? bounds->high : p.high);
        }
      return table.finish();
    }


    std::string
    fragility_curve(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("water_level" + titles_with_index("S1") +
                     titles_with_index("F"));
      if (points.empty())
        return table.finish();
      const BoundedCurve initial  = initial_failure_curve(points);
      const BoundedCurve flooding = flooding_curve(points);
      const double       first    = points.front().water_level;
      const double       range    = points.back().water_level - first;

      const unsigned int n_intervals = range > 0. ? 100 : 0;
      for (unsigned int i = 0; i <= n_intervals; ++i)
        {
          const double level =
            n_intervals == 0 ? first : first + range * i / n_intervals;
          table.row().cell(level);
          for (const BoundedCurve *const curve : {&initial, &flooding})
            add_with_index(table, curve->at(level));
        }
      return table.finish();
    }


    std::string
    fragility_beta(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("water_level,beta,beta_low,beta_high,kind");
      if (points.empty())
        return table.finish();
      const BoundedCurve curve = flooding_curve(points);
      for (const FragilityPoint &point : points)
        {
          const BoundedProbability p    = curve.at(point);
          const BoundedIndex       beta = reliability_index(p);
          table.row().cell(point.water_level).cell(beta.estimate);
          table.cell(beta.low).cell(beta.high);
          table.cell(to_string(kind_of_index(p.estimate)));
        }
      return table.finish();
    }


    std::string
    fragility_export(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("hydraulicload,failure_probability");
      if (points.empty())
        return table.finish();
      const BoundedCurve curve = flooding_curve(points);
      for (const FragilityPoint &point : points)
        {
          const BoundedProbability p = curve.at(point);
          if (kind_of(p.estimate) == EstimateKind::estimate)
            table.row().cell(point.water_level).cell(p.estimate);
        }
      return table.finish();
    }


    std::string
    fragility_export_upper(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("hydraulicload,failure_probability");
      if (points.empty())
        return table.finish();
      const BoundedCurve curve = flooding_curve(points);
      for (std::size_t i = 0; i < points.size(); ++i)
        table.row().cell(points[i].water_level).cell(curve.high.values[i]);
      return table.finish();
    }
  } // namespace ReportTables
} // namespace Waker
