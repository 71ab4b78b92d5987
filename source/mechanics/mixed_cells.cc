// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/mixed_cells.h>
#include <waker/mechanics/stress_update.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

namespace Waker
{
  namespace
  {
    std::unique_ptr<Material>
    elastic(const double density, const double K, const double G)
    {
      return std::make_unique<LinearElastic>(density,
                                             9. * K * G / (3. * K + G),
                                             (3. * K - 2. * G) /
                                               (2. * (3. * K + G)));
    }


    /// Volume per modulus of soil: of layers in series these add.
    struct Compliance
    {
      double volume = 0., per_K = 0., per_G = 0.;

      void
      add(const double share, const double K, const double G)
      {
        volume += share;
        per_K += share / K;
        per_G += share / G;
      }

      double
      K() const
      {
        return volume / per_K;
      }

      double
      G() const
      {
        return volume / per_G;
      }
    };


    /// What lies in a cell.
    struct Contents
    {
      Compliance  soil;
      std::size_t n_points = 0;
      double      least_G = 0., most_G = 0., least_M = 0., most_M = 0.;

      void
      add(const double volume, const double K, const double G)
      {
        const double M = K + 4. / 3. * G;
        soil.add(volume, K, G);
        least_G = n_points == 0 ? G : std::min(least_G, G);
        least_M = n_points == 0 ? M : std::min(least_M, M);
        most_G  = std::max(most_G, G);
        most_M  = std::max(most_M, M);
        ++n_points;
      }

      bool
      is_mixed() const
      {
        return least_G != most_G || least_M != most_M;
      }
    };


    /// By number of the cell's first node: the same order on every machine.
    using Cells = std::map<unsigned int, Contents>;


    /// The soil that the support domain of point p reaches over: whole cells'
    /// means, by the domain's shares.
    template <int dim>
    Compliance
    under_domain(const BackgroundGrid<dim> &grid,
                 const Cells               &cells,
                 const MaterialPoints<dim> &points,
                 const std::size_t          p)
    {
      using Index    = typename BackgroundGrid<dim>::Index;
      Point<dim> low = points.position[p], high = low;
      for (unsigned int d = 0; d < dim; ++d)
        {
          // Round-off does not reach into the next cell.
          const double half = (1. - 1e-9) * points.half_size[p][d];
          low[d] -= half;
          high[d] += half;
        }
      const Index  first = grid.cell_index(low), last = grid.cell_index(high);
      unsigned int n = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n *= last[d] - first[d] + 1;

      Compliance result;
      for (unsigned int k = 0; k < n; ++k)
        {
          Index        cell;
          unsigned int rest  = k;
          double       share = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int width = last[d] - first[d] + 1;
              cell[d]                  = first[d] + rest % width;
              rest /= width;
              const double begin =
                grid.origin()[d] + cell[d] * grid.cell_size();
              share *= std::min(high[d], begin + grid.cell_size()) -
                       std::max(low[d], begin);
            }
          // Of air there is no stiffness.
          const auto found = cells.find(grid.node(cell));
          if (found != cells.end())
            result.add(share, found->second.soil.K(), found->second.soil.G());
        }
      return result;
    }
  } // namespace


  bool
  may_mix(const Materials &materials)
  {
    return !std::all_of(materials.begin(), materials.end(), [&](const auto &m) {
      return m->bulk_modulus() == materials[0]->bulk_modulus() &&
             m->shear_modulus() == materials[0]->shear_modulus() &&
             !m->stiffness_variable();
    });
  }


  template <int dim>
  ElasticMixture
  elastic_mixture(const Materials           &materials,
                  const BackgroundGrid<dim> &grid,
                  const ShapeFunctions       functions,
                  const MaterialPoints<dim> &points)
  {
    ElasticMixture mixture;
    for (const auto &m : materials)
      mixture.materials.push_back(
        elastic(m->density(), m->bulk_modulus(), m->shear_modulus()));
    mixture.of_point = points.material;
    // Nothing to mix, and no rounding.
    if (!may_mix(materials))
      return mixture;

    Cells      cells;
    const auto cell_of = [&](const std::size_t p) {
      return grid.node(grid.cell_index(points.position[p]));
    };
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Material &m     = *materials[points.material[p]];
        const double    ratio = stiffness_ratio(points, materials, p);
        cells[cell_of(p)].add(points.volume[p],
                              ratio * m.bulk_modulus(),
                              ratio * m.shear_modulus());
      }
    for (const auto &entry : cells)
      if (const Contents &cell = entry.second; cell.is_mixed())
        {
          ++mixture.cells.n_cells;
          mixture.cells.n_points += cell.n_points;
          mixture.cells.ratio = std::max({mixture.cells.ratio,
                                          cell.most_G / cell.least_G,
                                          cell.most_M / cell.least_M});
        }

    // Points of one compliance share a material.
    std::map<std::array<double, 2>, std::uint32_t> numbers;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Material  &m    = *materials[points.material[p]];
        const Compliance soil = functions == ShapeFunctions::gimp
                                  ? under_domain(grid, cells, points, p)
                                  : cells.at(cell_of(p)).soil;
        // Its own, but for rounding.
        if (std::abs(soil.K() - m.bulk_modulus()) <= 1e-12 * m.bulk_modulus() &&
            std::abs(soil.G() - m.shear_modulus()) <= 1e-12 * m.shear_modulus())
          continue;
        const auto [entry, is_new] =
          numbers.try_emplace({{soil.K(), soil.G()}}, mixture.materials.size());
        if (is_new)
          mixture.materials.push_back(elastic(m.density(), soil.K(), soil.G()));
        mixture.of_point[p] = entry->second;
      }
    return mixture;
  }


  template ElasticMixture
  elastic_mixture(const Materials &,
                  const BackgroundGrid<2> &,
                  const ShapeFunctions,
                  const MaterialPoints<2> &);
  template ElasticMixture
  elastic_mixture(const Materials &,
                  const BackgroundGrid<3> &,
                  const ShapeFunctions,
                  const MaterialPoints<3> &);
} // namespace Waker
