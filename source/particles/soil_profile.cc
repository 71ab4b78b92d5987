// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/sizes.h>
#include <waker/particles/layer.h>
#include <waker/particles/seeds.h>
#include <waker/particles/soil_profile.h>
#include <waker/particles/sub_cells.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Is there memory for cutting the layers, and for their points?
    template <int dim>
    void
    check_size(const BackgroundGrid<dim>     &grid,
               const std::vector<Layer<dim>> &layers,
               const unsigned int             points_per_direction)
    {
      const double size     = grid.cell_size() / points_per_direction;
      double       n_points = 0., n_cut = 0.;
      for (const Layer<dim> &layer : layers)
        {
          n_points += layer.volume() / std::pow(size, dim);
          double squares = 1.;
          for (unsigned int d = 0; d < 2; ++d)
            {
              const auto [low, high] =
                std::minmax_element(layer.corners.begin(),
                                    layer.corners.end(),
                                    [d](const auto &a, const auto &b) {
                                      return a[d] < b[d];
                                    });
              squares *= ((*high)[d] - (*low)[d]) / size + 2.;
            }
          n_cut = std::max(n_cut, squares);
        }
      // Per square: two sets of moments, a part, and one after merging. Per
      // point: a seed and its copy while they are sorted, and the arrays.
      const double per_square = 2. * 24. + 2. * sizeof(SubCellPart);
      const double per_point =
        2. * sizeof(Seed<dim>) + 8. * (5 + 5 * dim + 6 + 4);
      std::ostringstream what;
      what << "is " << points_per_direction << ": " << n_points
           << " material points";
      require_memory("Material points/Points per direction",
                     what.str(),
                     per_square * n_cut + per_point * n_points,
                     "fewer of them, or larger cells");
    }


    /// Cut sub-cells keep every volume to round-off. Rows follow the mid-point
    /// rule, and miss corners between their lines; stairs stand out of a slope,
    /// or back.
    void
    check_volume(const double       points,
                 const double       profile,
                 const unsigned int dim,
                 const Placement    placement)
    {
      const double difference = std::abs(points - profile);
      const double most       = placement == Placement::rows              ? 0.01
                                : placement == Placement::whole_sub_cells ? 0.05
                                                                          : 1e-10;
      if (difference <= most * profile)
        return;
      std::ostringstream text;
      text << "have " << points << " m^" << dim << ", the soil profile "
           << profile;
      const std::string what = text.str();
      if (placement == Placement::rows)
        throw UserError("Material points/Placement",
                        "the rows " + what + ": corners lie inside rows",
                        "layers with their corners on lines between the rows, "
                        "or sub-cells");
      if (placement == Placement::whole_sub_cells)
        throw UserError("Material points/Placement",
                        "the whole sub-cells " + what,
                        "smaller cells, or sub-cells, which are cut");
      AssertThrow(false, ExcMessage("The material points " + what));
    }
  } // namespace


  template <int dim>
  MaterialPoints<dim>
  make_material_points(const BackgroundGrid<dim>          &grid,
                       const std::vector<LayerParameters> &layer_parameters,
                       const MaterialPointParameters      &parameters,
                       const std::vector<std::string>     &material_names,
                       const std::vector<double>          &densities,
                       std::vector<unsigned int>          *layers_of_points)
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
    check_size(grid, layers, parameters.points_per_direction);

    const std::vector<Seed<dim>> seeds = make_seeds(grid, layers, parameters);
    const std::size_t            n     = seeds.size();

    MaterialPoints<dim> points;
    points.resize(n);
    if (layers_of_points != nullptr)
      layers_of_points->clear();
    double point_volume = 0., point_mass = 0.;
    for (std::size_t p = 0; p < n; ++p)
      {
        const Layer<dim> &layer = layers[seeds[p].layer];
        points.id[p]            = p;
        points.material[p]      = layer.material;
        points.volume[p]        = seeds[p].volume;
        points.mass[p]          = seeds[p].volume * densities[layer.material];
        points.half_size[p]     = seeds[p].half_size;
        points.position[p]      = seeds[p].position;
        points.initial_position[p] = seeds[p].position;
        points.velocity[p]         = layer.velocity_at(seeds[p].position);
        points.stress[p]           = layer.stress_at(seeds[p].position);
        if (layers_of_points != nullptr)
          layers_of_points->push_back(seeds[p].layer);
        point_volume += points.volume[p];
        point_mass += points.mass[p];
      }
    check_volume(point_volume, volume, dim, parameters.placement);
    AssertThrow(parameters.placement != Placement::sub_cells ||
                  std::abs(point_mass - mass) <= 1e-10 * mass,
                ExcMessage("The material points have " + in_digits(point_mass) +
                           " Mg, their profile " + in_digits(mass)));
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
                       const std::vector<double> &,
                       std::vector<unsigned int> *);
  template MaterialPoints<3>
  make_material_points(const BackgroundGrid<3> &,
                       const std::vector<LayerParameters> &,
                       const MaterialPointParameters &,
                       const std::vector<std::string> &,
                       const std::vector<double> &,
                       std::vector<unsigned int> *);
  template double
  profile_volume(const BackgroundGrid<2> &,
                 const std::vector<LayerParameters> &);
  template double
  profile_volume(const BackgroundGrid<3> &,
                 const std::vector<LayerParameters> &);
} // namespace Waker
