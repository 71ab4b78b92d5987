// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/sizes.h>
#include <waker/particles/layer.h>
#include <waker/particles/rows.h>
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
      std::uint64_t  order;
      unsigned int   layer;
      double         volume;
      Point<dim>     position;
      Tensor<1, dim> half_size;
    };


    /// Cells lexicographically, sub-cells likewise within their cell.
    template <int dim>
    std::uint64_t
    place_in_order(const BackgroundGrid<dim> &grid,
                   const unsigned int         points_per_direction,
                   const std::array<int, 3>  &sub_cell)
    {
      const unsigned int n    = points_per_direction;
      std::uint64_t      cell = 0, within = 0;
      for (int d = dim - 1; d >= 0; --d)
        {
          cell   = cell * grid.n_nodes_per_direction()[d] + sub_cell[d] / n;
          within = within * n + sub_cell[d] % n;
        }
      return cell * Utilities::pow(n, dim) + within;
    }


    /// Parts of the sub-cells; the support domains are whole sub-cells.
    template <int dim>
    void
    add_sub_cells(const BackgroundGrid<dim>     &grid,
                  const Layer<dim>              &layer,
                  const Polygon                 &corners,
                  const MaterialPointParameters &parameters,
                  const unsigned int             number,
                  std::vector<Seed<dim>>        &seeds)
    {
      const unsigned int n    = parameters.points_per_direction;
      const double       size = grid.cell_size() / n;
      // Below this a part is no point worth having, whatever the user says.
      const double minimum_share = std::max(parameters.minimum_cut, 1e-6);
      const std::vector<SubCellPart> parts = cut_sub_cells(corners);

      std::vector<IntervalPart> slices = {{0, 1., 0.5}};
      if (dim == 3)
        slices = cut_intervals(to_lattice(grid, 2, n, layer.begin),
                               to_lattice(grid, 2, n, layer.end),
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
              seed.layer = number;
              seed.order =
                place_in_order(grid,
                               n,
                               {{part.index[0], part.index[1], slice.index}});
              seed.volume = part.share * slice.share * std::pow(size, dim);
              for (unsigned int d = 0; d < dim; ++d)
                {
                  seed.position[d] =
                    grid.lower_corner()[d] +
                    size * (d < 2 ? part.centroid[d] : slice.centroid);
                  seed.half_size[d] = size / 2.;
                }
              seeds.push_back(seed);
            }
        }
    }


    /// Rectangles (boxes) that fill the rows of sub-cells.
    template <int dim>
    void
    add_rows(const BackgroundGrid<dim> &grid,
             const Layer<dim>          &layer,
             const Polygon             &corners,
             const unsigned int         n,
             const unsigned int         number,
             std::vector<Seed<dim>>    &seeds)
    {
      const double size = grid.cell_size() / n;
      // A support domain is at most as wide as a cell.
      const double        largest = n;
      std::vector<double> slices  = {0., 1.};
      if (dim == 3)
        slices = divide(to_lattice(grid, 2, n, layer.begin),
                        to_lattice(grid, 2, n, layer.end),
                        largest);
      const std::vector<RowRectangle> rectangles = fill_rows(corners, largest);
      for (std::size_t k = 0; k + 1 < slices.size(); ++k)
        for (const RowRectangle &rectangle : rectangles)
          {
            const std::array<double, 3> begin = {
              {rectangle.begin, double(rectangle.row), slices[k]}};
            const std::array<double, 3> end = {
              {rectangle.end, rectangle.row + 1., slices[k + 1]}};
            Seed<dim> seed;
            seed.layer                  = number;
            seed.volume                 = 1.;
            std::array<int, 3> sub_cell = {{0, 0, 0}};
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double centre = (begin[d] + end[d]) / 2.;
                sub_cell[d]         = static_cast<int>(std::floor(centre));
                seed.position[d]    = grid.lower_corner()[d] + size * centre;
                seed.half_size[d]   = size * (end[d] - begin[d]) / 2.;
                seed.volume *= 2. * seed.half_size[d];
              }
            seed.order = place_in_order(grid, n, sub_cell);
            seeds.push_back(seed);
          }
    }


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


    /// A layer that is thinner than round-off leaves no points, or others than
    /// it should: it would vanish in silence beside a large one.
    template <int dim>
    void
    check_layer_volume(const Layer<dim>             &layer,
                       const std::vector<Seed<dim>> &seeds,
                       const std::size_t             first,
                       const Placement               placement)
    {
      double volume = 0.;
      for (std::size_t i = first; i < seeds.size(); ++i)
        volume += seeds[i].volume;
      const double difference = std::abs(volume - layer.volume());
      // Whether rows fit is seen from all of them, see check_volume().
      const double most = placement == Placement::rows ? 1. : 1e-6;
      if (seeds.size() == first || !(difference <= most * layer.volume()))
        throw UserError(layer.path + "/Polygon",
                        "is too thin: the layer has " +
                          in_digits(layer.volume()) +
                          " m^dim, the points made of it " + in_digits(volume),
                        "a layer that can be seen in the grid");
    }


    template <int dim>
    std::vector<Seed<dim>>
    make_seeds(const BackgroundGrid<dim>     &grid,
               const std::vector<Layer<dim>> &layers,
               const MaterialPointParameters &parameters)
    {
      const unsigned int     n = parameters.points_per_direction;
      std::vector<Seed<dim>> seeds;
      for (unsigned int l = 0; l < layers.size(); ++l)
        {
          Polygon corners = layers[l].corners;
          for (auto &corner : corners)
            for (unsigned int d = 0; d < 2; ++d)
              corner[d] = to_lattice(grid, d, n, corner[d]);
          const std::size_t first = seeds.size();
          if (parameters.placement == Placement::rows)
            add_rows(grid, layers[l], corners, n, l, seeds);
          else
            add_sub_cells(grid, layers[l], corners, parameters, l, seeds);
          check_layer_volume(layers[l], seeds, first, parameters.placement);
        }
      std::stable_sort(seeds.begin(),
                       seeds.end(),
                       [](const Seed<dim> &a, const Seed<dim> &b) {
                         return a.order < b.order;
                       });
      return seeds;
    }


    /// Sub-cells keep every volume to round-off. Rows follow the mid-point
    /// rule: what they miss is a corner between their lines.
    void
    check_volume(const double    points,
                 const double    profile,
                 const Placement placement)
    {
      const double difference = std::abs(points - profile);
      if (placement == Placement::rows && difference > 0.01 * profile)
        throw UserError("Material points/Placement",
                        "the rows have " + in_digits(points) +
                          " m^dim, the soil profile " + in_digits(profile) +
                          ": corners lie inside rows",
                        "layers with their corners on lines between the rows, "
                        "or sub-cells");
      AssertThrow(placement == Placement::rows || difference <= 1e-10 * profile,
                  ExcMessage("The material points have " + in_digits(points) +
                             " m^dim, their profile " + in_digits(profile)));
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
    check_volume(point_volume, volume, parameters.placement);
    AssertThrow(parameters.placement == Placement::rows ||
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
