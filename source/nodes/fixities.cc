// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
#include <waker/base/expression.h>
#include <waker/base/places.h>
#include <waker/nodes/fixities.h>

#include "fixity_nodes.h"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// No expression: the dof is held at rest.
    constexpr int at_rest = -1;

    /// What one condition does: which components it holds, and how they move.
    template <int dim>
    struct Hold
    {
      std::array<bool, dim> component;
      std::array<int, dim>  expression; // number, or at_rest
    };


    /// Only increments are prescribed: a displacement at t = 0 would be lost.
    template <int dim>
    void
    check_start(const BackgroundGrid<dim>       &grid,
                const std::vector<unsigned int> &nodes,
                const Expression<dim>           &expression,
                const std::string               &path)
    {
      for (const unsigned int node : nodes)
        {
          const Point<dim> x = grid.node_position(node);
          const double     u = expression.value(x, 0.);
          if (!(std::abs(u) <= 1e-9 * grid.cell_size()))
            {
              std::ostringstream what;
              what << "\"" << expression.text() << "\" is " << u
                   << " m at t = 0 in the node " << place_text(x);
              throw UserError(path,
                              what.str(),
                              "displacements that start at 0");
            }
        }
    }
  } // namespace


  template <int dim>
  struct Fixities<dim>::Motion
  {
    /// A dof that moves: its place in the list of increments.
    struct Moved
    {
      std::size_t place;
      int         expression;
      Point<dim>  x;
    };

    /// A window shares those of the whole grid.
    explicit Motion(std::shared_ptr<std::vector<Expression<dim>>> expressions)
      : shared(std::move(expressions))
      , expressions(*shared)
    {}

    std::shared_ptr<std::vector<Expression<dim>>> shared;
    std::vector<Expression<dim>>                 &expressions;
    std::vector<std::string>                      paths; // of their conditions
    std::vector<Moved>                            removed;
    std::vector<Moved>                            penalised;

    void
    increments(const std::vector<Moved> &moved,
               const double              t,
               const double              dt,
               std::vector<double>      &result) const
    {
      // Where the displacement is the same everywhere, one value will do.
      std::vector<double> uniform(expressions.size());
      for (std::size_t e = 0; e < expressions.size(); ++e)
        if (expressions[e].moves() && expressions[e].is_uniform())
          uniform[e] = difference(e, Point<dim>(), t, dt);
      for (const Moved &m : moved)
        result[m.place] = expressions[m.expression].is_uniform()
                            ? uniform[m.expression]
                            : difference(m.expression, m.x, t, dt);
    }

  private:
    double
    difference(const std::size_t e,
               const Point<dim> &x,
               const double      t,
               const double      dt) const
    {
      const double increment =
        expressions[e].value(x, t + dt) - expressions[e].value(x, t);
      if (!std::isfinite(increment))
        throw NumericalFailure(
          "The prescribed displacement \"" + expressions[e].text() +
          "\" is no finite number between t = " + std::to_string(t) + " and " +
          std::to_string(t + dt) + " s.");
      return increment;
    }
  };


  template <int dim>
  Fixities<dim>::Fixities(const BackgroundGrid<dim>           &grid,
                          const std::vector<FixityParameters> &parameters,
                          const Openings<dim>                 &openings)
    : removed_dofs(grid.n_dofs(), 0)
    , motion(std::make_unique<Motion>(
        std::make_shared<std::vector<Expression<dim>>>()))
  {
    // Of each dof: the expression that moves it, and its spring (0: none).
    std::vector<int>    eliminated_by(grid.n_dofs(), at_rest);
    std::vector<int>    penalised_by(grid.n_dofs(), at_rest);
    std::vector<double> penalty_factors(grid.n_dofs(), 0.);

    for (const FixityParameters &fixity : parameters)
      {
        fixity.check(dim);
        const std::vector<unsigned int> nodes = nodes_of(grid, fixity);
        Hold<dim>                       hold;
        hold.expression.fill(at_rest);
        for (unsigned int c = 0; c < dim; ++c)
          hold.component[c] = fixity.holds(c);
        if (fixity.type == FixityType::prescribed)
          {
            const auto texts = fixity.expressions();
            for (unsigned int c = 0; c < dim; ++c)
              if (texts[c])
                {
                  const std::string path =
                    "Boundary conditions/" + fixity.name + "/Displacement";
                  Expression<dim> expression(*texts[c], path, ", or \"free\"");
                  check_start(grid, nodes, expression, path);
                  if (!expression.moves())
                    continue;
                  hold.expression[c] = motion->expressions.size();
                  motion->expressions.push_back(std::move(expression));
                  motion->paths.push_back("Boundary conditions/" + fixity.name);
                }
          }

        const bool eliminate = fixity.method == FixityMethod::elimination;
        for (const unsigned int node : nodes)
          for (unsigned int c = 0; c < dim; ++c)
            if (hold.component[c])
              {
                const unsigned int dof = dim * node + c;
                (eliminate ? eliminated_by : penalised_by)[dof] =
                  hold.expression[c];
                if (eliminate)
                  removed_dofs[dof] = 1;
                else
                  penalty_factors[dof] = fixity.penalty_factor;
              }
      }

    for (unsigned int dof = 0; dof < grid.n_dofs(); ++dof)
      if (removed_dofs[dof])
        {
          if (eliminated_by[dof] != at_rest)
            motion->removed.push_back({removed_dof_list.size(),
                                       eliminated_by[dof],
                                       grid.node_position(dof / dim)});
          removed_dof_list.push_back(dof);
        }
      else if (penalty_factors[dof] > 0.)
        {
          if (penalised_by[dof] != at_rest)
            motion->penalised.push_back({penalty_dofs.size(),
                                         penalised_by[dof],
                                         grid.node_position(dof / dim)});
          penalty_dofs.push_back({dof, penalty_factors[dof]});
        }
    penalties_exist = !penalty_dofs.empty();
    moves           = !motion->removed.empty() || !motion->penalised.empty();

    closed_face_bits   = (1u << (2 * dim)) - 1;
    unsigned int holds = 0; // faces with a node at rest
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      {
        const auto       index  = grid.node_index(node);
        const Point<dim> x      = grid.node_position(node);
        const int        margin = grid.margin;
        bool             on_box = true;
        unsigned int     opened = 0, closed = 0; // faces that the node is on
        for (unsigned int d = 0; d < dim; ++d)
          {
            const int upper = grid.n_nodes_per_direction()[d] - 1 - margin;
            on_box          = on_box && index[d] >= margin && index[d] <= upper;
            const unsigned int dof = dim * node + d;
            const bool         is_at_rest =
              removed_dofs[dof]
                        ? eliminated_by[dof] == at_rest
                        : penalty_factors[dof] > 0. && penalised_by[dof] == at_rest;
            for (const bool is_upper : {false, true})
              {
                const unsigned int face = 2 * d + is_upper;
                if (index[d] != (is_upper ? upper : margin))
                  continue;
                if (is_at_rest)
                  closed |= 1u << face;
                else if (!openings.is_open(face, x))
                  opened |= 1u << face;
              }
          }
        if (!on_box)
          continue;
        closed_face_bits &= ~opened;
        holds |= closed;
      }
    closed_face_bits &= holds;
  }


  template <int dim>
  Fixities<dim>::Fixities(const Fixities            &whole,
                          const BackgroundGrid<dim> &whole_grid,
                          const BackgroundGrid<dim> &window)
    : removed_dofs(window.n_dofs(), 0)
    , penalties_exist(whole.penalties_exist)
    , moves(whole.moves)
    , closed_face_bits(whole.closed_face_bits)
    , motion(std::make_unique<Motion>(whole.motion->shared))
  {
    motion->paths = whole.motion->paths;
    // Lattice lines of the window and of the grid have the same order: lists
    // stay ascending.
    const auto dof_of = [&](const unsigned int whole_dof) {
      auto index = whole_grid.node_index(whole_dof / dim);
      for (unsigned int d = 0; d < dim; ++d)
        {
          index[d] -= window.offset()[d];
          if (index[d] < 0 ||
              index[d] >= static_cast<int>(window.n_nodes_per_direction()[d]))
            return numbers::invalid_unsigned_int;
        }
      return dim * window.node(index) + whole_dof % dim;
    };
    const auto take_motion = [](const auto       &moved,
                                auto             &next,
                                const std::size_t whole_place,
                                const std::size_t place,
                                auto             &mine) {
      while (next != moved.end() && next->place < whole_place)
        ++next;
      if (next != moved.end() && next->place == whole_place)
        mine.push_back({place, next->expression, next->x});
    };
    auto next = whole.motion->removed.cbegin();
    for (std::size_t k = 0; k < whole.removed_dof_list.size(); ++k)
      if (const unsigned int dof = dof_of(whole.removed_dof_list[k]);
          dof != numbers::invalid_unsigned_int)
        {
          take_motion(whole.motion->removed,
                      next,
                      k,
                      removed_dof_list.size(),
                      motion->removed);
          removed_dofs[dof] = 1;
          removed_dof_list.push_back(dof);
        }
    next = whole.motion->penalised.cbegin();
    for (std::size_t k = 0; k < whole.penalty_dofs.size(); ++k)
      if (const unsigned int dof = dof_of(whole.penalty_dofs[k].dof);
          dof != numbers::invalid_unsigned_int &&
          window.exchange().owns(dof / dim))
        {
          take_motion(whole.motion->penalised,
                      next,
                      k,
                      penalty_dofs.size(),
                      motion->penalised);
          penalty_dofs.push_back({dof, whole.penalty_dofs[k].factor});
        }
  }


  template <int dim>
  Fixities<dim>::~Fixities() = default;


  template <int dim>
  Fixities<dim>::Fixities(Fixities &&) = default;


  template <int dim>
  double
  Fixities<dim>::last_change() const
  {
    return moves ? LastChange::unknown : LastChange::never;
  }


  template <int dim>
  std::string
  Fixities<dim>::varying(const double from, const double to) const
  {
    for (const auto *const list : {&motion->removed, &motion->penalised})
      {
        // A hundred of the dofs will do; where the displacement is the same
        // everywhere, the first of each expression.
        const std::size_t stride = list->size() / 100 + 1;
        std::vector<char> seen(motion->expressions.size(), 0);
        for (std::size_t i = 0; i < list->size(); ++i)
          {
            const auto            &moved = (*list)[i];
            const Expression<dim> &u = motion->expressions[moved.expression];
            char                  &is_seen = seen[moved.expression];
            if (is_seen && (u.is_uniform() || i % stride != 0))
              continue;
            is_seen = 1;
            if (u.varies(moved.x, from, to))
              return motion->paths[moved.expression];
          }
      }
    return "";
  }


  template <int dim>
  void
  Fixities<dim>::removed_increments(const double         t,
                                    const double         dt,
                                    std::vector<double> &increments) const
  {
    increments.assign(removed_dof_list.size(), 0.);
    if (!motion->removed.empty())
      motion->increments(motion->removed, t, dt, increments);
  }


  template <int dim>
  void
  Fixities<dim>::penalty_increments(const double         t,
                                    const double         dt,
                                    std::vector<double> &increments) const
  {
    increments.assign(penalty_dofs.size(), 0.);
    if (!motion->penalised.empty())
      motion->increments(motion->penalised, t, dt, increments);
  }


  template class Fixities<2>;
  template class Fixities<3>;
} // namespace Waker
