// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_output_temporary_folder_h
#define waker_tests_output_temporary_folder_h

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdlib.h>
#include <string>

namespace Waker
{
  /// A folder of its own for each test, gone at its end.
  class TemporaryFolder
  {
  public:
    TemporaryFolder()
    {
      std::string name =
        (std::filesystem::temp_directory_path() / "waker-test-XXXXXX").string();
      path = ::mkdtemp(name.data());
    }

    ~TemporaryFolder()
    {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }

    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &
    operator=(const TemporaryFolder &) = delete;

    std::string
    file(const std::string &name) const
    {
      return path + "/" + name;
    }

    std::string path;
  };


  inline void
  put(const std::string &path, const std::string &text)
  {
    std::filesystem::create_directories(
      std::filesystem::path(path).parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }


  /// Writes a text to a file of this process, gone at its end; a file of the
  /// same name is replaced. @return its path
  inline std::string
  put_for_process(const std::string &name, const std::string &text)
  {
    static const TemporaryFolder folder;
    put(folder.file(name), text);
    return folder.file(name);
  }


  inline std::string
  get(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
} // namespace Waker

#endif
