// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/statistics/analysis_parameters.h>

namespace Waker
{
  using namespace dealii;

  void
  HistogramParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Width bin",
                      width_bin,
                      "Bins of the residual width and of the width after the "
                      "first slide (m), above 0; the first begins at 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Height bin",
                      height_bin,
                      "Bins of the residual height above the water (m), above "
                      "0; the first begins at 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Resistance bin",
                      resistance_bin,
                      "Bins of the width after the first slide (m), above 0, "
                      "in each of which the probability of flooding after "
                      "initial failure is estimated.",
                      Patterns::Double(0.));
  }


  void
  HistogramParameters::check() const
  {
    require_positive("Histograms/Width bin", width_bin);
    require_positive("Histograms/Height bin", height_bin);
    require_positive("Histograms/Resistance bin", resistance_bin);
  }


  void
  RiskParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Level distribution",
               distribution,
               "Of the highest water level of a year: none, Gumbel, or "
               "table (a file). With it the fragility curve of a sweep "
               "of water levels becomes a yearly probability.");
    prm.add_parameter("Gumbel location",
                      location,
                      "Location (mode) of Gumbel's distribution of the yearly "
                      "maximum (m).",
                      Patterns::Double());
    prm.add_parameter("Gumbel scale",
                      scale,
                      "Scale of Gumbel's distribution of the yearly maximum "
                      "(m), above 0 if it is used.",
                      Patterns::Double(0.));
    prm.add_parameter("Level table",
                      level_table,
                      "File with a line 'level,probability' for each of two "
                      "or more rising water levels (m): the probability per "
                      "year, falling and above 0, that it is exceeded. A line "
                      "of titles and lines that begin with # are skipped; "
                      "linear in the logarithm between the levels and beyond "
                      "them. A relative path begins in the folder in which "
                      "waker is started.",
                      Patterns::FileName(Patterns::FileName::input));
    prm.add_parameter("Allowed probability",
                      allowed_probability,
                      "Allowed probability of flooding P_s, 0 to 1 (per year "
                      "if there is a level distribution); 0: not known.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Share",
                      share,
                      "Share of P_s that macro-instability may take (-), 0 to "
                      "1, if it is divided among mechanisms beforehand.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Reserve",
                      reserve,
                      "Share of P_s kept for mechanisms that are not computed "
                      "(-), 0 to 1.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Consequence",
                      consequence,
                      "Damage of a flood (euro); 0: not known.",
                      Patterns::Double(0.));
    prm.add_parameter("Factor of safety",
                      factor_of_safety,
                      "Factor of safety of the dyke with its mean strength "
                      "everywhere (-): what is P(FoS < 1) by point statistics "
                      "alone? 0: not known.",
                      Patterns::Double(0.));
    prm.add_parameter("Strength variation",
                      strength_cov,
                      "Coefficient of variation of the strength of a point "
                      "(-), for the same question, above 0 if it is asked.",
                      Patterns::Double(0.));
    prm.add_parameter("Event tree length",
                      event_tree_length,
                      "Number of slides, 1 or more, after which the event tree "
                      "is cut off: the last one is assumed to flood.",
                      Patterns::Integer(1, 1000));
  }


  void
  RiskParameters::check() const
  {
    if (distribution == LevelSource::gumbel)
      require_positive("Risk/Gumbel scale", scale);
    if (distribution == LevelSource::table && level_table.empty())
      throw UserError("Risk/Level table",
                      "is empty, but the level distribution is a table",
                      "the name of a file");
    if (factor_of_safety > 0.)
      require_positive("Risk/Strength variation", strength_cov);
  }


  void
  AnalysisParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Slides");
    slides.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Histograms");
    histograms.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Risk");
    risk.add_parameters(prm);
    prm.leave_subsection();
  }


  void
  AnalysisParameters::check() const
  {
    slides.check();
    histograms.check();
    risk.check();
  }
} // namespace Waker
