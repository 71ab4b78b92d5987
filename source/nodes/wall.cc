// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/nodes/wall.h>
#include <waker/nodes/wall_spots.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    template <int dim>
    std::vector<Expression<dim>>
    read_motion(const WallParameters &wall, const double h)
    {
      const std::string path = "Walls/" + wall.name + "/Displacement";
      std::vector<Expression<dim>> motion;
      for (const std::string &text : split(wall.displacement, ';'))
        {
          motion.emplace_back(text, path);
          const Expression<dim> &u = motion.back();
          if (!u.is_uniform())
            throw UserError(path,
                            "\"" + text + "\" depends on the place",
                            "expressions of t: a wall is rigid");
          if (!(std::abs(u.value(Point<dim>(), 0.)) <= 1e-9 * h))
            throw UserError(path,
                            "\"" + text + "\" is not 0 at t = 0",
                            "displacements that start at 0");
        }
      return motion;
    }
  } // namespace


  template <int dim>
  Walls<dim>::Walls(const BackgroundGrid<dim>         &grid,
                    const std::vector<WallParameters> &parameters,
                    const double                       modulus,
                    const double                       full_node_mass)
    : grid(&grid)
    , ranks(&grid.exchange())
    , full_node_mass(full_node_mass)
    , wall_gaps(grid)
  {
    const double h = grid.cell_size();
    for (const WallParameters &p : parameters)
      {
        const std::string path = "Walls/" + p.name + "/Line";
        for (const WallSpot<dim> &spot :
             make_wall_spots<dim>(p.line, size_of_wall_spots(grid), path))
          {
            if (!grid.contains(spot.x))
              throw UserError(path,
                              "the wall leaves the grid",
                              "corners inside the grid and its margin");
            if (p.type == WallType::frictional)
              one_sided.push_back(spots.size());
            spots.push_back({static_cast<unsigned int>(walls.size()),
                             spot.x,
                             spot.x,
                             spot.normal,
                             spot.area,
                             false,
                             0.});
          }
        wall_names.push_back(p.name);
        walls.push_back(
          {{p.type, p.penalty_factor * modulus / h, p.friction(), p.adhesion},
           read_motion<dim>(p, h),
           Tensor<1, dim>()});
      }
  }


  template <int dim>
  Tensor<1, dim>
  Walls<dim>::displacement(const Wall &wall, const double t) const
  {
    Tensor<1, dim> u;
    for (unsigned int d = 0; d < wall.motion.size(); ++d)
      {
        u[d] = wall.motion[d].value(Point<dim>(), t);
        if (!std::isfinite(u[d]))
          throw NumericalFailure(
            "The displacement of a wall, \"" + wall.motion[d].text() +
            "\", is no finite number at t = " + std::to_string(t) + " s.");
      }
    return u;
  }


  template <int dim>
  void
  Walls<dim>::set_step(const double t, const double dt)
  {
    for (Wall &wall : walls)
      wall.target = displacement(wall, t + dt) - displacement(wall, t);
  }


  template <int dim>
  double
  Walls<dim>::last_change() const
  {
    double last = LastChange::never;
    for (const Wall &wall : walls)
      for (const Expression<dim> &u : wall.motion)
        last = std::max(last, u.last_change());
    return last;
  }


  template <int dim>
  std::string
  Walls<dim>::varying(const double from, const double to) const
  {
    for (std::size_t w = 0; w < walls.size(); ++w)
      for (const Expression<dim> &u : walls[w].motion)
        if (u.varies(Point<dim>(), from, to))
          return "Walls/" + wall_names[w];
    return "";
  }


  template <int dim>
  Tensor<1, dim>
  Walls<dim>::value(const Contact &contact, const NodalVector &u) const
  {
    Tensor<1, dim> sum;
    for (std::size_t k = contact.begin; k < contact.end; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        sum[c] += weights[k] * u.begin()[dim * nodes[k] + c];
    return sum;
  }


  template <int dim>
  Tensor<1, dim>
  Walls<dim>::motion(const Contact &contact, const NodalVector &increment) const
  {
    return value(contact, increment) - walls[spots[contact.spot].wall].target;
  }


  template <int dim>
  Tensor<1, dim>
  Walls<dim>::traction(const Contact     &contact,
                       const NodalVector &increment) const
  {
    return law(contact).traction(contact.start, motion(contact, increment));
  }


  template <int dim>
  void
  Walls<dim>::scatter(const Contact        &contact,
                      const Tensor<1, dim> &traction,
                      NodalVector          &internal) const
  {
    const double area = spots[contact.spot].area;
    for (std::size_t k = contact.begin; k < contact.end; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        internal.begin()[dim * nodes[k] + c] -= weights[k] * area * traction[c];
  }


  template <int dim>
  void
  Walls<dim>::add_force(const NodalVector &increment, NodalVector &internal)
  {
    for (Contact &contact : contacts)
      {
        contact.motion = motion(contact, increment);
        scatter(contact,
                law(contact).traction(contact.start, contact.motion),
                internal);
      }
  }


  template <int dim>
  void
  Walls<dim>::add_start_force(NodalVector &internal)
  {
    for (const Contact &contact : contacts)
      scatter(contact, contact.start.traction, internal);
  }


  template <int dim>
  void
  Walls<dim>::linearise()
  {
    if (!has_corners())
      return;
    slides = false;
    for (Contact &contact : contacts)
      {
        contact.derivative =
          law(contact).derivative(contact.start, contact.motion);
        slides = slides || law(contact).slides(contact.start, contact.motion);
      }
  }


  template <int dim>
  bool
  Walls<dim>::has_corners() const
  {
    return !one_sided.empty();
  }


  template <int dim>
  bool
  Walls<dim>::is_symmetric() const
  {
    return !slides;
  }


  template <int dim>
  void
  Walls<dim>::vmult_add(NodalVector &dst, const NodalVector &src) const
  {
    for (const Contact &contact : contacts)
      {
        const Tensor<1, dim> f =
          spots[contact.spot].area * (contact.derivative * value(contact, src));
        for (std::size_t k = contact.begin; k < contact.end; ++k)
          for (unsigned int c = 0; c < dim; ++c)
            dst.begin()[dim * nodes[k] + c] += weights[k] * f[c];
      }
  }


  template <int dim>
  void
  Walls<dim>::add_diagonal(NodalVector &diagonal) const
  {
    // A node may be there twice, with two weights.
    for (const Contact &contact : contacts)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double k = spots[contact.spot].area * contact.derivative[c][c];
          for (std::size_t i = contact.begin; i < contact.end; ++i)
            for (std::size_t j = contact.begin; j < contact.end; ++j)
              if (nodes[i] == nodes[j])
                diagonal.begin()[dim * nodes[i] + c] +=
                  weights[i] * weights[j] * k;
        }
  }


  template <int dim>
  void
  Walls<dim>::add_entries(MatrixEntries &entries) const
  {
    std::vector<double> matrix;
    for (const Contact &contact : contacts)
      {
        const std::size_t     n      = contact.end - contact.begin;
        const Tensor<1, dim> &normal = contact.start.normal;
        const Tensor<2, dim> &D      = contact.derivative;
        // The blocks of the normal and of the tangential motion, each of which
        // is symmetric.
        const Tensor<2, dim> across = outer_product(normal, normal);
        const Tensor<2, dim> along =
          Tensor<2, dim>(unit_symmetric_tensor<dim>()) - across;
        const Tensor<2, dim> k =
          spots[contact.spot].area * (across * D * across + along * D * along);
        matrix.clear();
        for (std::size_t i = contact.begin; i < contact.end; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            for (std::size_t j = contact.begin; j < contact.end; ++j)
              for (unsigned int e = 0; e < dim; ++e)
                matrix.push_back(weights[i] * weights[j] * k[c][e]);
        entries.add({nodes.data() + contact.begin, n},
                    {matrix.data(), matrix.size()});
      }
  }


  template <int dim>
  ResistanceWork
  Walls<dim>::work(const NodalVector &increment) const
  {
    ResistanceWork sum;
    for (const Contact &contact : contacts)
      {
        const double         area = spots[contact.spot].area;
        const Tensor<1, dim> du   = area * value(contact, increment);
        sum.start += contact.start.traction * du;
        sum.end += traction(contact, increment) * du;
        sum.lost += area * law(contact).dissipation(contact.start,
                                                    motion(contact, increment));
      }
    return sum;
  }


  template <int dim>
  Tensor<1, dim>
  Walls<dim>::accept(const NodalVector &increment, MaterialPoints<dim> &)
  {
    Tensor<1, dim> force;
    if (!ranks->is_one_rank())
      carried->assign(spots.size(), Tensor<1, dim>());
    for (const Contact &contact : contacts)
      {
        (*carried)[contact.spot] = traction(contact, increment);
        force += spots[contact.spot].area * (*carried)[contact.spot];
      }
    if (!ranks->is_one_rank() && !carried->empty())
      ranks->sum(&(*carried)[0][0], dim * carried->size());
    return force;
  }


  template <int dim>
  Tensor<1, dim>
  Walls<dim>::force(const unsigned int wall, const Tractions &tractions) const
  {
    Tensor<1, dim> sum;
    for (std::size_t q = 0; q < spots.size(); ++q)
      if (spots[q].wall == wall)
        sum += spots[q].area * tractions[q];
    return sum;
  }


  template class Walls<2>;
  template class Walls<3>;
} // namespace Waker
