// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/field_place.h>
#include <waker/campaign/input.h>
#include <waker/campaign/realisation_runner.h>
#include <waker/case/cross_section.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "user_errors.h"
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <utility>
#include <vector>

namespace campaign_cross_section
{
  // The section of a case in space as a case in plane strain.

  using namespace Waker;

  namespace
  {
    const char *const analysis =
      WAKER_SOURCE_DIRECTORY "/parameters/chapter6/analysis1.prm";


    std::vector<std::unique_ptr<Input>>
    read(std::vector<std::string> overrides)
    {
      overrides.push_back("Grid/Cell size=0.5");
      return read_scenarios(analysis, overrides);
    }
  } // namespace


  TEST(CrossSection, has_the_random_fields_of_the_case_in_space)
  {
    const auto           space = read({});
    RealisationRunner<3> in_space(space[0]->simulation,
                                  space[0]->reliability.fields,
                                  1,
                                  MPI_COMM_SELF);
    // In the middle of a layer of points (cells of 0.25 m), and between two of
    // them: then it is the one above.
    for (const char *const z : {"3.8", "4"})
      {
        const auto plane = read({std::string("Cross-section=") + z});
        ASSERT_EQ(plane[0]->simulation.dimension, 2u);
        RealisationRunner<2> in_plane(plane[0]->simulation,
                                      plane[0]->reliability.fields,
                                      1,
                                      MPI_COMM_SELF);
        ASSERT_EQ(in_plane.n_noise(), in_space.n_noise());
        const double layer = z[0] == '4' ? 4.125 : 3.875; // z of its points

        const auto noise = realisation_noise(1, 5, in_space.n_noise());
        const auto body  = in_space.initial(noise.data()).points;
        const auto twin  = in_plane.initial(noise.data()).points;
        std::map<std::pair<long, long>, std::pair<double, double>> there;
        const auto key = [](const double x, const double y) {
          return std::make_pair(std::lround(1000. * x), std::lround(1000. * y));
        };
        const auto &c_i = body.scalar("undrained shear strength");
        const auto &c_r = body.scalar("residual strength");
        for (std::size_t p = 0; p < body.n_points(); ++p)
          if (std::abs(body.position[p][2] - layer) < 1e-9)
            there[key(body.position[p][0], body.position[p][1])] = {c_i[p],
                                                                    c_r[p]};
        ASSERT_EQ(there.size(), twin.n_points());
        double least = 100., largest = 0.;
        for (std::size_t p = 0; p < twin.n_points(); ++p)
          {
            const auto found =
              there.find(key(twin.position[p][0], twin.position[p][1]));
            ASSERT_NE(found, there.end());
            const double c = twin.scalar("undrained shear strength")[p];
            EXPECT_EQ(c, found->second.first);
            EXPECT_EQ(twin.scalar("residual strength")[p],
                      found->second.second);
            least   = std::min(least, c);
            largest = std::max(largest, c);
          }
        EXPECT_GT(largest - least, 0.5); // they vary
      }
  }


  TEST(CrossSection, leaves_away_what_lies_along_z)
  {
    const auto        scenarios = read({"Cross-section=4"});
    const Parameters &p         = scenarios[0]->simulation;
    EXPECT_EQ(p.grid.upper_corner, (std::vector<double>{6., 1.5}));
    std::vector<std::string> conditions;
    for (const FixityParameters &condition : p.fixities)
      conditions.push_back(condition.name);
    EXPECT_EQ(conditions,
              (std::vector<std::string>{"base", "rear", "behind the rear"}));
    EXPECT_EQ(p.outflow.faces, "right");
    EXPECT_TRUE(p.outlets.empty());
    ASSERT_EQ(p.load_programmes.size(), 1u);
    EXPECT_EQ(p.load_programmes[0].weight.from, std::vector<double>{1.5});
    ASSERT_TRUE(p.in_space);
    EXPECT_EQ(p.in_space->dimension, 3u);
    EXPECT_EQ(p.section_z, 4.);

    // The hash is another one.
    const auto other = read({"Cross-section=3.75"});
    EXPECT_NE(other[0]->campaign_hash, scenarios[0]->campaign_hash);
  }


  TEST(CrossSection, meets_what_begins_at_it_and_not_what_ends_there)
  {
    // The load reaches from 3.5 to 4.5 m.
    for (const char *const z : {"3.5", "4.499"})
      EXPECT_EQ(read({std::string("Cross-section=") + z})[0]
                  ->simulation.load_programmes.size(),
                1u);
    for (const char *const z : {"3.499", "4.5", "1"})
      {
        EXPECT_USER_ERROR(
          read({std::string("Cross-section=") + z}),
          "--set Cross-section",
          std::string("is ") + z +
            " m, beside the load of Load programmes/foundation, "
            "which reaches from 3.5 m to less than 4.5 m");
        EXPECT_NO_THROW(
          read({std::string("Cross-section=") + z, "Load programmes/Names="}));
      }

    // Conditions and outlets likewise; a plane has no end.
    const auto n_met =
      [](const std::string &from, const std::string &to, const std::string &z) {
        std::vector<std::string> settings = {
          "Cross-section=" + z,
          "Load programmes/Names=",
          "Boundary conditions/Names=base, block",
          "Boundary conditions/block/Region=box",
          "Boundary conditions/block/From=0, 0, " + from,
          "Boundary conditions/block/To=1, 1, " + to,
          "Outflow/Faces="};
        const bool has_outlet = from != to;
        if (has_outlet)
          settings.insert(settings.end(),
                          {"Outflow/Names=gap",
                           "Outflow/gap/Face=right",
                           "Outflow/gap/From=0, 0, " + from,
                           "Outflow/gap/To=10, 1, " + to});
        else
          settings.push_back("Outflow/Names=");
        const auto        scenarios = read(settings);
        const Parameters &p         = scenarios[0]->simulation;
        // What is left away is told.
        unsigned int n = 0;
        for (const std::string &warning : strange_parameters(p))
          n += warning.find("Cross-section is " + z + " m, beside") == 0;
        const std::size_t n_met = p.fixities.size() - 1;
        EXPECT_EQ(n, (has_outlet ? 2u : 1u) * (1u - n_met));
        EXPECT_EQ(p.outlets.size(), has_outlet ? n_met : 0u);
        return n_met;
      };
    EXPECT_EQ(n_met("2", "3", "2"), 1u);
    EXPECT_EQ(n_met("2", "3", "2.999"), 1u);
    EXPECT_EQ(n_met("2", "3", "3"), 0u);
    EXPECT_EQ(n_met("2", "3", "1.999"), 0u);
    EXPECT_EQ(n_met("2", "2", "2"), 1u);
    EXPECT_EQ(n_met("2", "2", "2.001"), 0u);
  }


