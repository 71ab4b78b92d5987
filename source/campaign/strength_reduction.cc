// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/campaign/realisation_setup.h>
#include <waker/campaign/strength_reduction.h>

namespace Waker
{
  template <int dim>
  RunStatus
  reduce_strengths(const Input                        &input,
                   const std::optional<std::uint64_t> &realisation,
                   const std::uint64_t                 scenario,
                   const std::string                  &directory,
                   const RunOptions                   &options,
                   const MPI_Comm                      communicator)
  {
    StrengthsToReduce<dim> strengths;
    if (realisation)
      {
        strengths.name = realisation_title(input, *realisation);
        strengths.setup =
          realisation_setup<dim>(input, *realisation, strengths.name);
      }
    else if (!input.reliability.fields.fields.empty())
      {
        strengths.name  = "means of the random fields";
        strengths.setup = means_setup<dim>(input);
      }
    if (!input.reliability.sweep.parameter.empty())
      strengths.name += ", scenario " + std::to_string(scenario);
    strengths.attempts = input.reliability.campaign.attempts;
    strengths.key      = input.campaign_hash;

    Parameters parameters = input.simulation;
    parameters.text =
      "# Strength reduction of: " + strengths.name + "\n" + parameters.text;
    parameters.output.directory = directory;
    return run_strength_reduction<dim>(parameters,
                                       options,
                                       communicator,
                                       strengths);
  }


  template RunStatus
  reduce_strengths<2>(const Input &,
                      const std::optional<std::uint64_t> &,
                      const std::uint64_t,
                      const std::string &,
                      const RunOptions &,
                      const MPI_Comm);
  template RunStatus
  reduce_strengths<3>(const Input &,
                      const std::optional<std::uint64_t> &,
                      const std::uint64_t,
                      const std::string &,
                      const RunOptions &,
                      const MPI_Comm);
} // namespace Waker
