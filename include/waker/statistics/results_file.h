// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_results_file_h
#define waker_statistics_results_file_h

#include <waker/statistics/slides.h>
#include <waker/store/campaign_info.h>
#include <waker/store/journal.h>
#include <waker/store/record.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Write results.h5: all records of a campaign but their traces, with slides
   * and failure classes, as HDF5 that xarray opens (engine h5netcdf). One
   * dataset per quantity, dimensions (scenario, realisation[, slide]), each
   * with units and long_name; realisations are the numbers that occur in any
   * scenario. NaN: the event did not occur, or the realisation was not run;
   * whole numbers have -1 for that. The file depends on the set of records,
   * not on their order, and appears complete or not at all.
   *
   * @param records   each realisation of a scenario once at most
   * @param counts    of the journals: what is missing for which reason
   * @param n_surplus records that the caller left out, as they came after the
   *        stop rule had been met
   * @throws UserError with the path if the disk is full or not writable, or a
   *         record belongs to no scenario
   */
  void
  write_store(const std::string         &path,
              const CampaignInfo        &info,
              const std::vector<Record> &records,
              const SlideParameters     &slide_parameters,
              const JournalCounts       &counts,
              const std::uint64_t        n_surplus = 0);
} // namespace Waker

#endif
