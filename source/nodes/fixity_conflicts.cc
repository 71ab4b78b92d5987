// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression.h>
#include <waker/nodes/fixity_conflicts.h>

#include "fixity_nodes.h"
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Nodes that two conditions have in common.
    template <int dim>
    struct Common
    {
      std::set<unsigned int> nodes;

      /// More than an edge: they reach further than the margin in all
      /// directions but one, or they are much of one of the two conditions.
      bool
      is_more_than_an_edge(const BackgroundGrid<dim> &grid,
                           const std::size_t          n_nodes) const
      {
        if (2 * nodes.size() > n_nodes)
          return true;
        unsigned int n_long = 0;
        for (unsigned int d = 0; d < dim; ++d)
          {
            int low = grid.n_nodes_per_direction()[d], high = 0;
            for (const unsigned int node : nodes)
              {
                const int i = grid.node_index(node)[d];
                low         = std::min(low, i);
                high        = std::max(high, i);
              }
            n_long += high - low > static_cast<int>(grid.margin);
          }
        return n_long + 1 >= dim;
      }
    };
  } // namespace


  template <int dim>
  std::vector<std::string>
  fixity_conflicts(const BackgroundGrid<dim>           &grid,
                   const std::vector<FixityParameters> &parameters)
  {
    // Of a dof: the condition that counts so far, or none.
    constexpr unsigned int    none = static_cast<unsigned int>(-1);
    std::vector<unsigned int> holder(grid.n_dofs(), none);
    const auto movement = [&](const unsigned int i, const unsigned int c) {
      const FixityParameters &p = parameters[i];
      if (p.type != FixityType::prescribed)
        return std::string();
      const std::string     text = *p.expressions()[c];
      const Expression<dim> expression(text,
                                       "Boundary conditions/" + p.name +
                                         "/Displacement");
      return expression.moves() ? text : std::string();
    };
    const auto eliminates = [&](const unsigned int i) {
      return parameters[i].method == FixityMethod::elimination;
    };

    std::map<std::pair<unsigned int, unsigned int>, Common<dim>> conflicts;
    std::vector<std::size_t> n_nodes(parameters.size());
    for (unsigned int i = 0; i < parameters.size(); ++i)
      {
        const std::vector<unsigned int> nodes = nodes_of(grid, parameters[i]);
        n_nodes[i]                            = nodes.size();
        for (unsigned int c = 0; c < dim; ++c)
          {
            if (!parameters[i].holds(c))
              continue;
            std::vector<int> differs(parameters.size(), -1); // unknown
            for (const unsigned int node : nodes)
              {
                unsigned int      &other = holder[dim * node + c];
                const unsigned int was   = other;
                const bool         wins =
                  was == none || eliminates(i) || !eliminates(was);
                if (wins)
                  other = i;
                if (was == none)
                  continue;
                if (differs[was] < 0)
                  differs[was] = movement(i, c) != movement(was, c);
                if (differs[was] == 1)
                  conflicts[wins ? std::make_pair(was, i)
                                 : std::make_pair(i, was)]
                    .nodes.insert(node);
              }
          }
      }

    std::vector<std::string> texts;
    for (const auto &[pair, common] : conflicts)
      {
        const auto &[loser, winner] = pair;
        if (!common.is_more_than_an_edge(
              grid, std::min(n_nodes[loser], n_nodes[winner])))
          continue;
        std::ostringstream text;
        text << "Boundary conditions: " << parameters[winner].name
             << " overrules " << parameters[loser].name << " on "
             << common.nodes.size() << " nodes of both, where they want "
             << "different movements ("
             << (eliminates(winner) && !eliminates(loser)
                   ? "elimination counts before penalty"
                   : "the later one in Names counts")
             << ")";
        texts.push_back(text.str());
      }
    return texts;
  }


  template std::vector<std::string>
  fixity_conflicts(const BackgroundGrid<2> &,
                   const std::vector<FixityParameters> &);
  template std::vector<std::string>
  fixity_conflicts(const BackgroundGrid<3> &,
                   const std::vector<FixityParameters> &);
} // namespace Waker
