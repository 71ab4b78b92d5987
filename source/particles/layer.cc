// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/places.h>
#include <waker/base/text.h>
#include <waker/particles/layer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    std::string
    interval(const double begin, const double end)
    {
      return in_digits(begin) + " to " + in_digits(end) + " m";
    }


    template <int dim>
    std::vector<Expression<dim>>
    expressions_of_place(const std::vector<std::string> &texts,
                         const std::string              &path)
    {
      std::vector<Expression<dim>> expressions;
      for (const std::string &text : texts)
        {
          try
            {
              expressions.emplace_back(text, path);
            }
          catch (const UserError &)
            {
              // The same, but t is not offered.
              NamedExpression(text,
                              path,
                              dim == 2
                                ? std::vector<std::string>{"x", "y"}
                                : std::vector<std::string>{"x", "y", "z"});
              throw;
            }
          if (expressions.back().moves())
            throw UserError(path,
                            "\"" + text + "\" depends on the time t",
                            "expressions of the place only");
        }
      return expressions;
    }


    /// @throws UserError if the value at x is no finite number
    template <int dim>
    double
    finite_value(const Expression<dim> &expression,
                 const Point<dim>      &x,
                 const std::string     &path,
                 const std::string     &unit)
    {
      const double value = expression.value(x, 0.);
      if (!std::isfinite(value))
        {
          std::ostringstream where;
          where << "\"" << expression.text() << "\" is ";
          if (std::isnan(value))
            where << "not a number";
          else
            where << value;
          where << " at the point " << place_text(x) << " m";
          throw UserError(path,
                          where.str(),
                          "a finite number (" + unit + ") at every point");
        }
      return value;
    }


    /// The height maps of a layer, of which the rest of the body is known.
    /// @param round_off (m) see HeightMap
    void
    read_maps(const LayerParameters &parameters,
              const double           round_off,
              LayerBody             &body)
    {
      const auto [low, high] =
        std::minmax_element(body.corners.begin(),
                            body.corners.end(),
                            [](const auto &a, const auto &b) {
                              return a[0] < b[0];
                            });
      const auto read = [&, x0 = (*low)[0], x1 = (*high)[0]](
                          const std::string &file, const std::string &entry) {
        return file.empty() ? nullptr
                            : read_height_map(file,
                                              {{x0, body.begin}},
                                              {{x1, body.end}},
                                              round_off,
                                              "Soil profile/" +
                                                parameters.name + "/" + entry);
      };
      body.top    = read(parameters.top, "Top");
      body.bottom = read(parameters.bottom, "Bottom");
    }
  } // namespace


  template <int dim>
  Layer<dim>
  place_layer(const BackgroundGrid<dim> &grid,
              const LayerParameters     &parameters)
  {
    const Point<dim> &lower     = grid.lower_corner();
    const Point<dim> &upper     = grid.upper_corner();
    const double      tolerance = 1e-10 * grid.cell_size();

    Layer<dim> layer;
    layer.path    = "Soil profile/" + parameters.name;
    layer.corners = parameters.corners();
    for (const auto &corner : layer.corners)
      for (unsigned int d = 0; d < 2; ++d)
        if (!(corner[d] >= lower[d] - tolerance &&
              corner[d] <= upper[d] + tolerance))
          throw UserError(layer.path + "/Polygon",
                          "the corner (" + in_digits(corner[0]) + ", " +
                            in_digits(corner[1]) + ") lies outside the grid",
                          "x from " + interval(lower[0], upper[0]) +
                            " and y from " + interval(lower[1], upper[1]));

    const std::vector<double> &extent = parameters.extent;
    if (dim == 2 && !extent.empty())
      throw UserError(layer.path + "/Extent",
                      "is given, but the case is 2D",
                      "no extent in 2D");
    if (dim == 3)
      {
        const std::string allowed =
          "two numbers \"z0, z1\", z0 below z1, from " +
          interval(lower[dim - 1], upper[dim - 1]) + ", or nothing";
        if (!extent.empty() && extent.size() != 2)
          throw UserError(layer.path + "/Extent",
                          "has " + counted(extent.size(), "number"),
                          allowed);
        layer.begin = extent.empty() ? lower[dim - 1] : extent[0];
        layer.end   = extent.empty() ? upper[dim - 1] : extent[1];
        if (!(layer.begin >= lower[dim - 1] - tolerance &&
              layer.end <= upper[dim - 1] + tolerance &&
              layer.end - layer.begin > tolerance))
          throw UserError(layer.path + "/Extent",
                          "reaches from " + interval(layer.begin, layer.end),
                          allowed);
      }
    if (dim == 2)
      for (const bool is_top : {true, false})
        if (!(is_top ? parameters.top : parameters.bottom).empty())
          throw UserError(layer.path + (is_top ? "/Top" : "/Bottom"),
                          "is given, but the case is 2D",
                          "nothing in 2D: the polygon says it all");
    read_maps(parameters, 1e-6 * grid.cell_size(), layer);
    if (!layer.is_prism() && !(layer.volume() > 0.))
      throw UserError(layer.path + (layer.top != nullptr ? "/Top" : "/Bottom"),
                      "leaves nothing of the layer's prism",
                      "heights within the polygon");
    return layer;
  }


  namespace
  {
    LayerBody
    body_of(const LayerParameters &parameters,
            const double           z_begin,
            const double           z_end)
    {
      LayerBody body;
      body.corners          = parameters.corners();
      const bool has_extent = parameters.extent.size() == 2;
      body.begin            = has_extent ? parameters.extent[0] : z_begin;
      body.end              = has_extent ? parameters.extent[1] : z_end;
      read_maps(parameters, 1e-6 * (body.end - body.begin), body);
      return body;
    }
  } // namespace


  std::array<double, 2>
  level_range(const LayerParameters &parameters,
              const double           z_begin,
              const double           z_end)
  {
    const LayerBody body = body_of(parameters, z_begin, z_end);
    const auto [low, high] =
      std::minmax_element(body.corners.begin(),
                          body.corners.end(),
                          [](const auto &a, const auto &b) {
                            return a[1] < b[1];
                          });
    std::array<double, 2> levels = {{(*low)[1], (*high)[1]}};
    if (body.bottom != nullptr)
      levels[0] = std::max(levels[0], body.bottom->range()[0]);
    if (body.top != nullptr)
      levels[1] = std::min(levels[1], body.top->range()[1]);
    return levels;
  }


  double
  drawn_crest(const std::vector<LayerParameters> &layers,
              const unsigned int                  dim,
              const double                        z_begin,
              const double                        z_end,
              const double                        cell_size)
  {
    std::vector<LayerBody> bodies;
    double                 begin = infinity, end = -infinity;
    for (const LayerParameters &layer : layers)
      {
        bodies.push_back(body_of(layer, z_begin, z_end));
        begin = std::min(begin, bodies.back().begin);
        end   = std::max(end, bodies.back().end);
      }
    const double tolerance = 1e-6 * cell_size;
    double       lowest    = infinity;
    const long   n =
      dim == 2 ? 1 : std::lround(2. * (z_end - z_begin) / cell_size);
    for (long k = 0; k <= n; ++k)
      {
        const double z = z_begin + (dim == 2 ? 0. : 0.5 * k * cell_size);
        if (dim == 3 && !(z > begin + tolerance && z < end - tolerance))
          continue;
        double highest = -infinity;
        for (const LayerBody &body : bodies)
          if (z >= body.begin - tolerance && z <= body.end + tolerance)
            highest =
              std::max(highest,
                       body.highest_at(std::clamp(z, body.begin, body.end)));
        lowest = std::min(lowest, highest);
      }
    return lowest;
  }


  template <int dim>
  void
  fill_layer(const LayerParameters          &parameters,
             const std::vector<std::string> &material_names,
             Layer<dim>                     &layer)
  {
    const auto material = std::find(material_names.begin(),
                                    material_names.end(),
                                    parameters.material);
    if (material == material_names.end())
      {
        std::string known;
        for (const std::string &name : material_names)
          known += (known.empty() ? "" : ", ") + name;
        throw UserError(layer.path + "/Material",
                        "the material \"" + parameters.material +
                          "\" is unknown",
                        known.empty() ? "(there are no materials)" : known);
      }
    layer.material = material - material_names.begin();

    layer.velocity =
      expressions_of_place<dim>(parameters.velocity_components(dim),
                                layer.path + "/Velocity");
    layer.stress = expressions_of_place<dim>(parameters.stress_components(dim),
                                             layer.path + "/Initial stress");
  }


  template <int dim>
  Tensor<1, dim>
  Layer<dim>::velocity_at(const Point<dim> &x) const
  {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < velocity.size(); ++d)
      v[d] = finite_value(velocity[d], x, path + "/Velocity", "m/s");
    return v;
  }


  template <int dim>
  SymmetricTensor<2, 3>
  Layer<dim>::stress_at(const Point<dim> &x) const
  {
    // The order in which the user writes the components.
    constexpr unsigned int places[6][2] = {
      {0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    SymmetricTensor<2, 3> sigma;
    for (unsigned int k = 0; k < stress.size(); ++k)
      sigma[places[k][0]][places[k][1]] =
        finite_value(stress[k], x, path + "/Initial stress", "kPa");
    return sigma;
  }


  template <int dim>
  void
  check_overlap(const std::vector<Layer<dim>> &layers)
  {
    for (unsigned int i = 0; i < layers.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          const Layer<dim> &a = layers[i], &b = layers[j];
          if (!a.is_prism() || !b.is_prism())
            {
              const double common = common_volume(a, b);
              if (common <= 1e-9 * std::min(a.volume(), b.volume()))
                continue;
              std::ostringstream what; // an integral: not to the last digit
              what << "overlaps \"" << b.path << "\" over " << common << " m^3";
              throw UserError(a.path + (a.bottom != nullptr ? "/Bottom"
                                        : a.top != nullptr  ? "/Top"
                                                            : "/Polygon"),
                              what.str(),
                              "layers that touch at most");
            }
          const double depth =
            std::min(a.end, b.end) - std::max(a.begin, b.begin);
          if (depth <= 1e-9 * std::min(a.end - a.begin, b.end - b.begin))
            continue;
          const double area = common_area(a.corners, b.corners);
          if (area >
              1e-9 * std::min(signed_area(a.corners), signed_area(b.corners)))
            throw UserError(a.path + "/Polygon",
                            "overlaps \"" + b.path + "\" over " +
                              in_digits(area) + " m^2",
                            "layers that touch at most");
        }
  }


  template struct Layer<2>;
  template struct Layer<3>;
  template Layer<2>
  place_layer(const BackgroundGrid<2> &, const LayerParameters &);
  template Layer<3>
  place_layer(const BackgroundGrid<3> &, const LayerParameters &);
  template void
  fill_layer(const LayerParameters &,
             const std::vector<std::string> &,
             Layer<2> &);
  template void
  fill_layer(const LayerParameters &,
             const std::vector<std::string> &,
             Layer<3> &);
  template void
  check_overlap(const std::vector<Layer<2>> &);
  template void
  check_overlap(const std::vector<Layer<3>> &);
} // namespace Waker
