// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/store/hdf5_file.h>

#include "hdf5_objects.h"
#include <algorithm>
#include <hdf5_hl.h>
#include <stdexcept>
#include <type_traits>

namespace Waker
{
  using namespace Hdf5;

  static_assert(std::is_same<hid_t, std::int64_t>::value,
                "Handle must be the hid_t of HDF5");

  namespace
  {
    // Entries of a chunk: 128 KB of double.
    constexpr std::uint64_t chunk_size = 16384;

    void
    write_attribute(const hid_t        object,
                    const std::string &name,
                    const hid_t        space,
                    const Types       &types,
                    const void        *data)
    {
      const Owned attribute(
        H5Acreate2(
          object, name.c_str(), types.file, space, H5P_DEFAULT, H5P_DEFAULT),
        &H5Aclose,
        "make an attribute");
      check(H5Awrite(attribute, types.memory, data), "write an attribute");
    }


    void
    write_attribute(const hid_t        object,
                    const std::string &name,
                    const std::string &value)
    {
      const Owned       space(H5Screate(H5S_SCALAR), &H5Sclose, "make a space");
      const Owned       type(create_text_type(), &H5Tclose, "make a type");
      const char *const data = value.c_str();
      write_attribute(object, name, space, {type, type}, &data);
    }


    void
    write_attribute(const hid_t                     object,
                    const std::string              &name,
                    const std::vector<std::int8_t> &values)
    {
      const hsize_t size = values.size();
      const Owned   space(H5Screate_simple(1, &size, nullptr),
                        &H5Sclose,
                        "make a space");
      write_attribute(
        object, name, space, types_of(std::int8_t()), values.data());
    }


    template <typename Number>
    void
    write_attribute(const hid_t        object,
                    const std::string &name,
                    const Number      &value)
    {
      const Owned space(H5Screate(H5S_SCALAR), &H5Sclose, "make a space");
      write_attribute(object, name, space, types_of(value), &value);
    }


    void
    write_all(const hid_t object, const Hdf5File::Attributes &attributes)
    {
      for (const auto &attribute : attributes)
        std::visit(
          [&](const auto &value) {
            write_attribute(object, attribute.first, value);
          },
          attribute.second);
    }


    void
    write_values(const hid_t dataset, const std::vector<std::string> &values)
    {
      const Owned type(create_text_type(), &H5Tclose, "make a type");
      std::vector<const char *> pointers;
      for (const std::string &value : values)
        pointers.push_back(value.c_str());
      check(
        H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()),
        "write texts");
    }


