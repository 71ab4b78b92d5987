// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_factor_search_h
#define waker_simulation_factor_search_h

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// What a trial of a strength reduction has shown.
  enum class TrialResult
  {
    stable,
    failed,
    undecided // it failed numerically, or moved still when it ended
  };

  std::string
  to_string(const TrialResult result);


  /**
   * The search for the factor between those that are stable and those that
   * fail: first its two ends, then halving. A factor that remains undecided
   * belongs to neither side: the search goes on in the gaps beside it, the
   * widest first, and gives up after `max_undecided` of them.
   */
  class FactorSearch
  {
  public:
    static constexpr unsigned int max_undecided = 8;

    /// @param lower, upper ends of the bracket (-)
    /// @param tolerance the bracket's width when the search is done (-)
    FactorSearch(const double lower,
                 const double upper,
                 const double tolerance);

    /// The factor to try next; none when the search is over.
    std::optional<double>
    next() const;

    /// What became of next().
    void
    add(const TrialResult result);

    /// None as long as no factor was stable (failed).
    std::optional<double>
    highest_stable() const;

    std::optional<double>
    lowest_failed() const;

    /// Between the two, ascending.
    const std::vector<double> &
    undecided() const
    {
      return between;
    }

    /// The middle of the bracket, if it is as narrow as it should be.
    std::optional<double>
    factor() const;

    /// Halvings that are left if all trials decide.
    unsigned int
    n_left() const;

  private:
    double                lower, upper, tolerance;
    std::optional<double> stable, failed;
    std::vector<double>   between;
    bool                  has_ended = false; // an end is not what it should be
  };
} // namespace Waker

#endif
