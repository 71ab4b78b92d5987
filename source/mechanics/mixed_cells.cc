// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/mixed_cells.h>

#include <algorithm>
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


    /// What lies in a cell.
    struct Contents
    {
      std::size_t   n_points = 0;
      std::uint32_t first    = 0; // material of its first point
      bool          mixed    = false;
      double        volume = 0., mass = 0.;
      double        per_K = 0., per_G = 0.; // sums of volume by modulus
      double        least_G = 0., most_G = 0., least_M = 0., most_M = 0.;
      std::uint32_t number = 0; // of its material in the mixture
    };
  } // namespace


  template <int dim>
  ElasticMixture
  elastic_mixture(const Materials           &materials,
                  const BackgroundGrid<dim> &grid,
                  const MaterialPoints<dim> &points)
  {
    ElasticMixture mixture;
    for (const auto &m : materials)
      mixture.materials.push_back(
        elastic(m->density(), m->bulk_modulus(), m->shear_modulus()));
    mixture.of_point = points.material;

    // By number of the cell's first node: the same order on every machine.
    std::map<unsigned int, Contents> cells;
    const auto                       cell_of = [&](const std::size_t p) {
      return grid.node(grid.cell_index(points.position[p]));
    };
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Material &m = *materials[points.material[p]];
        const double    K = m.bulk_modulus(), G = m.shear_modulus();
        const double    M    = K + 4. / 3. * G;
        Contents       &cell = cells[cell_of(p)];
        if (cell.n_points++ == 0)
          {
            cell.first   = points.material[p];
            cell.least_G = cell.most_G = G;
            cell.least_M = cell.most_M = M;
          }
        const Material &first = *materials[cell.first];
        cell.mixed =
          cell.mixed || K != first.bulk_modulus() || G != first.shear_modulus();
        cell.volume += points.volume[p];
        cell.mass += points.mass[p];
        cell.per_K += points.volume[p] / K;
        cell.per_G += points.volume[p] / G;
        cell.least_G = std::min(cell.least_G, G);
        cell.most_G  = std::max(cell.most_G, G);
        cell.least_M = std::min(cell.least_M, M);
        cell.most_M  = std::max(cell.most_M, M);
      }

    for (auto &entry : cells)
      if (Contents &cell = entry.second; cell.mixed)
        {
          ++mixture.cells.n_cells;
          mixture.cells.n_points += cell.n_points;
          mixture.cells.ratio = std::max({mixture.cells.ratio,
                                          cell.most_G / cell.least_G,
                                          cell.most_M / cell.least_M});
          cell.number         = mixture.materials.size();
          mixture.materials.push_back(elastic(cell.mass / cell.volume,
                                              cell.volume / cell.per_K,
                                              cell.volume / cell.per_G));
        }
    if (mixture.cells.n_cells > 0)
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (const Contents &cell = cells.at(cell_of(p)); cell.mixed)
          mixture.of_point[p] = cell.number;
    return mixture;
  }


  template ElasticMixture
  elastic_mixture(const Materials &,
                  const BackgroundGrid<2> &,
                  const MaterialPoints<2> &);
  template ElasticMixture
  elastic_mixture(const Materials &,
                  const BackgroundGrid<3> &,
                  const MaterialPoints<3> &);
} // namespace Waker
