// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_campaign_parameters_h
#define waker_campaign_campaign_parameters_h

#include <cstdint>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// The probability that a campaign's stop rules look at.
  enum class CampaignTarget
  {
    flooding,
    initial_failure
  };

  constexpr const char *
  name_of(const CampaignTarget choice)
  {
    switch (choice)
      {
        case CampaignTarget::flooding:
          return "flooding";
        case CampaignTarget::initial_failure:
          return "initial failure";
      }
    return nullptr;
  }


  /// Section "Campaign".
  struct CampaignParameters
  {
    std::uint64_t seed         = 1;
    std::uint64_t realisations = 200; // N, at most, per scenario
    /// Realisations between two looks at the stop rules, and at what other
    /// processes have done.
    std::uint64_t batch = 50;
    /// A realisation that fails numerically is begun again with half the time
    /// step, up to this number of times in all.
    unsigned int attempts = 3;
    /// Between two checkpoints of a realisation under way, s of wall time; 0:
    /// none.
    double checkpoint_interval = 30.;
    /// That compute each realisation together.
    unsigned int ranks_per_realisation = 1;

    // When to stop before N; 0: not for this reason.
    CampaignTarget target                   = CampaignTarget::flooding;
    double         coefficient_of_variation = 0.;
    double         interval_width           = 0.;
    std::uint64_t  initial_failures         = 0;
    std::uint64_t  minimum_realisations     = 0;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Campaign/..."
    void
    check() const;
  };

  /// Section "Sweep": scenarios that differ in one parameter.
  struct SweepParameters
  {
    std::string parameter; // "Water/Level"; empty: one scenario
    std::string values;    // "4.75; 4.5"

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Sweep/..."
    void
    check() const;
    /// One text per scenario; a single empty one without a sweep.
    std::vector<std::string>
    list() const;
  };

  /// Section "Snapshots": realisations that are run again with full output.
  struct SnapshotParameters
  {
    unsigned int              first           = 0; // of each scenario
    unsigned int              of_each_outcome = 0; // lowest numbers
    std::vector<unsigned int> realisations;        // these

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace Waker

#endif
