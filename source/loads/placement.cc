// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/loads/placement.h>
#include <waker/surface/surface_finder.h>
#include <waker/surface/user_surface.h>

#include <utility>

namespace Waker
{
  namespace
  {
    /// On a surface that is found from the points.
    template <int dim>
    class FoundPlacement : public TractionPlacement<dim>
    {
    public:
      explicit FoundPlacement(const FoundSurface which)
        : which(which)
      {}

      const Facets<dim> &
      surface(const std::vector<Point<dim>> &,
              const SurfaceFinder<dim> &finder,
              const std::string        &path) override
      {
        return finder.facets(which, path + "/Method");
      }

    private:
      FoundSurface which;
    };


    /// On a surface of the user's, which moves with the material.
    template <int dim>
    class CarriedPlacement : public TractionPlacement<dim>
    {
    public:
      explicit CarriedPlacement(const UserSurface<dim> &user_surface)
        : user_surface(&user_surface)
      {}

      const Facets<dim> &
      surface(const std::vector<Point<dim>> &vertices,
              const SurfaceFinder<dim> &,
              const std::string &) override
      {
        user_surface->to_facets(vertices, facets);
        return facets;
      }

      bool
      is_carried() const override
      {
        return true;
      }

    private:
      const UserSurface<dim> *user_surface;
      Facets<dim>             facets;
    };


    /// On the points nearest to another placement's surface.
    template <int dim>
    class PointPlacement : public TractionPlacement<dim>
    {
    public:
      PointPlacement(std::unique_ptr<TractionPlacement<dim>> meant,
                     const bool                              fixed)
        : meant(std::move(meant))
        , fixed(fixed)
      {}

      const Facets<dim> &
      surface(const std::vector<Point<dim>> &vertices,
              const SurfaceFinder<dim>      &finder,
              const std::string             &path) override
      {
        return meant->surface(vertices, finder, path);
      }

      bool
      is_carried() const override
      {
        return meant->is_carried();
      }

      bool
      on_points() const override
      {
        return true;
      }

      bool
      is_fixed() const override
      {
        return fixed;
      }

    private:
      std::unique_ptr<TractionPlacement<dim>> meant;
      bool                                    fixed;
    };
  } // namespace


  template <int dim>
  std::unique_ptr<TractionPlacement<dim>>
  make_placement(const TractionParameters &parameters,
                 const UserSurface<dim>   &user_surface)
  {
    const auto found = [](const FoundSurface which) {
      return std::make_unique<FoundPlacement<dim>>(which);
    };
    // What loads on points stand for.
    const auto meant = [&]() -> std::unique_ptr<TractionPlacement<dim>> {
      if (parameters.has_user_surface())
        return std::make_unique<CarriedPlacement<dim>>(user_surface);
      return found(FoundSurface::contour);
    };
    switch (parameters.method)
      {
        case TractionMethod::fixed_points:
          return std::make_unique<PointPlacement<dim>>(meant(), true);
        case TractionMethod::updated_points:
          return std::make_unique<PointPlacement<dim>>(meant(), false);
        case TractionMethod::surface_nodes:
          return found(FoundSurface::surface_nodes);
        case TractionMethod::proximity_field:
          return found(FoundSurface::proximity_field);
        case TractionMethod::user_surface:
          return std::make_unique<CarriedPlacement<dim>>(user_surface);
        case TractionMethod::volume:
          return found(FoundSurface::volume);
        case TractionMethod::contour:
          return found(FoundSurface::contour);
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }


  template std::unique_ptr<TractionPlacement<2>>
  make_placement(const TractionParameters &, const UserSurface<2> &);
  template std::unique_ptr<TractionPlacement<3>>
  make_placement(const TractionParameters &, const UserSurface<3> &);
} // namespace Waker
