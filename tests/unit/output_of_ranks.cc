// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/file_error.h>
#include <waker/base/hash.h>
#include <waker/base/ranks.h>
#include <waker/output/checkpoint.h>
#include <waker/output/particle_writer.h>
#include <waker/output/point_arrays.h>
#include <waker/output/top_view_writer.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <numeric>
#include <optional>
#include <set>
#include <sys/resource.h>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace Waker::output_of_ranks
{
  namespace
  {
    constexpr std::size_t block =
      4096; // points that are compressed together (points_per_block)


    /// Made, and removed, by the first rank.
    class SharedFolder
    {
    public:
      SharedFolder()
      {
        if (is_first_rank(MPI_COMM_WORLD))
          folder.emplace();
        path = shared(folder ? folder->path : "", MPI_COMM_WORLD);
      }

      ~SharedFolder()
      {
        MPI_Barrier(MPI_COMM_WORLD); // all have looked at what is in it
      }

      std::string
      file(const std::string &name) const
      {
        return path + "/" + name;
      }

      std::string path;

    private:
      std::optional<TemporaryFolder> folder;
    };


    /// A point whose numbers nobody guesses.
    template <int dim>
    void
    add_point(const std::uint32_t number, MaterialPoints<dim> &points)
    {
      const auto value = [=](const unsigned int k) {
        return std::sin(1. + 0.7 * number + 3. * k);
      };
      const std::size_t p = points.n_points();
      points.resize(p + 1);
      points.id[p]       = 7 + 3 * static_cast<std::uint64_t>(number);
      points.material[p] = number % 5;
      points.mass[p]     = value(0);
      points.volume[p]   = value(1);
      for (unsigned int d = 0; d < dim; ++d)
        {
          points.position[p][d] = 155000. + value(2 + d);
          points.velocity[p][d] = value(5 + d);
        }
      for (unsigned int c = 0; c < 6; ++c)
        points.stress[p].access_raw_entry(c) = value(8 + c);
      points.scalars[0].values[p] = value(14);
    }


    template <int dim>
    MaterialPoints<dim>
    make_points(const std::vector<std::uint32_t> &numbers)
    {
      MaterialPoints<dim> points;
      points.scalars.push_back({"plastic strain", {}});
      for (const std::uint32_t number : numbers)
        add_point(number, points);
      return points;
    }


    template <int dim>
    std::vector<Tensor<1, dim>>
    make_loads(const std::vector<std::uint32_t> &numbers)
    {
      std::vector<Tensor<1, dim>> loads(numbers.size());
      for (std::size_t p = 0; p < numbers.size(); ++p)
        loads[p][dim - 1] = std::cos(0.3 * numbers[p]);
      return loads;
    }


    /// Who has which?
    enum class Deal
    {
      mixed,    // in no order
      in_order, // a part each
      one       // the last rank has all, the others none
    };


    std::vector<std::uint32_t>
    own_numbers(const std::uint32_t n_all, const Deal deal)
    {
      const unsigned int n  = n_ranks(MPI_COMM_WORLD);
      const unsigned int me = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      std::vector<std::uint32_t> own;
      for (std::uint32_t k = n_all; k > 0; --k)
        {
          const std::uint32_t p = k - 1;
          const unsigned int  rank =
            deal == Deal::mixed ? (p ^ (p >> 3)) % n
             : deal == Deal::in_order
               ? static_cast<unsigned int>(std::uint64_t(p) * n / n_all)
               : n - 1;
          if (rank == me)
            own.push_back(p);
        }
      return own;
    }


    /// Written together: the text, and its checksum.
    template <int dim>
    std::string
    written(const SharedFolder               &folder,
            const std::size_t                 n_all,
            const std::vector<std::uint32_t> &own,
            std::string                      &checksum)
    {
      const auto loads       = make_loads<dim>(own);
      checksum               = write_particles(make_points<dim>(own),
                                 {MPI_COMM_WORLD, n_all, own},
                                 2.5,
                                 folder.file("together.vtu"),
                                 {{"load_a", "kN", &loads}});
      const std::string text = get(folder.file("together.vtu"));
      MPI_Barrier(MPI_COMM_WORLD); // before it is written again
      return text;
    }


    /// What a rank writes that is alone.
    template <int dim>
    std::string
    alone(const std::uint32_t n_all)
    {
      std::vector<std::uint32_t> all(n_all);
      std::iota(all.begin(), all.end(), 0);
      const TemporaryFolder folder;
      const auto            loads = make_loads<dim>(all);
      write_particles<dim>(make_points<dim>(all),
                           2.5,
                           folder.file("alone.vtu"),
                           {{"load_a", "kN", &loads}});
      return get(folder.file("alone.vtu"));
    }


    template <int dim>
    void
    file_does_not_depend_on_ranks(const std::vector<Deal> &deals)
    {
      const SharedFolder    folder;
      std::set<std::string> texts;
      // None, fewer than ranks, whole blocks, and others.
      const std::vector<std::size_t> counts = {
        0, 1, 2 * block, 2 * block + 1, 4 * block + 1234};
      for (const std::size_t n_all : counts)
        {
          const std::string expected = alone<dim>(n_all);
          texts.insert(expected);
          for (const Deal deal : deals)
            {
              std::string       checksum;
              const std::string text =
                written<dim>(folder, n_all, own_numbers(n_all, deal), checksum);
              EXPECT_TRUE(text == expected) << n_all << " points";
              EXPECT_EQ(checksum, checksum_of_text(expected));
            }
        }
      EXPECT_EQ(texts.size(), counts.size());
    }


    std::size_t
    n_files(const SharedFolder &folder)
    {
      MPI_Barrier(MPI_COMM_WORLD);
      using Iterator = std::filesystem::directory_iterator;
      return std::distance(Iterator(folder.path), Iterator());
    }


    void
    write_somewhere(const std::string &path)
    {
      const std::size_t                n_all = 2 * block;
      const std::vector<std::uint32_t> own   = own_numbers(n_all, Deal::mixed);
      write_particles(make_points<2>(own),
                      {MPI_COMM_WORLD, n_all, own},
                      0.,
                      path);
    }
  } // namespace


  TEST(Ranks, FileOfPointsDoesNotDependOnThem)
  {
    file_does_not_depend_on_ranks<2>({Deal::mixed});
    file_does_not_depend_on_ranks<3>({Deal::mixed, Deal::in_order, Deal::one});
  }


  namespace
  {
    template <int dim>
    void
    checkpoint_does_not_depend_on_ranks()
    {
      const std::uint32_t        n_all = 1234;
      std::vector<std::uint32_t> all(n_all);
      std::iota(all.begin(), all.end(), 0);
      const auto blob = [](const std::vector<std::uint64_t> &sizes) {
        return "the rest, of " + std::to_string(sizes.at(0)) + " points";
      };
      const TemporaryFolder mine;
      CheckpointSlots       my_slots(mine.path, "hash");
      const auto            whole = make_points<dim>(all);
      my_slots.write(7, blob, whole, OwnRows(n_all));
      const std::string expected = get(my_slots.slot_path(0));

      std::string      warning;
      const Checkpoint read = my_slots.read_latest(warning);
      EXPECT_EQ(read.step, 7u);
      EXPECT_EQ(read.blob, "the rest, of 1234 points");
      MaterialPoints<dim> again = make_points<dim>({});
      again.resize(n_all);
      EXPECT_THROW(read_arrays(read.arrays().substr(1), again),
                   std::runtime_error);
      read_arrays(read.arrays(), again);
      EXPECT_EQ(again.id, whole.id);
      EXPECT_EQ(again.stress, whole.stress);
      EXPECT_EQ(again.scalars[0].values, whole.scalars[0].values);

      const SharedFolder folder;
      for (const Deal deal : {Deal::mixed, Deal::in_order, Deal::one})
        {
          const std::vector<std::uint32_t> own = own_numbers(n_all, deal);
          // Folder, step and blob are those of the first rank.
          const bool      is_first = is_first_rank(MPI_COMM_WORLD);
          CheckpointSlots slots(is_first ? folder.path : "",
                                is_first ? "hash" : "");
          slots.write(is_first ? 7 : 0,
                      is_first ? blob : CheckpointSlots::BlobOfArrays(),
                      make_points<dim>(own),
                      OwnRows(MPI_COMM_WORLD, n_all, own));
          EXPECT_TRUE(get(folder.file("checkpoints/checkpoint-0.bin")) ==
                      expected);
          MPI_Barrier(MPI_COMM_WORLD); // before it is written again
        }
    }
  } // namespace


  TEST(Ranks, CheckpointDoesNotDependOnThem)
  {
    checkpoint_does_not_depend_on_ranks<2>();
    checkpoint_does_not_depend_on_ranks<3>();
  }


  TEST(Ranks, TopViewDoesNotDependOnThem)
  {
    const BackgroundGrid<3> grid(Point<3>(),
                                 Point<3>(60., 4., 60.),
                                 1.,
                                 MPI_COMM_SELF);
    // In columns of three, of which the uppermost ones are seen.
    const auto place = [](MaterialPoints<3> &points) {
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const unsigned int number = (points.id[p] - 7) / 3;
          const unsigned int column = number / 3;
          points.position[p]        = Point<3>(0.25 + 0.5 * (column % 100),
                                        0.5 + number % 3,
                                        0.25 + 0.5 * (column / 100));
          for (unsigned int d = 0; d < 3; ++d)
            points.half_size[p][d] = 0.25;
        }
    };
    const std::uint32_t        n_all = 3 * 3000; // 12,000 corners are seen
    std::vector<std::uint32_t> all(n_all);
    std::iota(all.begin(), all.end(), 0);
    MaterialPoints<3> whole = make_points<3>(all);
    place(whole);
    const TopView<3>      view(grid, whole);
    const TemporaryFolder mine;
    write_top_view(view, whole, OwnRows(n_all), 2., mine.file("a.vtu"));
    const std::string expected = get(mine.file("a.vtu"));
    EXPECT_NE(expected.find("NumberOfPoints=\"12000\""), std::string::npos);
    const SharedFolder folder;
    for (const Deal deal : {Deal::mixed, Deal::in_order, Deal::one})
      {
        const std::vector<std::uint32_t> numbers = own_numbers(n_all, deal);
        MaterialPoints<3>                own     = make_points<3>(numbers);
        place(own);
        write_top_view(view,
                       own,
                       {MPI_COMM_WORLD, n_all, numbers},
                       2.,
                       folder.file("a.vtu"));
        EXPECT_TRUE(get(folder.file("a.vtu")) == expected);
        MPI_Barrier(MPI_COMM_WORLD);
      }
  }


  TEST(Ranks, AllHearThatAFileCannotBeWritten)
  {
    const SharedFolder folder;
    EXPECT_USER_ERROR(write_somewhere(folder.file("missing/a.vtu")),
                      "Output/Directory",
                      "missing/a.vtu.tmp': No such file or directory");
    write_somewhere(folder.file("a.vtu"));
    const std::string before = get(folder.file("a.vtu"));
    EXPECT_GT(before.size(), 10000u);
    EXPECT_EQ(n_files(folder), 1u);

    // As a full disk.
    rlimit limit;
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit less = {10000, limit.rlim_max};
    const auto   old  = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &less), 0);
    try
      {
        write_somewhere(folder.file("a.vtu"));
        ADD_FAILURE() << "it has been written";
      }
    catch (const FileError &error)
      {
        EXPECT_EQ(error.path, folder.file("a.vtu"));
        EXPECT_EQ(error.problem, "cannot be written: File too large");
      }
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, old);
    EXPECT_EQ(n_files(folder), 1u); // also not a part of one
    EXPECT_TRUE(get(folder.file("a.vtu")) == before);
  }


  TEST(Ranks, RowsDoNotGetLost)
  {
    const std::size_t          n_all = 5 * n_ranks(MPI_COMM_WORLD);
    std::vector<std::uint32_t> own;
    EXPECT_THROW(RowsInOrder({MPI_COMM_WORLD, n_all, own}, 2),
                 std::logic_error);
    own = own_numbers(n_all, Deal::mixed);
    const RowsInOrder rows({MPI_COMM_WORLD, n_all, own}, 2);
    EXPECT_EQ(rows.begin % 2, 0u);
    EXPECT_EQ(Utilities::MPI::sum(rows.end - rows.begin, MPI_COMM_WORLD),
              n_all);
    std::vector<char> values, buffer;
    for (const std::uint32_t number : own)
      values.push_back(static_cast<char>(number));
    const std::vector<char> &mine = rows.values(values, 1, buffer);
    ASSERT_EQ(mine.size(), rows.end - rows.begin);
    for (std::size_t k = 0; k < mine.size(); ++k)
      EXPECT_EQ(mine[k], static_cast<char>(rows.begin + k));
  }
} // namespace Waker::output_of_ranks
