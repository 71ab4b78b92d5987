// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_results_store_h
#define waker_tests_results_store_h

#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/statistics/failure_class.h>
#include <waker/statistics/results_file.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "store_records.h"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

/// results.h5 of six records, opened with the C library.
namespace ResultsStore
{
  using namespace Waker;

  /// A store opened with the C library.
  class OpenStore
  {
  public:
    explicit OpenStore(const std::string &path)
      : file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT))
    {}

    ~OpenStore()
    {
      H5Fclose(file);
    }

    std::vector<hsize_t>
    sizes(const std::string &name) const
    {
      int rank = 0;
      H5LTget_dataset_ndims(file, name.c_str(), &rank);
      std::vector<hsize_t> sizes(rank);
      H5LTget_dataset_info(file, name.c_str(), sizes.data(), nullptr, nullptr);
      return sizes;
    }

    /// Any numbers.
    std::vector<double>
    values(const std::string &name) const
    {
      std::size_t n = 1;
      for (const hsize_t size : sizes(name))
        n *= size;
      std::vector<double> values(n);
      EXPECT_GE(H5LTread_dataset_double(file, name.c_str(), values.data()), 0);
      return values;
    }

    std::uint64_t
    count(const std::string &attribute) const
    {
      std::uint64_t value = 0;
      EXPECT_GE(H5LTget_attribute(
                  file, "/", attribute.c_str(), H5T_NATIVE_UINT64, &value),
                0);
      return value;
    }

    std::string
    text(const std::string &attribute) const
    {
      const hid_t id     = H5Aopen(file, attribute.c_str(), H5P_DEFAULT);
      const hid_t type   = H5Aget_type(id);
      char       *buffer = nullptr;
      EXPECT_GE(H5Aread(id, type, &buffer), 0);
      const std::string value = buffer == nullptr ? "" : buffer;
      H5free_memory(buffer);
      H5Tclose(type);
      H5Aclose(id);
      return value;
    }

  private:
    const hid_t file;
  };


  /// Scenario 0 has 0, 1, 2, 5; scenario 1 has 1 and 7.
  inline std::vector<Record>
  six_records()
  {
    return {synthetic_record(0, 0),
            synthetic_record(0, 1),
            synthetic_record(0, 2),
            synthetic_record(0, 5),
            synthetic_record(1, 1),
            synthetic_record(1, 7)};
  }


  const std::vector<double> realisations = {0., 1., 2., 5., 7.};


  inline void
  write(const std::string &path, const std::vector<Record> &records)
  {
    JournalCounts counts;
    counts.n_truncated   = 3;
    counts.n_damaged     = 4;
    counts.n_foreign     = 5;
    counts.n_repeated    = 6;
    counts.n_conflicting = 7;
    MachineUse use;
    use.machine.host   = "node7";
    use.n_realisations = 6;
    counts.machines    = {use};
    write_store(
      path, synthetic_campaign(), records, SlideParameters(), counts, 8);
  }
} // namespace ResultsStore

#endif
