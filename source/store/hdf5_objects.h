// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_store_hdf5_objects_h
#define waker_source_store_hdf5_objects_h

#include <cstdint>
#include <hdf5.h>
#include <stdexcept>
#include <string>

/// Thin cover of the C API of HDF5, private to the room.
namespace Waker::Hdf5
{
  // The first message of HDF5 says what failed, the calls above it do not.
  inline herr_t
  keep_first_message(unsigned int, const H5E_error2_t *error, void *message)
  {
    std::string &text = *static_cast<std::string *>(message);
    if (text.empty() && error->desc != nullptr)
      text = error->desc;
    return 0;
  }


  /// The value that a call of HDF5 returns, if it is good.
  template <typename Number>
  Number
  check(const Number result, const char *what)
  {
    if (result >= 0)
      return result;
    std::string message;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, &keep_first_message, &message);
    throw std::runtime_error(std::string("HDF5 cannot ") + what + ": " +
                             (message.empty() ? "no reason given" : message));
  }


  /// An object of HDF5 that is closed at the end of the block.
  class Owned
  {
  public:
    Owned(const hid_t id, herr_t (*close)(hid_t), const char *what)
      : id(check(id, what))
      , close(close)
    {}

    ~Owned()
    {
      close(id);
    }

    Owned(const Owned &) = delete;
    Owned &
    operator=(const Owned &) = delete;

    operator hid_t() const
    {
      return id;
    }

  private:
    const hid_t id;
    herr_t (*const close)(hid_t);
  };


  /// Types on the disk and in memory.
  struct Types
  {
    hid_t file;
    hid_t memory;
  };

  inline Types
  types_of(const double)
  {
    return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE};
  }

  inline Types
  types_of(const std::int8_t)
  {
    return {H5T_STD_I8LE, H5T_NATIVE_INT8};
  }

  inline Types
  types_of(const std::int32_t)
  {
    return {H5T_STD_I32LE, H5T_NATIVE_INT32};
  }

  inline Types
  types_of(const std::int64_t)
  {
    return {H5T_STD_I64LE, H5T_NATIVE_INT64};
  }

  inline Types
  types_of(const std::uint64_t)
  {
    return {H5T_STD_U64LE, H5T_NATIVE_UINT64};
  }


  /// Text of any length: an attribute of fixed length ends at 64 KB.
  inline hid_t
  create_text_type()
  {
    const hid_t type = check(H5Tcopy(H5T_C_S1), "make a type of text");
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
  }
} // namespace Waker::Hdf5

#endif
