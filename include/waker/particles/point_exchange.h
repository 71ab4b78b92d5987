// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_point_exchange_h
#define waker_particles_point_exchange_h

#include <waker/base/own_rows.h>
#include <waker/grid/partition.h>
#include <waker/particles/material_points.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * The points of a body, dealt out to the ranks of a realisation: each rank
   * has those in its own cells, with all of their arrays, and knows their
   * places among the points of the whole body. Of that every rank may have a
   * copy, as long as somebody looks at it: it is right where it has last been
   * gathered.
   *
   * All functions but the const ones are collective.
   */
  template <int dim>
  class PointExchange
  {
  public:
    using Names = std::vector<std::string>; // of arrays

    /// Take from the whole body, which each rank has, what lies in the own
    /// cells.
    PointExchange(const Partition<dim>      &partition,
                  const MPI_Comm             communicator,
                  const MaterialPoints<dim> &whole);

    MaterialPoints<dim> &
    own()
    {
      return points;
    }

    /// Which of all points these are.
    OwnRows
    rows() const
    {
      return {communicator, n_whole, places};
    }

    /**
     * Points go to the ranks whose cells they lie in, over any distance.
     * @return how many have gone, on all ranks together
     * @throws std::logic_error if the ranks together have not as many points as
     *         before: a bug
     */
    std::size_t
    send_home(const Partition<dim> &partition);

    /// Give back the copy, but for the ids.
    static void
    forget(MaterialPoints<dim> &whole);

    /// What steps change of the places of points: position, velocity, domain,
    /// volume.
    /// @param constant what they do not change, which is gathered if it is not
    ///        there
    void
    gather_places(MaterialPoints<dim> &whole, const Names &constant) const;

    /// All of their arrays.
    void
    gather(MaterialPoints<dim> &whole) const;

    /// The other way: an array that has changed in the whole body.
    void
    take(const std::string &name, const MaterialPoints<dim> &whole);

    /**
     * Points leave.
     * @param own_list their places in the own points, ascending
     * @return those of all of them in the whole body, ascending: the same on
     *         each rank
     */
    std::vector<std::size_t>
    remove(const std::vector<std::size_t> &own_list);

    /// The whole body has got points at its end: those in own cells are own
    /// ones.
    void
    take_new(const Partition<dim> &partition, const MaterialPoints<dim> &whole);

    /// What this rank has sent so far.
    const NodeExchange::Traffic &
    traffic() const
    {
      return sent;
    }

    /// Points of the rank that has most, over those of the mean rank.
    double
    imbalance() const;

  private:
    /// The arrays that are named, those that are constant if they are missing;
    /// all if none is named.
    void
    gather(MaterialPoints<dim> &whole,
           const Names         &changing,
           const Names         &constant) const;

    MPI_Comm                      communicator;
    std::size_t                   n_whole;
    std::vector<bool>             used; // which arrays points have
    MaterialPoints<dim>           points;
    std::vector<std::uint32_t>    places; // of the own points in the whole body
    mutable NodeExchange::Traffic sent;
  };
} // namespace Waker

#endif