    template <typename Number>
    void
    write_values(const hid_t dataset, const std::vector<Number> &values)
    {
      check(H5Dwrite(dataset,
                     types_of(Number()).memory,
                     H5S_ALL,
                     H5S_ALL,
                     H5P_DEFAULT,
                     values.data()),
            "write numbers");
    }
  } // namespace



  Hdf5File::Hdf5File()
  {
    // We report errors ourselves.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);

    const Owned access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose, "make a list");
    // In memory, 16 MB at a time, never on the disk.
    check(H5Pset_fapl_core(access, std::size_t(1) << 24, false),
          "make a file in memory");
    const Owned creation(H5Pcreate(H5P_FILE_CREATE), &H5Pclose, "make a list");
    check(H5Pset_obj_track_times(creation, false), "leave times out");
    file = check(H5Fcreate("waker.h5", H5F_ACC_TRUNC, creation, access),
                 "make a file in memory");
  }



  Hdf5File::~Hdf5File()
  {
    for (const Dimension &dimension : dimensions)
      H5Dclose(dimension.scale);
    if (file >= 0)
      H5Fclose(file);
  }



  void
  Hdf5File::write_attributes(const Attributes &attributes)
  {
    write_all(file, attributes);
  }



  void
  Hdf5File::write_dimension(const std::string &name,
                            const Values      &coordinates,
                            const Attributes  &attributes)
  {
    const std::uint64_t size =
      std::visit([](const auto &list) { return list.size(); }, coordinates);
    const Handle scale = create_dataset(name, {size}, coordinates, attributes);
    dimensions.push_back({name, size, scale});
    check(H5DSset_scale(scale, name.c_str()), "make a dimension");
  }



  void
  Hdf5File::write_variable(const std::string              &name,
                           const std::vector<std::string> &dimension_names,
                           const Values                   &values,
                           const Attributes               &attributes)
  {
    std::vector<std::uint64_t> sizes;
    for (const std::string &dimension : dimension_names)
      sizes.push_back(find_dimension(dimension).size);
    const Owned dataset(create_dataset(name, sizes, values, attributes),
                        &H5Dclose,
                        "make a variable");
    for (unsigned int d = 0; d < dimension_names.size(); ++d)
      check(H5DSattach_scale(dataset,
                             find_dimension(dimension_names[d]).scale,
                             d),
            "attach a dimension");
  }



  std::string
  Hdf5File::close()
  {
    for (const Dimension &dimension : dimensions)
      H5Dclose(dimension.scale);
    dimensions.clear();

    check(H5Fflush(file, H5F_SCOPE_GLOBAL), "finish the file");
    const ssize_t size =
      check(H5Fget_file_image(file, nullptr, 0), "tell the size of the file");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    check(H5Fget_file_image(file, bytes.data(), bytes.size()), "copy the file");
    check(H5Fclose(file), "close the file");
    file = -1;
    return bytes;
  }



  const Hdf5File::Dimension &
  Hdf5File::find_dimension(const std::string &name) const
  {
    for (const Dimension &dimension : dimensions)
      if (dimension.name == name)
        return dimension;
    throw std::runtime_error("no dimension '" + name + "'");
  }



  Hdf5File::Handle
  Hdf5File::create_dataset(const std::string                &name,
                           const std::vector<std::uint64_t> &sizes,
                           const Values                     &values,
                           const Attributes                 &attributes)
  {
    const std::vector<hsize_t> extents(sizes.begin(), sizes.end());
    hsize_t                    n_entries = 1;
    for (const hsize_t extent : extents)
      n_entries *= extent;
    if (n_entries !=
        std::visit([](const auto &list) { return list.size(); }, values))
      throw std::runtime_error("values of '" + name +
                               "' do not fill its dimensions");

    const Owned space(H5Screate_simple(static_cast<int>(extents.size()),
                                       extents.data(),
                                       nullptr),
                      &H5Sclose,
                      "make a space");
    const Owned list(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose, "make a list");
    check(H5Pset_obj_track_times(list, false), "leave times out");
    // Texts lie elsewhere in the file; little is not worth a chunk.
    if (!std::holds_alternative<std::vector<std::string>>(values) &&
        n_entries > 0 && extents.size() > 1)
      {
        std::vector<hsize_t> chunk = extents;
        chunk[0]                   = 1;
        hsize_t others             = 1;
        for (std::size_t d = 2; d < chunk.size(); ++d)
          others *= chunk[d];
        chunk[1] = std::clamp<hsize_t>(chunk_size / others, 1, extents[1]);
        check(H5Pset_chunk(list, static_cast<int>(chunk.size()), chunk.data()),
              "set chunks");
        check(H5Pset_shuffle(list), "set the compression");
        check(H5Pset_deflate(list, 4), "set the compression");
      }

    const auto create = [&](const hid_t type) {
      return check(
        H5Dcreate2(
          file, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT),
        "make a dataset");
    };
    const Handle dataset = std::visit(
      [&](const auto &entries) {
        using Entry = typename std::decay_t<decltype(entries)>::value_type;
        if constexpr (std::is_same<Entry, std::string>::value)
          {
            const Owned type(create_text_type(), &H5Tclose, "make a type");
            return create(type);
          }
        else
          return create(types_of(Entry()).file);
      },
      values);
    try
      {
        if (n_entries > 0)
          std::visit([&](
                       const auto &entries) { write_values(dataset, entries); },
                     values);
        write_all(dataset, attributes);
      }
    catch (...)
      {
        H5Dclose(dataset);
        throw;
      }
    return dataset;
  }
} // namespace Waker
