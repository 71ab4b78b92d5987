// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/particles/layer_parts.h>
#include <waker/particles/rows.h>
#include <waker/particles/seeds.h>
#include <waker/particles/sub_cells.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
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


    /// The point of a part; its support domain is a whole sub-cell.
    template <int dim>
    Seed<dim>
    seed_of(const BackgroundGrid<dim> &grid,
            const LatticePart<dim>    &part,
            const unsigned int         n,
            const unsigned int         layer)
    {
      const double       size     = grid.cell_size() / n;
      std::array<int, 3> sub_cell = {{0, 0, 0}};
      std::copy(part.index.begin(), part.index.end(), sub_cell.begin());
      Seed<dim> seed;
      seed.layer  = layer;
      seed.order  = place_in_order(grid, n, sub_cell);
      seed.volume = part.share * std::pow(size, dim);
      for (unsigned int d = 0; d < dim; ++d)
        {
          seed.position[d]  = grid.lower_corner()[d] + size * part.centroid[d];
          seed.half_size[d] = size / 2.;
        }
      return seed;
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
      if (!layer.is_prism())
        {
          for (const LatticePart<dim> &part :
               merge_small_parts(all_parts(grid, layer, n), minimum_share))
            seeds.push_back(seed_of(grid, part, n, number));
          return;
        }
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


    /// One point for each sub-cell that soil fills at least by half, with all
    /// of its volume: of the layer that has most of it, of equal ones the
    /// first.
    template <int dim>
    std::vector<Seed<dim>>
    whole_sub_cells(const BackgroundGrid<dim>     &grid,
                    const std::vector<Layer<dim>> &layers,
                    const unsigned int             n)
    {
      struct Claim
      {
        double             share = 0.; // of all layers
        double             most  = 0.; // of one of them
        unsigned int       layer = 0;
        std::array<int, 3> sub_cell;
      };
      constexpr double               round_off = 1e-9;
      std::map<std::uint64_t, Claim> claims;
      for (unsigned int l = 0; l < layers.size(); ++l)
        for (const LatticePart<dim> &part : all_parts(grid, layers[l], n))
          {
            std::array<int, 3> sub_cell = {{0, 0, 0}};
            std::copy(part.index.begin(), part.index.end(), sub_cell.begin());
            Claim &claim = claims[place_in_order(grid, n, sub_cell)];
            claim.share += part.share;
            if (part.share > claim.most + round_off)
              {
                claim.most  = part.share;
                claim.layer = l;
              }
            claim.sub_cell = sub_cell;
          }

      std::vector<Seed<dim>> seeds;
      for (const auto &[order, claim] : claims)
        if (claim.share >= 0.5 - round_off)
          {
            LatticePart<dim> whole;
            whole.share = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              {
                whole.index[d]    = claim.sub_cell[d];
                whole.centroid[d] = claim.sub_cell[d] + 0.5;
              }
            seeds.push_back(seed_of(grid, whole, n, claim.layer));
          }
      return seeds;
    }


    /// A layer that is thinner than round-off leaves no points, or others than
    /// it should: it would vanish in silence beside a large one.
    template <int dim>
    void
    check_layer_volume(const Layer<dim> &layer,
                       const double      volume,
                       const double      sub_cell,
                       const Placement   placement)
    {
      const double difference = std::abs(volume - layer.volume());
      // Whether whole domains fit is seen from all of them, see
      // make_material_points().
      const double most = placement == Placement::sub_cells ? 1e-6 : 1.;
      if (volume != 0. && difference <= most * layer.volume())
        return;
      // Which of its limits makes it thin?
      std::string        entry = "Polygon";
      std::ostringstream what;
      what.precision(4);
      what << "is too thin: the layer has " << layer.volume() << " m^" << dim
           << ", the points made of it " << volume;
      if (dim == 3 && layer.end - layer.begin < sub_cell)
        {
          entry = "Extent";
          what << "; it reaches from z = " << layer.begin << " to " << layer.end
               << " m";
        }
      else if (!layer.is_prism())
        {
          LayerBody prism = layer;
          prism.top = prism.bottom = nullptr;
          // Without the maps it would not be thin.
          if (prism.volume() > 2. * layer.volume())
            entry = layer.top != nullptr ? "Top" : "Bottom";
        }
      what << "; sub-cells have edges of " << sub_cell << " m";
      throw UserError(layer.path + "/" + entry,
                      what.str(),
                      "a layer that can be seen in the grid");
    }
  } // namespace


  template <int dim>
  std::vector<Seed<dim>>
  make_seeds(const BackgroundGrid<dim>     &grid,
             const std::vector<Layer<dim>> &layers,
             const MaterialPointParameters &parameters)
  {
    const unsigned int   n = parameters.points_per_direction;
    std::vector<Polygon> corners;
    for (const Layer<dim> &layer : layers)
      corners.push_back(corners_in_lattice(grid, layer, n));

    std::vector<Seed<dim>> seeds;
    switch (parameters.placement)
      {
        case Placement::sub_cells:
          for (unsigned int l = 0; l < layers.size(); ++l)
            add_sub_cells(grid, layers[l], corners[l], parameters, l, seeds);
          break;
        case Placement::whole_sub_cells:
          seeds = whole_sub_cells(grid, layers, n);
          break;
        case Placement::rows:
          for (unsigned int l = 0; l < layers.size(); ++l)
            if (!layers[l].is_prism())
              throw UserError("Material points/Placement",
                              "is rows, but " + layers[l].path +
                                " has a height map",
                              "sub-cells, or whole sub-cells");
          for (unsigned int l = 0; l < layers.size(); ++l)
            add_rows(grid, layers[l], corners[l], n, l, seeds);
          break;
      }
    std::vector<double> volumes(layers.size(), 0.);
    for (const Seed<dim> &seed : seeds)
      volumes[seed.layer] += seed.volume;
    for (unsigned int l = 0; l < layers.size(); ++l)
      check_layer_volume(layers[l],
                         volumes[l],
                         grid.cell_size() / n,
                         parameters.placement);

    std::stable_sort(seeds.begin(),
                     seeds.end(),
                     [](const Seed<dim> &a, const Seed<dim> &b) {
                       return a.order < b.order;
                     });
    return seeds;
  }


  template std::vector<Seed<2>>
  make_seeds(const BackgroundGrid<2> &,
             const std::vector<Layer<2>> &,
             const MaterialPointParameters &);
  template std::vector<Seed<3>>
  make_seeds(const BackgroundGrid<3> &,
             const std::vector<Layer<3>> &,
             const MaterialPointParameters &);
} // namespace Waker
