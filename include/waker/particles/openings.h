// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_openings_h
#define waker_particles_openings_h

#include <waker/grid/background_grid.h>
#include <waker/particles/flow_parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /// A rectangle on a face of the grid's box (2D: a stretch): in its normal
  /// direction both corners lie on the face.
  template <int dim>
  struct Opening
  {
    unsigned int face;         // 2d lower, 2d + 1 upper face in direction d
    Point<dim>   lower, upper; // m
  };


  /// Put an opening on the lines of the grid.
  /// @param path of its subsection
  /// @throws UserError path + "/From", "/To": off the lines, outside the face,
  /// empty
  template <int dim>
  Opening<dim>
  place_opening(const BackgroundGrid<dim> &grid,
                const OpeningParameters   &parameters,
                const std::string         &path);


  /**
   * The parts of the box's faces through which material goes. An opening that
   * ends at an edge of the box has no end there: what passes the edge of two
   * faces passes both.
   */
  template <int dim>
  class Openings
  {
  public:
    explicit Openings(const BackgroundGrid<dim> &grid)
      : grid(&grid)
    {}

    void
    add(const Opening<dim> &opening)
    {
      list.push_back(opening);
    }

    bool
    empty() const
    {
      return list.empty();
    }

    /// Is the face open where the normal through x meets it?
    bool
    is_open(const unsigned int face, const Point<dim> &x) const;

    /// Has another opening more than an edge in common with one of these?
    bool
    meets(const Opening<dim> &other) const;

    /// Does x lie beyond a face, where that is open?
    bool
    is_passed_by(const Point<dim> &x) const;

  private:
    bool
    holds(const Opening<dim> &opening, const Point<dim> &x) const;

    const BackgroundGrid<dim> *grid;
    std::vector<Opening<dim>>  list;
  };
} // namespace Waker

#endif
