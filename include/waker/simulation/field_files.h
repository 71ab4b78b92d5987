// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_field_files_h
#define waker_simulation_field_files_h

#include <waker/observers/observer.h>
#include <waker/output/parameters.h>
#include <waker/output/pvd.h>
#include <waker/simulation/realisation.h>

#include <string>
#include <vector>

namespace Waker
{
  /// The ParaView files of a run: all series, each with a file for each moment
  /// that is written. Those with fields of the points are written by all ranks
  /// together, the others by the first one, which alone keeps the series.
  template <int dim>
  class FieldFiles
  {
  public:
    /// What a checkpoint stores: the files of each series, in the order of
    /// FieldSeries.
    using Entries = std::vector<std::vector<PvdEntry>>;

    /// @param output kept by reference
    explicit FieldFiles(const OutputParameters &output);

    /// Collective. The view has what wanted() says.
    void
    write(const StepView<dim> &view, const OwnPoints<dim> &own);

    /// What write() needs.
    Wanted
    wanted() const;

    Entries
    entries() const;

    /// Go on from a checkpoint. @return as PvdSeries::restore(), of all series
    std::vector<std::string>
    restore(const Entries &entries);

  private:
    /// Write a file with f(path), which returns its checksum, into a series.
    /// @param ranks that write it together
    template <typename Function>
    void
    add(const FieldSeries series,
        const double      time,
        const Function   &f,
        const MPI_Comm    ranks = MPI_COMM_SELF);

    void
    write_particles(const StepView<dim> &view, const OwnPoints<dim> &own);
    void
    write_surfaces(const StepView<dim> &view);
    void
    write_grid(const StepView<dim> &view);
    void
    write_top_view(const StepView<dim> &view, const OwnPoints<dim> &own);

    const OutputParameters &output;
    std::vector<PvdSeries>  series; // by FieldSeries
  };
} // namespace Waker

#endif
