// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_checkpoint_h
#define waker_output_checkpoint_h

#include <waker/base/own_rows.h>
#include <waker/particles/material_points.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace Waker
{
  class JointFile;

  /// What a slot holds.
  struct Checkpoint
  {
    /// Of the format of the file, not of the blob in it.
    static constexpr std::uint32_t schema_version = 2;

    std::uint64_t step = 0;  // number of steps done
    std::string   case_hash; // Parameters::hash of the run
    std::string   program;   // version and build of the program that wrote it
    std::string   blob;      // the serialised state

    /// The values of points, if they are not in the blob (point_arrays.h).
    std::string_view
    arrays() const
    {
      return std::string_view(file).substr(arrays_at);
    }

    std::string file; // all of it
    std::size_t arrays_at = 0;
  };

  /**
   * Checkpoints on disk, in two slots that are written in turn:
   * "checkpoints/checkpoint-0.bin" and "-1.bin". A slot is written as a
   * temporary file, forced to the disk and renamed, so that at any time, also
   * after SIGKILL or a power cut, at least one slot is whole.
   *
   * Format, little endian: magic "WAKERCP\n", schema version (u32), CRC-32 of
   * all that follows and of the schema version (u32), size of the rest (u64);
   * then step (u64) and case hash, program and blob, each as length (u64) and
   * bytes; then the values of points, if the blob does not have them (from
   * version 2 on). Magic, schema version, CRC and size stay where they are in
   * later versions of the schema.
   */
  class CheckpointSlots
  {
  public:
    static constexpr unsigned int n_slots = 2;

    using BlobOfArrays =
      std::function<std::string(const std::vector<std::uint64_t> &)>;

    /**
     * @param directory the output folder; "checkpoints/" is made in it when
     *        the first checkpoint is written
     * @param case_hash Parameters::hash of this run
     * @param parameters its parameters.prm, to say in what another case differs
     */
    CheckpointSlots(const std::string &directory,
                    const std::string &case_hash,
                    const std::string &parameters = "");

    /// Write the state after `step` steps to the slot that is not the newest.
    /// @throws as throw_cannot_write() if it cannot be written
    void
    write(const std::uint64_t step, const std::string &blob);

    /**
     * With the values of points that ranks share, of which none has those of
     * the others. Collective; step, blob, and what the slots were made with,
     * are the first rank's.
     *
     * @param blob makes it, of array_sizes() of the points; the first rank asks
     * @throws as above, on all ranks alike
     */
    template <int dim>
    void
    write(const std::uint64_t        step,
          const BlobOfArrays        &blob,
          const MaterialPoints<dim> &own,
          const OwnRows             &rows);

    /**
     * The newest whole checkpoint.
     *
     * @param warning set to a line for the user if a slot is damaged and the
     *        other one is used; otherwise left empty
     * @throws UserError "Output/Directory" if there is none, if all are
     *         damaged, or if the newest belongs to another case or has a newer
     *         schema version
     */
    Checkpoint
    read_latest(std::string &warning);

    /// Path of a slot.
    std::string
    slot_path(const unsigned int slot) const;

  private:
    /// The file up to the values of points.
    /// @param n_more bytes of these
    void
    add_beginning(const std::uint64_t step,
                  const std::string  &blob,
                  const std::uint64_t n_more,
                  JointFile          &file) const;

    std::string  directory;
    std::string  case_hash;
    std::string  parameters;
    unsigned int next_slot = 0;
  };
} // namespace Waker

#endif
