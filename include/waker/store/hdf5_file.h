// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_hdf5_file_h
#define waker_store_hdf5_file_h

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace Waker
{
  /**
   * An HDF5 file with dimension scales, as netCDF-4 and xarray expect it. It
   * is made in memory: HDF5 cannot give up a file on a full disk cleanly
   * (closing it fails as well), and the same contents give the same bytes.
   *
   * Its functions throw std::runtime_error with the message of HDF5.
   */
  class Hdf5File
  {
  public:
    using Attribute  = std::variant<std::string,
                                   double,
                                   std::int8_t,
                                   std::int32_t,
                                   std::int64_t,
                                   std::uint64_t,
                                   std::vector<std::int8_t>>;
    using Attributes = std::vector<std::pair<std::string, Attribute>>;

    using Values = std::variant<std::vector<double>,
                                std::vector<std::int8_t>,
                                std::vector<std::int32_t>,
                                std::vector<std::int64_t>,
                                std::vector<std::string>>;

    Hdf5File();
    ~Hdf5File();

    Hdf5File(const Hdf5File &) = delete;
    Hdf5File &
    operator=(const Hdf5File &) = delete;

    /// Attributes of the whole file.
    void
    write_attributes(const Attributes &attributes);

    /// A dimension with the coordinates of its entries.
    void
    write_dimension(const std::string &name,
                    const Values      &coordinates,
                    const Attributes  &attributes);

    /**
     * A variable.
     *
     * @param dimensions names of dimensions written before, slowest first
     * @param values     as many as their sizes multiply to, last index fastest
     */
    void
    write_variable(const std::string              &name,
                   const std::vector<std::string> &dimensions,
                   const Values                   &values,
                   const Attributes               &attributes);

    /// Close the file.
    /// @return its bytes
    std::string
    close();

  private:
    using Handle = std::int64_t; // hid_t

    struct Dimension
    {
      std::string   name;
      std::uint64_t size;
      Handle        scale;
    };

    const Dimension &
    find_dimension(const std::string &name) const;

    Handle
    create_dataset(const std::string                &name,
                   const std::vector<std::uint64_t> &sizes,
                   const Values                     &values,
                   const Attributes                 &attributes);

    Handle                 file = -1;
    std::vector<Dimension> dimensions;
  };
} // namespace Waker

#endif