  TEST(CrossSection, on_a_line_is_in_the_layer_above_whatever_the_round_off)
  {
    unsigned int n = 0;
    // Edges of cells (m), and numbers of layers of sub-cells.
    for (const auto &[h, n_layers] :
         {std::make_pair(0.1, 24u), std::make_pair(0.3, 12u)})
      for (unsigned int i = 0; i < n_layers; ++i)
        {
          char z[20]; // as it would be typed
          std::snprintf(z, sizeof(z), "%.2f", i * h / 2.);
          std::string box = std::to_string(6. * h);
          const auto  scenarios =
            read_scenarios(analysis,
                           {"Grid/Cell size=" + std::to_string(h),
                            "Grid/Upper corner=" + box + ", " + box + ", " +
                              std::to_string(0.5 * h * n_layers),
                            "Soil profile/slope/Polygon=0, 0; 0.6, 0; 0.6, "
                            "0.6; 0, 0.6",
                            "Boundary conditions/Names=base",
                            "Outflow/Names=",
                            "Load programmes/Names=",
                            std::string("Cross-section=") + z});
          const Case<2>       plane(scenarios[0]->simulation, MPI_COMM_SELF);
          const FieldPlace<2> place(plane);
          const FieldLattice  lattice = place.lattice({}, "");
          ASSERT_EQ(lattice.n_cells[2], n_layers);
          const std::size_t cell =
            lattice.cell_of(place.of(plane.initial_points.position[0]));
          EXPECT_EQ(lattice.index(cell)[2], i) << z;
          ++n;
        }
    EXPECT_EQ(n, 36u);
  }


  TEST(CrossSection, has_a_folder_of_its_own)
  {
    const auto folder = [](std::vector<std::string> overrides) {
      return read(std::move(overrides))[0]->simulation.output.directory;
    };
    const std::string in_space = "output-chapter6-analysis1";
    EXPECT_EQ(folder({}), in_space);
    EXPECT_EQ(folder({"Cross-section=none"}), in_space);
    EXPECT_EQ(folder({"Cross-section=4"}), in_space + "-section-4");
    EXPECT_EQ(folder({"Cross-section=4.00"}), in_space + "-section-4");
    EXPECT_EQ(folder({"Cross-section=4", "Output/Directory=twin"}), "twin");
    EXPECT_EQ(folder({"Sweep/Parameter=Cross-section", "Sweep/Values=3.5; 4"}),
              in_space + "-sections");
    // Also in the parameters that the folder gets.
    EXPECT_NE(read({"Cross-section=4"})[0]->simulation.text.find(in_space +
                                                                 "-section-4"),
              std::string::npos);
  }


  TEST(CrossSection, is_refused_where_there_is_none)
  {
    EXPECT_NO_THROW(read({"Cross-section=0", "Load programmes/Names="}));
    EXPECT_USER_ERROR(read({"Cross-section=8"}),
                      "--set Cross-section",
                      "is 8 m");
    EXPECT_USER_ERROR(read({"Cross-section=-0.1"}),
                      "--set Cross-section",
                      "-0.1");
    EXPECT_USER_ERROR(read(
                        {"Cross-section=4", "Soil profile/slope/Extent=0, 2"}),
                      "--set Cross-section",
                      "where no layer is");
    // The last plane of a layer is no part of it.
    EXPECT_USER_ERROR(read(
                        {"Cross-section=4", "Soil profile/slope/Extent=0, 4"}),
                      "--set Cross-section",
                      "where no layer is");
    EXPECT_NO_THROW(
      read({"Cross-section=4", "Soil profile/slope/Extent=4, 8"}));
    // Several sections are one campaign, but not one beside its case.
    EXPECT_EQ(
      read({"Sweep/Parameter=Cross-section", "Sweep/Values=3.5; 4"}).size(),
      2u);
    EXPECT_USER_ERROR(read({"Sweep/Parameter=Cross-section",
                            "Sweep/Values=none; 4"}),
                      "--set Sweep/Parameter",
                      "makes some scenarios plane");
    EXPECT_USER_ERROR(read_scenarios(WAKER_SOURCE_DIRECTORY
                                     "/parameters/chapter5/dyke.prm",
                                     {"Cross-section=4"}),
                      "--set Cross-section",
                      "Dimension is 2");
    EXPECT_USER_ERROR(
      read_scenarios(WAKER_SOURCE_DIRECTORY "/parameters/chapter6/dyke_3d.prm",
                     {"Cross-section=4",
                      "Soil profile/dyke/Top=" WAKER_SOURCE_DIRECTORY
                      "/parameters/chapter6/dyke_3d.csv"}),
      "--set Cross-section",
      "height map");
  }
} // namespace campaign_cross_section
