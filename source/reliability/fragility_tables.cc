// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/reliability/csv_table.h>
#include <waker/reliability/report_tables.h>

namespace Waker
{
  namespace ReportTables
  {
    std::string
    fragility(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("water_level,freeboard,n" + titles_of("P_S1") +
                     ",beta_S1" + titles_of("P_F") + ",beta_F");
      for (const FragilityPoint &point : points)
        {
          table.row().cell(point.water_level).cell(point.freeboard);
          table.cell(point.flooding.n).cells(point.initial);
          table.cell(reliability_index(point.initial.estimate));
          table.cells(point.flooding);
          table.cell(reliability_index(point.flooding.estimate));
        }
      return table.finish();
    }


    std::string
    fragility_curve(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("water_level" + titles_of("P_S1") + ",beta_S1" +
                     titles_of("P_F") + ",beta_F");
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
            {
              const BoundedProbability p = curve->at(level);
              table.cell(p.estimate).cell(p.low).cell(p.high);
              table.cell(reliability_index(p.estimate));
            }
        }
      return table.finish();
    }


    std::string
    fragility_beta(const std::vector<FragilityPoint> &points)
    {
      CsvTable table("water_level,beta");
      if (points.empty())
        return table.finish();
      const BoundedCurve curve = flooding_curve(points);
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          const double p      = curve.estimate.values[i];
          const double finite = p <= 0.   ? curve.high.values[i]
                                : p >= 1. ? curve.low.values[i]
                                          : p;
          table.row().cell(points[i].water_level);
          table.cell(reliability_index(finite));
        }
      return table.finish();
    }
  } // namespace ReportTables
} // namespace Waker
