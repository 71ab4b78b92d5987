// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_faces.h>

#include "mapping_lattice.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace surface_contour_faces
{
  using namespace Waker;

  namespace
  {
    /// Boxes with their edges on whole numbers, as voxels: everything that the
    /// search must find, without its shortcuts.
    class Voxels
    {
    public:
      Voxels(const std::vector<Box<3>> &boxes,
             const BoxUnionRules<3>    &rules,
             const int                  height = 32)
        : n{{32, height, 32}}
        , inside(n[0] * n[1] * n[2])
      {
        for (const Box<3> &box : boxes)
          for (int k = box.lower[2]; k < box.upper[2]; ++k)
            for (int j = box.lower[1]; j < box.upper[1]; ++j)
              for (int i = box.lower[0]; i < box.upper[0]; ++i)
                inside[number({{i, j, k}})] = 1;
        for_all([&](const std::array<int, 3> &v) {
          if (is_beyond_a_closed_face(v, rules))
            inside[number(v)] = 1;
        });
        for (const unsigned int d : {0, 2, 1})
          fill(d, rules.minimum_gap[d]);
        for_all([&](const std::array<int, 3> &v) {
          if (is_beyond_a_closed_face(v, rules))
            inside[number(v)] = 0;
        });
      }

      int
      volume() const
      {
        return std::count(inside.begin(), inside.end(), 1);
      }

      /// {direction, voxel above the face} -> 1 if the face looks up, else -1.
      using Faces = std::map<std::array<int, 4>, int>;

      Faces
      faces() const
      {
        Faces result;
        for (int d = 0; d < 3; ++d)
          for_all([&](const std::array<int, 3> &v) {
            std::array<int, 3> below = v;
            if (--below[d] < 0)
              return;
            const int face = int(inside[number(below)]) - inside[number(v)];
            if (face != 0)
              result[{{d, v[0], v[1], v[2]}}] = face;
          });
        return result;
      }

      /// The same of pairs of triangles that are halves of rectangles.
      static Faces
      faces_of(const Facets<3> &facets)
      {
        Faces result;
        for (std::size_t f = 0; f < facets.size(); f += 2)
          {
            const auto &a = facets[f].vertices;
            const auto &b = facets[f + 1].vertices;
            EXPECT_EQ(a[0], b[0]);
            EXPECT_EQ(a[2], b[1]);
            Point<3> lower = a[0];
            Point<3> upper = a[0];
            for (const Point<3> &x : {a[1], a[2], b[2]})
              for (unsigned int d = 0; d < 3; ++d)
                {
                  lower[d] = std::min(lower[d], x[d]);
                  upper[d] = std::max(upper[d], x[d]);
                }
            int direction = 0;
            for (int d = 0; d < 3; ++d)
              if (std::abs(facets[f].normal[d]) > 0.5)
                direction = d;
            EXPECT_EQ(lower[direction], upper[direction]);
            EXPECT_EQ(facets[f].normal, facets[f + 1].normal);
            EXPECT_EQ(facets[f].on_face, facets[f + 1].on_face);
            upper[direction] += 1.;
            for (int i = lower[0]; i < upper[0]; ++i)
              for (int j = lower[1]; j < upper[1]; ++j)
                for (int k = lower[2]; k < upper[2]; ++k)
                  result[{{direction, i, j, k}}] +=
                    facets[f].normal[direction] > 0. ? 1 : -1;
          }
        return result;
      }

    private:
      template <typename Function>
      void
      for_all(const Function &f) const
      {
        for (int k = 0; k < n[2]; ++k)
          for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
              f(std::array<int, 3>{{i, j, k}});
      }

      int
      number(const std::array<int, 3> &v) const
      {
        return (v[2] * n[1] + v[1]) * n[0] + v[0];
      }

      static bool
      is_beyond_a_closed_face(const std::array<int, 3> &v,
                              const BoxUnionRules<3>   &rules)
      {
        for (unsigned int d = 0; d < 3; ++d)
          if ((rules.is_closed(2 * d) && v[d] < rules.lower[d]) ||
              (rules.is_closed(2 * d + 1) && v[d] >= rules.upper[d]))
            return true;
        return false;
      }

      void
      fill(const unsigned int d, const double gap)
      {
        for_all([&](std::array<int, 3> v) {
          // Each row once, from its first voxel.
          if (v[d] > 0)
            return;
          int last = -1; // inside
          for (; v[d] < n[d]; ++v[d])
            if (inside[number(v)])
              {
                const int here = v[d];
                if (last >= 0 && here - last - 1 <= gap)
                  for (v[d] = last + 1; v[d] < here; ++v[d])
                    inside[number(v)] = 1;
                last = v[d] = here;
              }
        });
      }

      std::array<int, 3>         n;
      std::vector<unsigned char> inside;
    };


    void
    expect_closed(const Facets<3> &facets, const double tolerance)
    {
      Tensor<1, 3> sum;
      for (const Facet<3> &facet : facets)
        sum += facet.measure() * facet.normal;
      ASSERT_LT(sum.norm(), tolerance);
    }


    /// A ball of domains with edges of 1 on a lattice, `noise` off it.
    std::vector<Box<3>>
    ball(Lattice::Random &random, const double radius, const double noise)
    {
      std::vector<Box<3>> boxes;
      const int           n      = std::ceil(radius);
      const Tensor<1, 3>  offset = random.vector<3>(0., 2.);
      for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j)
          for (int k = -n; k <= n; ++k)
            {
              Point<3> x(i, j, k);
              if (x.norm() > radius)
                continue;
              x += offset + noise * random.vector<3>(-1., 1.);
              Tensor<1, 3> half;
              half[0] = half[1] = half[2] = 0.5;
              boxes.push_back({x - half, x + half});
            }
      return boxes;
    }
  } // namespace



  TEST(Surface, faces_are_those_of_the_brute_force_union)
  {
    std::mt19937  random(8);
    BoxUnionFaces search;
    Facets<3>     facets;
    unsigned int  n_filled = 0, n_on_face = 0;
    for (unsigned int set = 0; set < 150; ++set)
      {
        // Some stretched along y, so that a block has very many coordinates.
        const int  stretch = set % 10 == 0 ? 20 : 1;
        const auto number  = [&](const int low, const int high) {
          return low + int(random() % (high - low + 1));
        };
        const int           extent = number(3, stretch > 1 ? 5 : 20);
        const int           size   = number(1, stretch > 1 ? 2 : 8);
        std::vector<Box<3>> boxes(number(1, stretch > 1 ? 200 : 60));
        for (Box<3> &box : boxes)
          for (unsigned int d = 0; d < 3; ++d)
            {
              const int s  = d == 1 ? stretch : 1;
              box.lower[d] = number(1, s * extent);
              box.upper[d] = box.lower[d] + number(s, s * size);
            }
        BoxUnionRules<3> rules;
        for (unsigned int d = 0; d < 3; ++d)
          {
            rules.minimum_gap[d] = number(0, 3) * (d == 1 ? stretch : 1);
            rules.lower[d]       = number(1, 8);
            rules.upper[d] =
              rules.lower[d] + number(4, 20) * (d == 1 ? stretch : 1);
          }
        rules.restricted   = set % 2;
        rules.closed_faces = set % 3 == 0 ? number(0, 63) : 0;

        SCOPED_TRACE(set);
        const Voxels voxels(boxes, rules, 32 * stretch);
        search.find(boxes, rules, facets);
        ASSERT_EQ(Voxels::faces_of(facets), voxels.faces());
        ASSERT_NEAR(enclosed_volume(facets), voxels.volume(), 1e-9);
        expect_closed(facets, 1e-9);

        for (const Facet<3> &facet : facets)
          {
            int face = -1;
            for (unsigned int f = 0; f < 6; ++f)
              {
                const double place =
                  f % 2 == 0 ? rules.lower[f / 2] : rules.upper[f / 2];
                if (rules.is_closed(f) &&
                    facet.normal[f / 2] == (f % 2 == 0 ? -1. : 1.) &&
                    facet.vertices[0][f / 2] == place)
                  face = f;
              }
            ASSERT_EQ(facet.on_face, face);
            n_on_face += face >= 0;
          }
        rules.minimum_gap = Tensor<1, 3>();
        n_filled +=
          voxels.volume() > Voxels(boxes, rules, 32 * stretch).volume();
      }
    EXPECT_GT(n_filled, 50u);
    EXPECT_GT(n_on_face, 100u);
  }



  TEST(Surface, faces_need_the_points_near_the_surface_only)
  {
    Lattice::Random random(9);
    BoxUnionFaces   search;
    for (const double noise : {0., 1e-14, 0.05, 0.2})
      for (const double gap : {0., 0.3, 0.6})
        {
          const std::vector<Box<3>> boxes = ball(random, 6., noise);
          BoxUnionRules<3>          rules;
          rules.tolerance = 1e-9;
          for (unsigned int d = 0; d < 3; ++d)
            rules.minimum_gap[d] = gap;
          Facets<3> some;
          Facets<3> all;
          search.find(boxes, rules, some);
          rules.restricted = false;
          search.find(boxes, rules, all);
          ASSERT_EQ(some.size(), all.size());
          for (std::size_t f = 0; f < all.size(); ++f)
            for (unsigned int v = 0; v < 3; ++v)
              ASSERT_LT(some[f].vertices[v].distance(all[f].vertices[v]), 1e-8);
          expect_closed(some, 1e-7);
          if (noise < 1e-10)
            {
              ASSERT_NEAR(enclosed_volume(some), boxes.size(), 1e-6);
            }
        }
  }
} // namespace surface_contour_faces
