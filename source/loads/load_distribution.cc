// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/load_distribution.h>

#include <algorithm>

namespace Waker
{
  template <int dim>
  LoadDistribution<dim>::LoadDistribution(const LoadNodes<dim> &nodes)
    : nodes(nodes)
    , n_nodes(nodes.n_nodes())
  {}


  template <int dim>
  void
  LoadDistribution<dim>::add(const std::vector<unsigned int> &loaded,
                             const std::vector<double>       &load,
                             const std::vector<Plane>        &planes,
                             const std::vector<double>       &node_mass,
                             const double                     minimum_mass,
                             NodalVector                     &force)
  {
    AssertDimension(node_mass.size(), n_nodes * nodes.n_planes);
    AssertDimension(force.locally_owned_size(),
                    nodes.n_components * node_mass.size());
    const bool is_alone = nodes.ranks->is_one_rank();
    const int  reach    = is_alone ? anywhere : support_reach;
    for (const Plane &plane : planes)
      {
        const unsigned int  first = plane.number * n_nodes;
        const double *const mass  = node_mass.data() + first;
        double *const       to    = force.begin() + nodes.n_components * first;
        const double        minimum = plane.share * minimum_mass;
        for (const unsigned int node : loaded)
          {
            if (!nodes.ranks->owns(first + node))
              continue;
            double f[dim];
            for (unsigned int d = 0; d < dim; ++d)
              f[d] = plane.factor * load[dim * node + d];
            if (mass[node] >= minimum)
              {
                for (unsigned int d = 0; d < dim; ++d)
                  to[nodes.n_components * node + d] += f[d];
                continue;
              }
            if (find_support<dim>(mass, minimum, nodes.n, node, support, reach))
              for (const SupportNode<dim> &s : support)
                for (unsigned int d = 0; d < dim; ++d)
                  to[nodes.n_components * s.node + d] += s.weight * f[d];
            else
              {
                hanging.push_back({nodes.first_plane + plane.number,
                                   number_in_whole(node),
                                   minimum,
                                   {}});
                std::copy(f, f + dim, hanging.back().load);
              }
          }
      }
    if (!is_alone && minimum_mass > 0.)
      add_hanging(node_mass, force);
  }


  template <int dim>
  std::uint64_t
  LoadDistribution<dim>::number_in_whole(const unsigned int node) const
  {
    std::uint64_t number = 0, stride = 1;
    unsigned int  rest = node;
    for (unsigned int d = 0; d < dim; ++d)
      {
        number += stride * (nodes.first[d] + rest % nodes.n[d]);
        rest /= nodes.n[d];
        stride *= nodes.n_whole[d];
      }
    return number;
  }


  template <int dim>
  void
  LoadDistribution<dim>::add_hanging(const std::vector<double> &node_mass,
                                     NodalVector               &force)
  {
    const std::vector<Hanging> all = nodes.ranks->all_gather(hanging);
    hanging.clear();
    if (all.empty())
      return;

    // Soil is far from all of these: look at the mass of the whole lattice.
    std::vector<Mass> own;
    for (unsigned int i = 0; i < node_mass.size(); ++i)
      if (node_mass[i] > 0. && nodes.ranks->owns(i))
        own.push_back({nodes.first_plane + i / n_nodes,
                       number_in_whole(i % n_nodes),
                       node_mass[i]});
    const std::vector<Mass> masses = nodes.ranks->all_gather(own);
    std::size_t             n      = 1;
    for (unsigned int d = 0; d < dim; ++d)
      n *= nodes.n_whole[d];
    std::vector<double> mass(n);
    for (const Hanging &one : all)
      {
        mass.assign(n, 0.);
        for (const Mass &node : masses)
          if (node.plane == one.plane)
            mass[node.node] = node.mass;
        find_support<dim>(
          mass.data(), one.minimum_mass, nodes.n_whole, one.node, support);
        const std::uint64_t plane = one.plane - nodes.first_plane;
        for (const SupportNode<dim> &s : support)
          {
            std::uint64_t node = 0, stride = 1;
            bool          is_here = plane < nodes.n_planes;
            unsigned int  rest    = s.node;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const int i =
                  static_cast<int>(rest % nodes.n_whole[d]) - nodes.first[d];
                rest /= nodes.n_whole[d];
                is_here = is_here && i >= 0 && i < static_cast<int>(nodes.n[d]);
                node += stride * i;
                stride *= nodes.n[d];
              }
            if (!is_here || !nodes.ranks->owns(plane * n_nodes + node))
              continue;
            for (unsigned int d = 0; d < dim; ++d)
              force.local_element(
                nodes.n_components * (plane * n_nodes + node) + d) +=
                s.weight * one.load[d];
          }
      }
  }


  template class LoadDistribution<2>;
  template class LoadDistribution<3>;
} // namespace Waker
