// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_sliding_masses_h
#define waker_measures_sliding_masses_h

#include <waker/measures/crest.h>
#include <waker/particles/body.h>

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace Waker
{
  /// What a number of a sliding mass is.
  enum class SlidingQuantity
  {
    time,     // s
    length,   // m, also a place
    volume,   // m^3; in 2D m^2, per metre
    direction // +1 or -1
  };


  /// Soil that broke loose at one moment. Places and volumes are those at t =
  /// 0: where the soil came from. What there is not in 2D is NaN.
  struct SlidingMass
  {
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    double time   = 0.;
    double volume = 0.;
    /// Length along z at which it has soil (m).
    double                width  = nan;
    std::array<double, 3> centre = {{nan, nan, nan}};
    std::array<double, 3> lower  = {{nan, nan, nan}}; // ends of its box
    std::array<double, 3> upper  = {{nan, nan, nan}};

    /// Call f(name, number, what it is) for each number.
    template <typename Self, typename Function>
    static void
    for_each_number(Self &s, const Function &f)
    {
      f("time", s.time, SlidingQuantity::time);
      f("volume", s.volume, SlidingQuantity::volume);
      f("width", s.width, SlidingQuantity::length);
      const char *const names[3][3] = {{"x", "x_from", "x_to"},
                                       {"y", "y_from", "y_to"},
                                       {"z", "z_from", "z_to"}};
      for (unsigned int d = 0; d < 3; ++d)
        {
          f(names[d][0], s.centre[d], SlidingQuantity::length);
          f(names[d][1], s.lower[d], SlidingQuantity::length);
          f(names[d][2], s.upper[d], SlidingQuantity::length);
        }
    }

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for_each_number(*this,
                      [&](const char *, double &number, SlidingQuantity) {
                        archive &number;
                      });
    }
  };


  /**
   * The slides of a run, in order of time, and what they have left (section
   * 6.2.3 of Remmerswaal 2023). Volumes are those at t = 0, of the soil that
   * was there: what flows in later is not part of it. Soil that leaves the box
   * stays in the count, as what it was.
   */
  struct SlidingMasses
  {
    /// Along x, to which the slope falls: +1 or -1.
    double direction            = 1.;
    double whole_volume         = 0.; // m^dim
    double failed_volume        = 0.;
    double retrogression        = 0.;               // see CrestDamage, m
    double damaged_crest_width  = SlidingMass::nan; // in 3D, m
    double largest_displacement = 0.; // of the soil that is stable, now, m
    std::vector<SlidingMass> masses;

    double
    stable_volume() const
    {
      return whole_volume - failed_volume;
    }

    /// Of the whole body (-).
    double
    relative_failure_volume() const
    {
      return failed_volume / whole_volume;
    }

    /// Call f(name, number, what it is) for each number of the whole.
    template <typename Self, typename Function>
    static void
    for_each_number(Self &s, const Function &f)
    {
      f("direction", s.direction, SlidingQuantity::direction);
      f("whole_volume", s.whole_volume, SlidingQuantity::volume);
      f("failed_volume", s.failed_volume, SlidingQuantity::volume);
      f("retrogression_distance", s.retrogression, SlidingQuantity::length);
      f("damaged_crest_width", s.damaged_crest_width, SlidingQuantity::length);
      f("largest_stable_displacement",
        s.largest_displacement,
        SlidingQuantity::length);
    }

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for_each_number(*this,
                      [&](const char *, double &number, SlidingQuantity) {
                        archive &number;
                      });
      archive &masses;
    }
  };


  /**
   * Finds the slides while they happen: in the beginning all soil is one stable
   * cluster. Whenever some of it has moved further than a limit, it is split in
   * two by exact two-means of its displacements |u| since t = 0 (two_means()),
   * weighted by the volumes at t = 0: with points of one size, their count. The
   * upper part is a sliding mass, and stays one; the lower part is what is
   * stable. If that has still moved further, it is split again, so that no
   * stable soil ever has; soil that has moved by one distance, and further than
   * the limit, is one mass.
   *
   * Each point has the number of its mass in the scalar "slide" (1, 2, ...; 0:
   * stable), and its volume at t = 0 in "initial volume". A point with 0 there
   * came in later: it is neither stable nor sliding. Results do not depend on
   * the order of the points in the arrays: sums go by their ids.
   */
  template <int dim>
  class SlidingMassFinder
  {
  public:
    /// @param points at t = 0
    /// @param limit of |u| of stable soil (m)
    SlidingMassFinder(const MaterialPoints<dim> &points,
                      Crest<dim>                 crest,
                      const double               limit);

    /// The scalar of the points that update() changes.
    static const char *
    changed_scalar();

    /// The one that it looks at besides.
    static const char *
    volume_scalar();

    /// Give the points their scalars, at t = 0.
    static void
    start(MaterialPoints<dim> &points);

    /**
     * Look at the points at a time (s). Idempotent.
     * @param body of which `points` are all
     * @return has soil slid? Then changed_scalar() of the points is new.
     */
    bool
    update(const double         time,
           const Body<dim>     &body,
           MaterialPoints<dim> &points,
           SlidingMasses       &sliding) const;

    void
    update(const double         time,
           MaterialPoints<dim> &points,
           SlidingMasses       &sliding) const
    {
      update(time, points, points, sliding);
    }

  private:
    Crest<dim> crest;
    double     limit;
    double     whole_volume; // m^dim
  };
} // namespace Waker

#endif
