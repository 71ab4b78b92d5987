// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_load_distribution_h
#define waker_loads_load_distribution_h

#include <waker/loads/load_nodes.h>
#include <waker/loads/nodal_support.h>
#include <waker/nodes/nodal_vector.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * Loads of nodes on their way to nodes that can carry them: a node with less
   * mass than a minimum hands its load to others nearby (find_support()).
   *
   * On several ranks each hands on the loads of its own nodes, so what it adds
   * to nodes of others has to be summed up (NodeExchange::add_to_owners()). Its
   * window must reach support_reach nodes beyond its own ones. What finds no
   * support there is told to all.
   */
  template <int dim>
  class LoadDistribution
  {
  public:
    explicit LoadDistribution(const LoadNodes<dim> &nodes);

    /// A plane of nodes, of a load that is the same in several.
    struct Plane
    {
      unsigned int number = 0;  // from the first one here
      double       share  = 1.; // of the minimum of mass
      double       factor = 1.; // of the load
    };

    /**
     * Collective, if the minimum is above 0.
     *
     * @param loaded numbers of the nodes in a plane; those that are not this
     *        rank's are left to others
     * @param load dim components for each node of a plane (kN)
     * @param node_mass of each node of all planes here (Mg)
     * @param minimum_mass of a node that carries load (Mg); 0: all do
     * @param force added to (kN)
     */
    void
    add(const std::vector<unsigned int> &loaded,
        const std::vector<double>       &load,
        const std::vector<Plane>        &planes,
        const std::vector<double>       &node_mass,
        const double                     minimum_mass,
        NodalVector                     &force);

  private:
    /// A load that has found no support.
    struct Hanging
    {
      std::uint64_t plane, node; // of the whole lattice
      double        minimum_mass;
      double        load[dim];
    };

    struct Mass
    {
      std::uint64_t plane, node; // of the whole lattice
      double        mass;
    };

    /// A node's number in the whole lattice of a plane.
    std::uint64_t
    number_in_whole(const unsigned int node) const;

    void
    add_hanging(const std::vector<double> &node_mass, NodalVector &force);

    LoadNodes<dim>                nodes;
    unsigned int                  n_nodes; // of a plane
    std::vector<Hanging>          hanging;
    std::vector<SupportNode<dim>> support;
  };
} // namespace Waker

#endif
