// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_analysis_parameters_h
#define waker_statistics_analysis_parameters_h

#include <waker/statistics/slides.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// Section "Histograms": widths of bins, all starting at 0.
  struct HistogramParameters
  {
    double width_bin  = 0.5;  // m, of W_r and W_S1
    double height_bin = 0.05; // m, of H_r - h
    /// m, of W_S1 in P(F|S1, W_S1): fewer and wider, as each needs an interval
    double resistance_bin = 1.;

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @throws UserError "Histograms/..."
    void
    check() const;
  };

  /// What is known of the yearly maximum of the water level.
  enum class LevelSource
  {
    none,
    gumbel, // a distribution
    table   // a file
  };

  constexpr const char *
  name_of(const LevelSource choice)
  {
    switch (choice)
      {
        case LevelSource::none:
          return "none";
        case LevelSource::gumbel:
          return "Gumbel";
        case LevelSource::table:
          return "table";
      }
    return nullptr;
  }


  /// Section "Risk" (chapter 4 of Remmerswaal 2023). Zero: not known.
  struct RiskParameters
  {
    LevelSource distribution = LevelSource::none;
    double      location     = 0.; // m, of Gumbel's
    double      scale        = 0.; // m
    std::string level_table;       // file of levels and exceedance

    double allowed_probability = 0.;   // P_s (per year)
    double share               = 0.04; // w of macro-instability (4.9)
    double reserve             = 0.30; // of P_s for what is not computed (4.8)
    double consequence         = 0.;   // C(F), euro (4.1)

    double factor_of_safety = 0.; // of the dyke with its mean strength
    double strength_cov     = 0.; // of a point (-)

    unsigned int event_tree_length = 4; // l of (4.24); at least 1

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @throws UserError "Risk/..."
    void
    check() const;
  };

  /// What is made of the records of a campaign. None of it decides how a
  /// realisation is computed: it may change from one merge to the next.
  struct AnalysisParameters
  {
    SlideParameters     slides;     // section "Slides"
    HistogramParameters histograms; // section "Histograms"
    RiskParameters      risk;       // section "Risk"

    /// Declares the three sections, in the current one.
    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @throws UserError with the path of the parameter
    void
    check() const;
  };
} // namespace Waker

#endif
