// SPDX-License-Identifier: LGPL-2.1-or-later
// Mohr-Coulomb's returns of blocks against those of single points, in all
// regions of the surface.
#include <waker/materials/mohr_coulomb.h>
#include <waker/materials/principal_stress.h>

#include "mapping_lattice.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <string>

namespace materials_mohr_coulomb_lanes
{
  using namespace Waker;

  namespace
  {
    const double           degree   = std::acos(-1.) / 180.;
    constexpr double       infinity = std::numeric_limits<double>::infinity();
    constexpr unsigned int N        = Material::block_size;

    // Cohesion, both angles, plastic strain, stiffness ratio.
    constexpr unsigned int n_variables = 5, plastic = 3;


    /// Of these principal values; turned about z, or anyhow.
    SymmetricTensor<2, 3>
    turned(const Tensor<1, 3> &values,
           const bool          in_plane,
           Lattice::Random    &random)
    {
      Tensor<2, 3> s;
      for (unsigned int d = 0; d < 3; ++d)
        s[d][d] = values[d];
      for (unsigned int axis = in_plane ? 2 : 0; axis < 3; ++axis)
        {
          const double       angle = random(-2., 2.);
          const unsigned int i = (axis + 1) % 3, j = (axis + 2) % 3;
          Tensor<2, 3>       Q = unit_symmetric_tensor<3>();
          Q[i][i] = Q[j][j] = std::cos(angle);
          Q[i][j]           = -std::sin(angle);
          Q[j][i]           = std::sin(angle);
          s                 = Q * s * transpose(Q);
        }
      return symmetrize(s);
    }


    /// Which principal values are those of the cut-off, T, and which are the
    /// same as the next.
    std::string
    region(const SymmetricTensor<2, 3> &stress, const double tension)
    {
      const auto v    = principal_stress(stress).value;
      const auto same = [](const double a, const double b) {
        return std::abs(a - b) < 1e-9;
      };
      std::string name;
      for (unsigned int d = 0; d < 3; ++d)
        name += same(v[d], tension) ? 'T' : 's';
      return name + (same(v[0], v[1]) ? '=' : '>') +
             (same(v[1], v[2]) ? '=' : '>');
    }


    /// A block and what its points become one by one.
    struct Points
    {
      Material::Block       block = {};
      double                variables[n_variables][N];
      SymmetricTensor<2, 3> stress[N];
      SymmetricTensor<4, 3> tangent[N];
      double                energy[N], plastic_strain[N];
      /// The least difference of two principal values of the elastic stress, or
      /// 1 kPa: the tangent divides differences of round-off by it.
      double gap[N];
    };


    struct Regions
    {
      double                              tension;
      bool                                in_plane;
      Lattice::Random                     random{229};
      std::map<std::string, unsigned int> counts = {};

      /// Trial stresses around the surface, near to it and far; strengths and
      /// stiffnesses differ from point to point.
      void
      draw(const MohrCoulomb &soil, const unsigned int n, Points &points)
      {
        for (unsigned int l = 0; l < n; ++l)
          {
            const double phi = random(0., 1.) < 0.1 ? 0. : random(5., 40.);
            double       own[n_variables] = {random(1., 6.),
                                             phi,
                                             phi * std::max(0., random(-0.5, 1.)),
                                             0.1,
                                             random(0.5, 2.)};
            const double scale            = random(0., 1.) < 0.5 ? 5. : 40.;
            auto stress = turned(random.vector<3>(-2. * scale, 1.5 * scale),
                                 in_plane,
                                 random);
            const auto strain =
              turned(random.vector<3>(-1e-3, 1e-3), in_plane, random);
            for (unsigned int v = 0; v < n_variables; ++v)
              points.variables[v][l] = own[v];
            for (unsigned int a = 0; a < 6; ++a)
              {
                points.block.strain_increment[a][l] =
                  strain.access_raw_entry(a);
                points.block.stress[a][l] = stress.access_raw_entry(a);
              }
            auto          trial = stress;
            LinearElastic elastic(1.8, 5000. * own[4], 0.3);
            elastic.update(strain, trial, nullptr, nullptr);
            const auto v  = principal_stress(trial).value;
            points.gap[l] = std::min({1., v[0] - v[1], v[1] - v[2]});
            points.energy[l] =
              soil.update(strain, stress, own, &points.tangent[l]);
            points.stress[l]         = stress;
            points.plastic_strain[l] = own[plastic];
            const double sine        = std::sin(phi * degree);
            const double apex =
              sine > 0. ? own[0] * std::cos(phi * degree) / sine : infinity;
            ++counts[own[plastic] > 0.1
                       ? region(stress, std::min(tension, apex))
                       : "elastic"];
          }
      }
    };


    /// Largest differences between blocks and points.
    struct Differences
    {
      double stress = 0., history = 0., tangent = 0.;

      void
      compare(const MohrCoulomb &soil, const unsigned int n, Points &points)
      {
        double copy[n_variables][N];
        std::copy_n(&points.variables[0][0], n_variables * N, &copy[0][0]);
        Material::Block for_tangent   = points.block;
        for_tangent.variables         = copy;
        points.block.variables        = points.variables;
        constexpr unsigned int all[6] = {0, 1, 2, 3, 4, 5};
        double                 D[36][N];
        soil.update_block(n, points.block);
        soil.tangent_block(n, for_tangent, 6, all, D);
        const auto take = [](double &most, const double a, const double b) {
          const double difference = std::abs(a - b);
          most = difference <= most ? most : difference; // NaN stays
        };
        for (unsigned int l = 0; l < n; ++l)
          {
            for (unsigned int a = 0; a < 6; ++a)
              take(stress,
                   points.block.stress[a][l],
                   points.stress[l].access_raw_entry(a));
            take(history, points.block.dissipation[l], points.energy[l]);
            take(history,
                 points.variables[plastic][l],
                 points.plastic_strain[l]);
            for (unsigned int a = 0; a < 36; ++a)
              take(tangent,
                   points.gap[l] * D[a][l],
                   points.gap[l] * points.tangent[l].access_raw_entry(a));
          }
      }
    };
  } // namespace


  TEST(Materials, mohr_coulomb_in_blocks_is_as_points_in_all_regions)
  {
    for (const double tension : {infinity, 1., 0.})
      for (const bool in_plane : {true, false})
        {
          MohrCoulomb soil(1.8, 5000., 0.3, {5., 30., 0.}, tension);
          soil.let_stiffness_vary();
          Regions     regions{tension, in_plane};
          Differences differences;
          for (unsigned int n = 0; n < 400; ++n)
            {
              Points points = {};
              regions.draw(soil, 1 + n % N, points);
              differences.compare(soil, 1 + n % N, points);
            }
          const std::string name =
            std::to_string(tension) + (in_plane ? " in plane" : " in space");
          EXPECT_LT(differences.stress, 1e-12) << name;
          EXPECT_LT(differences.history, 1e-14) << name;
          EXPECT_LT(differences.tangent, 2e-9) << name;

          std::vector<std::string> wanted = {
            "elastic", "sss>>", "sss=>", "sss>=", "TTT=="};
          if (tension < 2.)
            for (const char *const key : {"Tss>>", "TTs=>", "Tss>="})
              wanted.push_back(key);
          std::string found;
          for (const auto &[key, count] : regions.counts)
            found += key + ' ' + std::to_string(count) + ", ";
          for (const std::string &key : wanted)
            EXPECT_GT(regions.counts[key], 10u)
              << name << ": " << key << " of " << found;
        }
  }
} // namespace materials_mohr_coulomb_lanes
