// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_nonlocal_average_h
#define waker_mechanics_nonlocal_average_h

#include <deal.II/base/point.h>

#include <waker/materials/softening_measure.h>

#include <array>
#include <cstdint>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * Averages over the surroundings of points,
   *   <e>_p = sum_q w(|x_q - x_p| / l) V_q e_q / sum_q w V_q,
   * over those nearer than 2.5 l, where w is 1 % of the most it is: over the
   * soil that is there, so that constants stay as they are beside a free
   * surface, too. A point that has no neighbours keeps what it has.
   *
   * Points lie sorted by rows of bins, and a neighbourhood is a few stretches
   * of neighbours in memory. Weights are exact to 2e-6.
   */
  template <int dim>
  class NonlocalAverage
  {
  public:
    /// @param length l (m), above 0
    NonlocalAverage(const double length, const NeighbourWeight weight);

    /// w = 0 from here on, in lengths.
    static constexpr double reach = 2.5;

    /// What the bins are laid out by: of points that each rank has a part of,
    /// it is that of all ranks.
    struct Extent
    {
      Point<dim> low, high;           // m; of no points far above and below
      double     volume = 0., n = 0.; // sums over the points
    };

    static Extent
    extent_of(const std::vector<std::uint32_t> &members,
              const std::vector<Point<dim>>    &positions,
              const std::vector<double>        &volumes);

    /// For these points as they lie.
    /// @param members their numbers; neighbours are summed up in their order
    /// @param positions, volumes, values (e, at least 0) of all points
    void
    reinit(const std::vector<std::uint32_t> &members,
           const std::vector<Point<dim>>    &positions,
           const std::vector<double>        &volumes,
           const std::vector<double>        &values)
    {
      reinit(members,
             positions,
             volumes,
             values,
             extent_of(members, positions, volumes));
    }

    /// Lay out the bins for all points. @return how far around a point, in each
    /// direction, others may lie in bins with neighbours of it (m)
    double
    lay_bins(const Extent &all);

    /// The same, for some of the points. Those around which, so far, all others
    /// are among them have the averages that they have among all, to the bit.
    /// @param all of all points, the sums but for round-off
    void
    reinit(const std::vector<std::uint32_t> &members,
           const std::vector<Point<dim>>    &positions,
           const std::vector<double>        &volumes,
           const std::vector<double>        &values,
           const Extent                     &all);

    /// The members in an order in which neighbours follow each other.
    const std::vector<std::uint32_t> &
    order() const
    {
      return sorted;
    }

    /// <e> of the member order()[k]; 0 if all neighbours have 0.
    double
    at(const unsigned int k) const;

  private:
    static constexpr unsigned int n_lanes = 16;

    struct Stretch
    {
      unsigned int begin, end;
    };

    /// Sort the members into those that they lie in.
    void
    sort(const std::vector<std::uint32_t> &members,
         const std::vector<Point<dim>>    &positions);

    /// The stretches that hold the neighbours of order()[k], and more.
    /// @return do any of them have a value?
    bool
    find_stretches(const unsigned int k) const;

    template <NeighbourWeight weight_function>
    double
    average(const unsigned int k) const;

    double          length;
    NeighbourWeight weight;

    // The bins, and what lies in them, sorted; lengths in l.
    Point<dim>                          corner; // m
    double                              bin_size    = 1.;
    double                              mean_volume = 1.; // m^dim
    std::array<int, dim>                n_of_all;         // bins
    std::array<int, dim>                first_bin;        // that has members
    std::array<int, dim>                n_bins;           // from there on
    std::vector<unsigned int>           starts;    // of each bin, x first
    std::vector<unsigned int>           n_sources; // with values, before that
    std::vector<std::uint32_t>          sorted;
    std::array<std::vector<float>, dim> place;
    std::vector<float>                  volume;  // of the mean volume
    std::vector<float>                  content; // times the value
    std::vector<double>                 value;
    std::vector<unsigned int>           bin_of, cursor; // work space
    mutable std::vector<Stretch>        stretches;      // likewise
  };
} // namespace Waker

#endif
