// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
#include <waker/particles/layer.h>
#include <waker/particles/soil_profile.h>
#include <waker/particles/sub_cells.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Waker
{
  namespace
  {
    /// A coordinate of a corner (m) in units of the sub-cells, put on a line
    /// of the lattice where only round-off keeps it off.
    template <int dim>
    double
    to_lattice(const BackgroundGrid<dim> &grid,
               const unsigned int         d,
               const unsigned int         points_per_direction,
               const double               x)
    {
      const double lower = grid.lower_corner()[d];
      const double scale = points_per_direction * grid.inverse_cell_size();
      const double n     = std::round((grid.upper_corner()[d] - lower) * scale);
      const double X     = std::clamp((x - lower) * scale, 0., n);
      const double line  = std::round(X);
      const double tolerance =
        1e-11 + 1e-15 * scale * std::max(std::abs(x), std::abs(lower));
      return std::abs(X - line) < tolerance ? line : X;
    }


    /// A point to be: its place in the order of creation and its part.
    template <int dim>
    struct Seed
    {
      std::uint64_t order;
      unsigned int  layer;
      double        volume;
      Point<dim>    position;
    };


    template <int dim>
    std::vector<Seed<dim>>
    make_seeds(const BackgroundGrid<dim>     &grid,
               const std::vector<Layer<dim>> &layers,
               const MaterialPointParameters &parameters)
    {
      const unsigned int n    = parameters.points_per_direction;
      const double       size = grid.cell_size() / n;
      // Below this a part is no point worth having, whatever the user says.
      const double      minimum_share = std::max(parameters.minimum_cut, 1e-6);
      const Point<dim> &lower         = grid.lower_corner();

      // Cells lexicographically, sub-cells likewise within their cell.
      const auto order = [&](const std::array<int, 3> &index) {
        std::uint64_t cell = 0, sub_cell = 0;
        for (int d = dim - 1; d >= 0; --d)
          {
            cell     = cell * grid.n_nodes_per_direction()[d] + index[d] / n;
            sub_cell = sub_cell * n + index[d] % n;
          }
        return cell * Utilities::pow(n, dim) + sub_cell;
      };

      std::vector<Seed<dim>> seeds;
      for (unsigned int l = 0; l < layers.size(); ++l)
        {
          Polygon corners = layers[l].corners;
          for (auto &corner : corners)
            for (unsigned int d = 0; d < 2; ++d)
              corner[d] = to_lattice(grid, d, n, corner[d]);
          const std::vector<SubCellPart> parts = cut_sub_cells(corners);

          std::vector<IntervalPart> slices = {{0, 1., 0.5}};
          if (dim == 3)
            slices = cut_intervals(to_lattice(grid, 2, n, layers[l].begin),
                                   to_lattice(grid, 2, n, layers[l].end),
                                   minimum_share);

          std::vector<SubCellPart> merged;
          double                   merged_for = -1.;
          for (const IntervalPart &slice : slices)
            {
              // What counts is the share of the whole sub-cell. A layer of one
              // thin slice is cut as in 2D.
              const double share =
                slice.share < minimum_share ? 1. : std::min(1., slice.share);
              if (merged_for != share)
                merged = merge_small_parts(parts, minimum_share / share);
              merged_for = share;
              for (const SubCellPart &part : merged)
                {
                  Seed<dim> seed;
                  seed.layer = l;
                  seed.order =
                    order({{part.index[0], part.index[1], slice.index}});
                  seed.volume = part.share * slice.share * std::pow(size, dim);
                  for (unsigned int d = 0; d < dim; ++d)
                    seed.position[d] =
                      lower[d] +
                      size * (d < 2 ? part.centroid[d] : slice.centroid);
                  seeds.push_back(seed);
                }
            }
        }
      std::stable_sort(seeds.begin(),
                       seeds.end(),
                       [](const Seed<dim> &a, const Seed<dim> &b) {
                         return a.order < b.order;
                       });
      return seeds;
    }
  } // namespace


  template <int dim>
  MaterialPoints<dim>
  make_material_points(const BackgroundGrid<dim>          &grid,
                       const std::vector<LayerParameters> &layer_parameters,
                       const MaterialPointParameters      &parameters,
                       const std::vector<std::string>     &material_names,
                       const std::vector<double>          &densities)
  {
    Assert(densities.size() == material_names.size(),
           ExcDimensionMismatch(densities.size(), material_names.size()));
    if (layer_parameters.empty())
      throw UserError("Soil profile",
                      "has no layers, so there are no material points",
                      "at least one layer");
    if (parameters.points_per_direction == 0)
      throw UserError("Material points/Points per direction",
                      "is 0, so there are no material points",
                      "1 to 10");

    std::vector<Layer<dim>> layers;
    double                  volume = 0., mass = 0.;
    for (const LayerParameters &layer : layer_parameters)
      {
        layers.push_back(place_layer(grid, layer));
        fill_layer(layer, material_names, layers.back());
        volume += layers.back().volume();
        mass += layers.back().volume() * densities[layers.back().material];
      }
    check_overlap(layers);

    const std::vector<Seed<dim>> seeds = make_seeds(grid, layers, parameters);
    const std::size_t            n     = seeds.size();
    Tensor<1, dim>               half_size;
    for (unsigned int d = 0; d < dim; ++d)
      half_size[d] = grid.cell_size() / (2. * parameters.points_per_direction);

    MaterialPoints<dim> points;
    points.resize(n);
    double point_volume = 0., point_mass = 0.;
    for (std::size_t p = 0; p < n; ++p)
      {
        const Layer<dim> &layer = layers[seeds[p].layer];
        points.id[p]            = p;
        points.material[p]      = layer.material;
        points.volume[p]        = seeds[p].volume;
        points.mass[p]          = seeds[p].volume * densities[layer.material];
        points.half_size[p]     = half_size;
        points.position[p]      = seeds[p].position;
        points.initial_position[p] = seeds[p].position;
        points.velocity[p]         = layer.velocity_at(seeds[p].position);
        point_volume += points.volume[p];
        point_mass += points.mass[p];
      }
    AssertThrow(std::abs(point_volume - volume) <= 1e-10 * volume,
                ExcMessage("The material points have " + to_text(point_volume) +
                           " m^dim, their profile " + to_text(volume)));
    AssertThrow(std::abs(point_mass - mass) <= 1e-10 * mass,
                ExcMessage("The material points have " + to_text(point_mass) +
                           " Mg, their profile " + to_text(mass)));
    return points;
  }


  template <int dim>
  double
  profile_volume(const BackgroundGrid<dim>          &grid,
                 const std::vector<LayerParameters> &layers)
  {
    double volume = 0.;
    for (const LayerParameters &layer : layers)
      volume += place_layer(grid, layer).volume();
    return volume;
  }


  template MaterialPoints<2>
  make_material_points(const BackgroundGrid<2> &,
                       const std::vector<LayerParameters> &,
                       const MaterialPointParameters &,
                       const std::vector<std::string> &,
                       const std::vector<double> &);
  template MaterialPoints<3>
  make_material_points(const BackgroundGrid<3> &,
                       const std::vector<LayerParameters> &,
                       const MaterialPointParameters &,
                       const std::vector<std::string> &,
                       const std::vector<double> &);
  template double
  profile_volume(const BackgroundGrid<2> &,
                 const std::vector<LayerParameters> &);
  template double
  profile_volume(const BackgroundGrid<3> &,
                 const std::vector<LayerParameters> &);
} // namespace Waker
