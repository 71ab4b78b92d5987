// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/version.h>
#include <waker/output/checkpoint.h>
#include <waker/output/files.h>
#include <waker/output/free_at_resume.h>
#include <waker/output/output_files.h>
#include <waker/output/parameter_differences.h>

#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace Waker
{
  namespace
  {
    const std::string magic = "WAKERCP\n";

    // Places in the part of the file that never changes.
    constexpr std::size_t schema_at  = 8;
    constexpr std::size_t crc_at     = 12;
    constexpr std::size_t size_at    = 16;
    constexpr std::size_t payload_at = 24;

    template <typename Number>
    void
    append_number(std::string &text, const Number value)
    {
      for (std::size_t i = 0; i < sizeof(Number); ++i)
        text += static_cast<char>((value >> (8 * i)) & 0xffu);
    }


    template <typename Number>
    Number
    number_at(const std::string &text, const std::size_t at)
    {
      Number value = 0;
      for (std::size_t i = 0; i < sizeof(Number); ++i)
        value |= static_cast<Number>(static_cast<unsigned char>(text[at + i]))
                 << (8 * i);
      return value;
    }


    void
    append_text(std::string &text, const std::string &part)
    {
      append_number(text, static_cast<std::uint64_t>(part.size()));
      text += part;
    }


    /// Of the schema version and of all that stands behind the CRC itself.
    std::uint32_t
    checksum(const std::string &file)
    {
      boost::crc_32_type crc;
      crc.process_bytes(file.data() + schema_at, crc_at - schema_at);
      crc.process_bytes(file.data() + size_at, file.size() - size_at);
      return crc.checksum();
    }


    enum class SlotState
    {
      missing,
      damaged,
      newer_schema,
      good
    };


    /// @param checkpoint filled if the slot is good
    SlotState
    parse(const std::string &path, Checkpoint &checkpoint)
    {
      if (!std::filesystem::exists(path))
        return SlotState::missing;
      const std::string file = read_file(path);
      if (file.size() < payload_at || file.compare(0, schema_at, magic) != 0 ||
          number_at<std::uint64_t>(file, size_at) != file.size() - payload_at ||
          number_at<std::uint32_t>(file, crc_at) != checksum(file))
        return SlotState::damaged;
      if (number_at<std::uint32_t>(file, schema_at) >
          Checkpoint::schema_version)
        return SlotState::newer_schema;

      std::size_t at        = payload_at;
      bool        good      = true;
      const auto  next_size = [&]() -> std::uint64_t {
        good = good && file.size() - at >= sizeof(std::uint64_t);
        if (!good)
          return 0;
        at += sizeof(std::uint64_t);
        return number_at<std::uint64_t>(file, at - sizeof(std::uint64_t));
      };
      const auto next_text = [&]() -> std::string {
        const std::uint64_t size = next_size();
        good                     = good && size <= file.size() - at;
        if (!good)
          return "";
        at += size;
        return file.substr(at - size, size);
      };
      checkpoint.step      = next_size();
      checkpoint.case_hash = next_text();
      checkpoint.program   = next_text();
      checkpoint.blob      = next_text();
      return good ? SlotState::good : SlotState::damaged;
    }
  } // namespace


  CheckpointSlots::CheckpointSlots(const std::string &directory,
                                   const std::string &case_hash,
                                   const std::string &parameters)
    : directory(directory)
    , case_hash(case_hash)
    , parameters(parameters)
  {}


  std::string
  CheckpointSlots::slot_path(const unsigned int slot) const
  {
    return join_path(directory, checkpoint_name(slot));
  }


  void
  CheckpointSlots::write(const std::uint64_t step, const std::string &blob)
  {
    make_folder(std::filesystem::path(slot_path(next_slot)).parent_path());

    const std::string   program   = "waker " WAKER_VERSION " " WAKER_BUILD_TYPE;
    const std::uint64_t n_payload = 4 * sizeof(std::uint64_t) +
                                    case_hash.size() + program.size() +
                                    blob.size();
    std::string file = magic;
    file.reserve(payload_at + n_payload);
    append_number(file, Checkpoint::schema_version);
    append_number(file, std::uint32_t{0});
    append_number(file, n_payload);
    append_number(file, step);
    append_text(file, case_hash);
    append_text(file, program);
    append_text(file, blob);
    std::string crc;
    append_number(crc, checksum(file));
    file.replace(crc_at, crc.size(), crc);

    write_file(slot_path(next_slot), file, /*to_disk =*/true);
    next_slot = (next_slot + 1) % n_slots;
  }


  Checkpoint
  CheckpointSlots::read_latest(std::string &warning)
  {
    const std::string where = "Output/Directory";
    warning.clear();

    Checkpoint  newest;
    bool        found = false;
    std::string damaged;
    for (unsigned int slot = 0; slot < n_slots; ++slot)
      {
        Checkpoint      checkpoint;
        const SlotState state = parse(slot_path(slot), checkpoint);
        if (state == SlotState::newer_schema)
          throw UserError(where,
                          "the checkpoint '" + slot_path(slot) +
                            "' was written by a newer version of Waker",
                          "checkpoints up to schema version " +
                            std::to_string(Checkpoint::schema_version));
        if (state == SlotState::damaged)
          damaged += (damaged.empty() ? "'" : " and '") + slot_path(slot) + "'";
        if (state == SlotState::good &&
            (!found || checkpoint.step > newest.step))
          {
            found     = true;
            newest    = std::move(checkpoint);
            next_slot = (slot + 1) % n_slots;
          }
      }

    if (!found)
      {
        if (damaged.empty())
          throw UserError(where,
                          "there is no checkpoint in '" + directory + "'",
                          "the folder of a run that wrote one; or start anew, "
                          "with --overwrite");
        throw UserError(where,
                        "no checkpoint can be used: " + damaged + " damaged",
                        "a whole checkpoint; or start anew, with --overwrite");
      }
    if (newest.case_hash != case_hash)
      {
        const std::string path = file_path(directory, OutputFile::parameters);
        const std::string differences =
          !parameters.empty() && std::filesystem::exists(path)
            ? parameter_differences(read_file(path),
                                    parameters,
                                    is_free_at_resume)
            : "";
        throw UserError(where,
                        "the checkpoint in '" + directory +
                          "' belongs to another case (its parameters have "
                          "hash " +
                          newest.case_hash + ", yours " + case_hash +
                          "): a parameter or the contents of an input file "
                          "differ" +
                          (differences.empty() ? "" : ": " + differences),
                        "the parameters of that run, see parameters.prm "
                        "there, and the same input files; only what the "
                        "manual lists under \"Resuming\" may differ");
      }
    if (!damaged.empty())
      warning = "checkpoint " + damaged +
                " is damaged; going on from the older one, step " +
                std::to_string(newest.step);
    return newest;
  }
} // namespace Waker
