// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/program/parameter_reader.h>
#include <waker/simulation/realisation.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace simulation_three_dimensions
{
  // Whole cases in 3D against beam theory and against plane strain.

  using namespace Waker;

  namespace
  {
    std::unique_ptr<Parameters>
    read(const std::string &file, const std::vector<std::string> &settings)
    {
      return read_parameters(WAKER_SOURCE_DIRECTORY "/parameters/" + file,
                             settings);
    }


    template <int dim>
    void
    run(const Case<dim> &the_case, State<dim> &state)
    {
      Realisation<dim> realisation(the_case, state);
      while (realisation.look() == StopReason::none)
        realisation.advance();
      EXPECT_GT(state.step, 0u);
      EXPECT_EQ(state.unconverged_steps, 0u);
    }


    constexpr double length = 2., width = 0.5, depth = 0.5; // m
    constexpr double stiffness = 1e6, gamma = 1.;           // kPa, kN/m^3


    /// How far the end of a bar sags that is held at x = 0, under its weight
    /// (m).
    double
    sag(const std::string &h)
    {
      const auto    p = read("chapter6/slope.prm",
                          {"Grid/Cell size=" + h,
                              "Grid/Lower corner=0, -0.5, 0",
                              "Grid/Upper corner=2.5, 1, 0.5",
                              "Soil profile/slope/Polygon=0,0; 2,0; 2,0.5; 0,0.5",
                              "Materials/clay/Model=linear elastic",
                              "Materials/clay/Young's modulus=1e6",
                              "Materials/clay/Poisson's ratio=0",
                              "Materials/clay/Unit weight=1",
                              "Boundary conditions/Names=rear",
                              "Boundary conditions/rear/Type=fixed",
                              "Outflow/Faces=",
                              "Outflow/Names=",
                              "Gravity/Initial stress=false",
                              "Gravity/Initial share=1",
                              "Time stepping/Scheme=quasi-static",
                              "Time stepping/Time step=1",
                              "Time stepping/End time=1",
                              "Newton/Tolerance=1e-6",
                              "Newton/Linear tolerance=1e-8",
                              "Newton/Maximum linear iterations=5000",
                              "Stop rules/At rest=false"});
      const Case<3> the_case(*p, MPI_COMM_SELF);
      State<3>      state = initial_state(the_case);
      run(the_case, state);
      // Of the points nearest to the end, at all heights, on to the end.
      double far = 0.;
      for (const Point<3> &x : state.points.initial_position)
        far = std::max(far, x[0]);
      double       sum = 0., slope = 0.;
      unsigned int n    = 0;
      const double size = far < length ? 2. * (length - far) : 0.;
      for (std::size_t q = 0; q < state.points.n_points(); ++q)
        {
          const double x0 = state.points.initial_position[q][0];
          const double u  = x0 < far - 1.5 * size
                              ? 0.
                              : state.points.initial_position[q][1] -
                                 state.points.position[q][1];
          if (x0 > far - 0.5 * size)
            {
              sum += u;
              slope += u;
              ++n;
            }
          else if (x0 > far - 1.5 * size)
            slope -= u;
        }
      EXPECT_GT(n, 0u);
      return (sum + 0.5 * slope) / n;
    }
  } // namespace


  /**
   * Timoshenko's beam: q L^4 / (8 E I) + q L^2 / (2 k G A), k = 5/6. With n
   * cells over the depth and Poisson's ratio 0, a cell bends about its own
   * centre with a stiffness of 1 / n^2 of the whole. GIMP's gradients are means
   * over half a cell and have 3/4 of it; a shear that is not there adds 3/8;
   * B-bar takes the volumetric third of the 3/4 away. Together the bar is
   * softer by 1 / (8 n^2). Twice that is allowed; it is of second order.
   */
  TEST(SimulationThreeDimensions, ABarBendsLikeABeam)
  {
    const double area    = width * depth,
                 inertia = width * std::pow(depth, 3) / 12.;
    const double q       = gamma * area;
    const double bending = q * std::pow(length, 4) / (8. * stiffness * inertia);
    const double shear =
      q * length * length / (2. * 5. / 6. * stiffness / 2. * area);
    std::vector<double> error;
    for (const auto &[h, n] :
         {std::make_pair("0.125", 4), std::make_pair("0.0625", 8)})
      {
        error.push_back(sag(h) / (bending + shear) - 1.);
        EXPECT_LT(std::abs(error.back()), 0.25 / (n * n)) << h;
      }
    EXPECT_GT(error[0], 3. * error[1]); // 5.4 today
    EXPECT_GT(error[1], 0.);
  }


  /**
   * The slope of 45 degrees that yields, with B-bar, in plane strain and as a
   * slice of one cell between rollers. Both do the same sums but for their
   * order, and for the third direction's zeros; what is left is Newton's
   * tolerance.
   */
  TEST(SimulationThreeDimensions, ASliceWithBBarIsPlaneStrain)
  {
    std::vector<std::string> settings = {"Grid/Cell size=0.25",
                                         "Materials/clay/Initial strength=2.4",
                                         "Materials/clay/Residual strength=0.6",
                                         "Materials/clay/Softening modulus=-2",
                                         "Gravity/Initial share=0.99",
                                         "Gravity/Tolerance=1e-12",
                                         "Time stepping/Time step=0.01",
                                         "Time stepping/End time=0.5",
                                         "Time stepping/Ramp duration=0",
                                         "Newton/Tolerance=1e-10",
                                         "Newton/Linear tolerance=1e-4",
                                         "Stop rules/At rest=false"};
    const auto               flat = read("verification/slope_45.prm", settings);
    const Case<2>            plane(*flat, MPI_COMM_SELF);
    State<2>                 expected = initial_state(plane);
    run(plane, expected);

    settings.insert(settings.end(),
                    {"Dimension=3",
                     "Grid/Lower corner=0, 0, 0",
                     "Grid/Upper corner=6, 1.5, 0.25",
                     "Boundary conditions/Names=base, back, near, far",
                     "Boundary conditions/near/Region=back",
                     "Boundary conditions/near/Type=roller",
                     "Boundary conditions/far/Region=front",
                     "Boundary conditions/far/Type=roller"});
    const auto    thick = read("verification/slope_45.prm", settings);
    const Case<3> slice(*thick, MPI_COMM_SELF);
    State<3>      state = initial_state(slice);
    run(slice, state);

    ASSERT_EQ(state.step, expected.step);
    std::map<std::pair<double, double>, std::size_t> place;
    double                                           moved = 0.;
    for (std::size_t p = 0; p < expected.points.n_points(); ++p)
      {
        const Point<2> &x   = expected.points.initial_position[p];
        place[{x[0], x[1]}] = p;
        moved = std::max(moved, (expected.points.position[p] - x).norm());
      }
    double position = 0., stress = 0., strain = 0., plastic = 0., sideways = 0.;
    ASSERT_EQ(state.points.n_points(), 2 * expected.points.n_points());
    for (std::size_t q = 0; q < state.points.n_points(); ++q)
      {
        const Point<3> &x0 = state.points.initial_position[q];
        ASSERT_EQ(place.count({x0[0], x0[1]}), 1u);
        const std::size_t p = place[{x0[0], x0[1]}];
        const Point<3>   &x = state.points.position[q];
        position            = std::max(position,
                            std::hypot(x[0] - expected.points.position[p][0],
                                       x[1] - expected.points.position[p][1]));
        sideways            = std::max(sideways, std::abs(x[2] - x0[2]));
        stress =
          std::max(stress,
                   (state.points.stress[q] - expected.points.stress[p]).norm());
        const double e = expected.points.scalar("plastic strain")[p];
        plastic        = std::max(plastic, e);
        strain =
          std::max(strain,
                   std::abs(state.points.scalar("plastic strain")[q] - e));
      }
    EXPECT_GT(moved, 0.02); // it slides
    EXPECT_GT(plastic, 0.01);
    EXPECT_LT(position, 1e-8 * moved);
    EXPECT_LT(stress, 1e-7);
    EXPECT_LT(strain, 1e-8);
    EXPECT_LT(sideways, 1e-10);
  }
} // namespace simulation_three_dimensions
