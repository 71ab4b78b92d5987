// SPDX-License-Identifier: LGPL-2.1-or-later
#include "follow.h"

#include <waker/base/file_error.h>
#include <waker/base/ranks.h>
#include <waker/output/checkpoint.h>
#include <waker/output/output_files.h>
#include <waker/output/point_arrays.h>
#include <waker/simulation/field_files.h>
#include <waker/simulation/run_to_end.h>

#include <filesystem>

namespace Waker
{
  template <int dim>
  void
  share_state(const MPI_Comm communicator, State<dim> &state)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    const bool        is_first = is_first_rank(communicator);
    const std::string record =
      shared(is_first
               ? state.write_record(
                   array_sizes(state.points, OwnRows(state.points.n_points())))
               : std::string(),
             communicator);
    if (!is_first)
      state.read_record(record);
    // Array after array, of values, whose number MPI can count.
    MaterialPoints<dim>::for_each_array(
      state.points, [&](const char *, auto &array) {
        const MpiBytes value(sizeof(array[0]));
        MPI_Bcast(array.data(),
                  static_cast<int>(array.size()),
                  value.type,
                  0,
                  communicator);
      });
  }


  void
  require_shared_folder(const MPI_Comm     communicator,
                        const std::string &directory)
  {
    if (n_ranks(communicator) == 1)
      return;
    const std::string path =
      shared(file_path(directory, OutputFile::parameters), communicator);
    std::error_code    error;
    const unsigned int n_blind =
      Utilities::MPI::sum(std::filesystem::exists(path, error) ? 0u : 1u,
                          communicator);
    if (n_blind > 0)
      throw UserError("Output/Directory",
                      "'" + path + "' is not seen by " +
                        std::to_string(n_blind) + " of the " +
                        std::to_string(n_ranks(communicator)) +
                        " ranks, which write files together",
                      "a folder that all machines see, by the same path");
  }


  void
  throw_of_a_begun_run(const UserError &error, const std::string &directory)
  {
    if (error.where == "Output/Directory")
      throw FileError(directory, error.problem);
    throw error;
  }


  namespace
  {
    /// On a rank after the first: it writes what all write together.
    template <int dim>
    class FileWatcher : public Watcher
    {
    public:
      FileWatcher(const OutputParameters &output,
                  const Realisation<dim> &realisation)
        : realisation(realisation)
        , fields(output)
        , slots("", "") // those of the first rank
      {}

      void
      write_files() override
      {
        fields.write(realisation.view(), realisation.own());
      }

      void
      write_checkpoint() override
      {
        const OwnPoints<dim> own = realisation.own();
        slots.write(0, {}, own.points, own.rows);
      }

    private:
      const Realisation<dim> &realisation;
      FieldFiles<dim>         fields;
      CheckpointSlots         slots;
    };
  } // namespace


  template <int dim>
  RunStatus
  follow(const Parameters        &parameters,
         const RunOptions        &options,
         const MPI_Comm           communicator,
         const InitialSetup<dim> &setup)
  {
    try
      {
        Case<dim>  the_case(parameters, communicator);
        State<dim> state;
        if (setup)
          {
            state = initial_state(the_case);
            setup(the_case, state);
          }
        if (options.validate_only)
          return RunStatus::completed;
        // From now on a signal is seen by all ranks together.
        if (options.before_writing)
          options.before_writing();
        if (setup || options.resume)
          the_case.take_initial_points(); // their memory
        else
          state = initial_state(the_case, the_case.take_initial_points());
        if (options.resume)
          share_state(communicator, state);
        require_shared_folder(communicator, "");
        Realisation<dim> realisation(the_case, state);
        FileWatcher<dim> watcher(the_case.parameters.output, realisation);
        try
          {
            return run_to_end(realisation, watcher, options.interrupt) ==
                       StopReason::none
                     ? RunStatus::interrupted
                     : RunStatus::completed;
          }
        catch (const UserError &error)
          {
            throw_of_a_begun_run(error, parameters.output.directory);
          }
        catch (const NumericalFailure &)
          {
            if (realisation.has_numbers())
              watcher.write_checkpoint();
            throw;
          }
      }
    catch (const NumericalFailure &)
      {
        return RunStatus::numerical_failure;
      }
  }


  template void
  share_state(const MPI_Comm, State<2> &);
  template void
  share_state(const MPI_Comm, State<3> &);
  template RunStatus
  follow(const Parameters &,
         const RunOptions &,
         const MPI_Comm,
         const InitialSetup<2> &);
  template RunStatus
  follow(const Parameters &,
         const RunOptions &,
         const MPI_Comm,
         const InitialSetup<3> &);
} // namespace Waker
