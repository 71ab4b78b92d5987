// SPDX-License-Identifier: LGPL-2.1-or-later
#include "data_array.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <waker/base/ranks.h>

#include <algorithm>
#include <cstring>
#include <zlib.h>

namespace Waker
{
  namespace
  {
    using Bytes = std::vector<unsigned char>;

    /// Blocks of one rank, one after the other.
    struct Blocks
    {
      Bytes                      bytes;
      std::vector<std::uint32_t> sizes;
    };


    Blocks
    compress(const std::vector<char> &values, const std::size_t block)
    {
      Blocks blocks;
      for (std::size_t begin = 0; begin < values.size(); begin += block)
        {
          const std::size_t n     = std::min(block, values.size() - begin);
          const std::size_t start = blocks.bytes.size();
          uLongf            size  = compressBound(n);
          blocks.bytes.resize(start + size);
          const int status =
            compress2(&blocks.bytes[start],
                      &size,
                      reinterpret_cast<const Bytef *>(&values[begin]),
                      n,
                      Z_BEST_SPEED);
          AssertThrow(status == Z_OK, ExcMessage("zlib cannot compress"));
          blocks.bytes.resize(start + size);
          blocks.sizes.push_back(size);
        }
      return blocks;
    }


    /// What a rank tells the others of its blocks: their sizes, after its first
    /// two bytes.
    std::vector<std::uint32_t>
    told_of(const Blocks &blocks)
    {
      std::vector<std::uint32_t> told(2, 0);
      for (std::size_t k = 0; k < std::min<std::size_t>(2, blocks.bytes.size());
           ++k)
        told[k] = blocks.bytes[k];
      told.insert(told.end(), blocks.sizes.begin(), blocks.sizes.end());
      return told;
    }


    std::size_t
    n_bytes_of(const std::vector<std::uint32_t> &told)
    {
      std::size_t sum = 0;
      for (std::size_t k = 2; k < told.size(); ++k)
        sum += told[k];
      return sum;
    }


    /**
     * Three bytes make four characters, and may lie on several ranks: each
     * encodes those that begin on it.
     */
    std::string
    encoded(Bytes                                          bytes,
            const unsigned int                             me,
            const std::vector<std::vector<std::uint32_t>> &told)
    {
      std::size_t before = 0;
      for (unsigned int rank = 0; rank < me; ++rank)
        before += n_bytes_of(told[rank]);
      const std::size_t end = before + bytes.size();
      // The first ones may be the last of a group that begins on another rank.
      const std::size_t n_theirs =
        std::min<std::size_t>((3 - before % 3) % 3, bytes.size());
      if (n_theirs == bytes.size())
        return "";
      std::size_t n_wanted = (3 - end % 3) % 3;
      for (unsigned int rank = me + 1; rank < told.size(); ++rank)
        for (std::size_t k = 0;
             k < std::min<std::size_t>(2, n_bytes_of(told[rank])) &&
             n_wanted > 0;
             ++k, --n_wanted)
          bytes.push_back(static_cast<unsigned char>(told[rank][k]));
      bytes.erase(bytes.begin(),
                  bytes.begin() + static_cast<std::ptrdiff_t>(n_theirs));
      return Utilities::encode_base64(bytes);
    }

    /// The part of the text that this rank's values make; the first rank's
    /// begins with the header.
    std::string
    compressed(const MPI_Comm           communicator,
               const std::vector<char> &values,
               const DataRows          &rows)
    {
      const std::size_t n_bytes = rows.n_all * rows.size;
      const std::size_t block   = rows.per_block * rows.size;
      Blocks            blocks  = compress(values, block);
      const bool        alone   = n_ranks(communicator) == 1;
      const auto        told =
        alone ? std::vector<std::vector<std::uint32_t>>{told_of(blocks)}
                     : Utilities::MPI::all_gather(communicator, told_of(blocks));
      const unsigned int me =
        alone ? 0 : Utilities::MPI::this_mpi_process(communicator);
      const std::string text = encoded(std::move(blocks.bytes), me, told);
      if (me > 0)
        return text;

      const std::size_t          n_blocks = (n_bytes + block - 1) / block;
      std::vector<std::uint32_t> header   = {
          static_cast<std::uint32_t>(n_blocks),
          static_cast<std::uint32_t>(std::min(block, n_bytes)),
          static_cast<std::uint32_t>(n_bytes - (n_blocks - 1) * block)};
      for (const std::vector<std::uint32_t> &of_rank : told)
        header.insert(header.end(), of_rank.begin() + 2, of_rank.end());
      AssertDimension(header.size(), 3 + n_blocks);
      Bytes bytes(header.size() * sizeof(header[0]));
      std::memcpy(bytes.data(), header.data(), bytes.size());
      return Utilities::encode_base64(bytes) + text;
    }
  } // namespace


  void
  add_data_array(const std::string       &attributes,
                 const std::vector<char> &values,
                 const DataRows          &rows,
                 JointFile               &file)
  {
    file.add_text("<DataArray " + attributes + " format=\"" +
                  (rows.n_all == 0 ? "ascii" : "binary") + "\">\n");
    if (rows.n_all > 0)
      file.add_part(compressed(file.communicator, values, rows));
    file.add_text("\n</DataArray>\n");
  }
} // namespace Waker
