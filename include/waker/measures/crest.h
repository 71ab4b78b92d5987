// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_crest_h
#define waker_measures_crest_h

#include <waker/particles/material_points.h>

#include <limits>
#include <optional>
#include <vector>

namespace Waker
{
  /// Half of the size of a point's domain at t = 0 (m).
  template <int dim>
  const Tensor<1, dim> &
  initial_half_size(const MaterialPoints<dim> &points, const std::size_t p)
  {
    return points.initial_half_size.empty() ? points.half_size[p]
                                            : points.initial_half_size[p];
  }


  /// What has become of a crest.
  struct CrestDamage
  {
    /// From the crest's edge back to the first stable soil, the largest of all
    /// z (m).
    double retrogression = 0.;
    /// Length along z at which some of the crest has failed (m); NaN in 2D.
    double width = std::numeric_limits<double>::quiet_NaN();
  };


  /**
   * The crest of a slope, as it lay at t = 0: the highest row of points at each
   * z, and its edge on the side to which the slope falls. In 3D the z are
   * divided where points begin and end: a strip for each layer of points.
   *
   * A strip is damaged if a point of its crest is not stable any more, or not
   * there any more. Its retrogression distance is that from the edge to the
   * foremost stable point of the crest, or to the rear end of the crest if no
   * point of it is stable (section 6.2.3 of Remmerswaal 2023): stable soil that
   * stands in front of failed soil bounds it.
   */
  template <int dim>
  class Crest
  {
  public:
    /**
     * @param points at t = 0
     * @param direction +1 or -1: along x, to which the slope falls
     * @param edge x of it (m); none: the end of the crest's points
     */
    Crest(const MaterialPoints<dim>   &points,
          const int                    direction,
          const std::optional<double> &edge);

    /// @param stable of each point that is there, by its place in the arrays
    CrestDamage
    damage(const MaterialPoints<dim> &points,
           const std::vector<bool>   &stable) const;

    /// +1 or -1: along x, to which the slope falls.
    double
    direction() const
    {
      return sign;
    }

    /// From the rear end to the front end of the crest's points, the largest
    /// of all z (m): x0 < x1.
    double
    lowest_x() const;

    double
    highest_x() const;

  private:
    struct Strip
    {
      double      top   = std::numeric_limits<double>::lowest(); // m
      double      front = std::numeric_limits<double>::lowest(); // of points
      double      rear  = std::numeric_limits<double>::max();
      std::size_t n     = 0; // points of its crest
    };

    /// Call f(strip number) for all strips in which the point lay.
    template <typename Function>
    void
    for_each_strip(const MaterialPoints<dim> &points,
                   const std::size_t          p,
                   const Function            &f) const;

    bool
    is_crest(const MaterialPoints<dim> &points,
             const std::size_t          p,
             const Strip               &strip) const;

    /// x to which a point reached towards the slope, times the direction.
    double
    front(const MaterialPoints<dim> &points, const std::size_t p) const;

    double                sign;
    std::optional<double> given_edge; // times the direction
    std::vector<double>   ends;       // of the strips along z; one more
    std::vector<Strip>    strips;     // x times the direction
  };
} // namespace Waker

#endif
