// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/hash.h>
#include <waker/base/ranks.h>
#include <waker/base/version.h>
#include <waker/output/checkpoint.h>
#include <waker/output/files.h>
#include <waker/output/free_at_resume.h>
#include <waker/output/output_files.h>
#include <waker/output/parameter_differences.h>
#include <waker/output/point_arrays.h>

#include "joint_file.h"
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
    checksum(const std::string_view schema, const CheckedPiece &rest)
    {
      return joined({check_piece(schema), rest}).crc;
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
      checkpoint.file         = read_file(path);
      const std::string &file = checkpoint.file;
      if (file.size() < payload_at || file.compare(0, schema_at, magic) != 0 ||
          number_at<std::uint64_t>(file, size_at) != file.size() - payload_at ||
          number_at<std::uint32_t>(file, crc_at) !=
            checksum(std::string_view(file).substr(schema_at,
                                                   crc_at - schema_at),
                     check_piece(std::string_view(file).substr(size_at))))
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
      checkpoint.arrays_at = at;
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


  namespace
  {
    constexpr bool to_disk = true, makes_folder = true;

    /// Its checksum is known at the end.
    void
    seal(JointFile &file)
    {
      std::string schema, crc;
      append_number(schema, Checkpoint::schema_version);
      append_number(crc, checksum(schema, file.checked_from(size_at)));
      file.replace(crc_at, crc);
    }
  } // namespace


  void
  CheckpointSlots::add_beginning(const std::uint64_t step,
                                 const std::string  &blob,
                                 const std::uint64_t n_more,
                                 JointFile          &file) const
  {
    std::string text = magic;
    append_number(text, Checkpoint::schema_version);
    append_number(text, std::uint32_t{0});
    file.add_text(text);
    file.add_part(""); // what the checksum is not of ends here

    const std::string program = "waker " WAKER_VERSION " " WAKER_BUILD_TYPE;
    text.clear();
    append_number(text,
                  4 * sizeof(std::uint64_t) + case_hash.size() +
                    program.size() + blob.size() + n_more);
    append_number(text, step);
    append_text(text, case_hash);
    append_text(text, program);
    append_number(text, static_cast<std::uint64_t>(blob.size()));
    file.add_text(text);
    file.add_text(blob);
  }


  void
  CheckpointSlots::write(const std::uint64_t step, const std::string &blob)
  {
    JointFile file(MPI_COMM_SELF, slot_path(next_slot), to_disk, makes_folder);
    add_beginning(step, blob, 0, file);
    seal(file);
    file.write();
    next_slot = (next_slot + 1) % n_slots;
  }


  template <int dim>
  void
  CheckpointSlots::write(const std::uint64_t        step,
                         const BlobOfArrays        &blob,
                         const MaterialPoints<dim> &own,
                         const OwnRows             &rows)
  {
    const std::vector<std::uint64_t> sizes = array_sizes(own, rows);
    JointFile                        file(rows.communicator,
                   slot_path(next_slot),
                   to_disk,
                   makes_folder);
    add_beginning(step,
                  is_first_rank(rows.communicator) ? blob(sizes) : "",
                  n_bytes_of_arrays(own, sizes),
                  file);
    add_arrays(own, rows, sizes, file);
    seal(file);
    file.write();
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


  template void
  CheckpointSlots::write(const std::uint64_t,
                         const BlobOfArrays &,
                         const MaterialPoints<2> &,
                         const OwnRows &);
  template void
  CheckpointSlots::write(const std::uint64_t,
                         const BlobOfArrays &,
                         const MaterialPoints<3> &,
                         const OwnRows &);
} // namespace Waker
