// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_subdivision_stage_h
#define waker_fields_subdivision_stage_h

#include <waker/fields/correlation.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * One stage of local average subdivision: every parent cell is split into
   * 2^dim children (Fenton & Vanmarcke 1990),
   *   Z_children = A^T Z_parents + C U,   R A = S,   C C^T = B - S^T A,
   * with the covariances R between the parents of the neighbourhood, S between
   * these and the children, B between the children. The neighbourhood is
   * the parent and those that touch it (3, 3 x 3, 3 x 3 x 3), without those
   * that the field does not have. The last child follows from the mean of the
   * children, which is the parent.
   */
  class SubdivisionStage
  {
  public:
    /**
     * @param n_parents cells per direction; unused directions have one
     * @param child_size size of the cells after the subdivision (m)
     * @throws UserError path + "/Generator"
     */
    SubdivisionStage(const Correlation                 &correlation,
                     const std::array<unsigned int, 3> &n_parents,
                     const std::array<double, 3>       &child_size,
                     const std::string                 &path);

    /// 2^dim - 1 per parent.
    std::size_t
    n_noise() const;

    /// @param parents their local averages, first direction fastest
    /// @param noise n_noise() standard normal numbers
    /// @param children the local averages of 2^dim times as many cells
    void
    subdivide(const double *parents,
              const double *noise,
              double       *children) const;

  private:
    /// What parents with the same neighbourhood have in common.
    struct Neighbourhood
    {
      std::vector<std::ptrdiff_t> parents; // cell numbers - that of the parent
      std::vector<double>         A;       // [child][parent]
      std::vector<double>         C;       // [child][noise]
    };

    Neighbourhood
    neighbourhood(const std::vector<double> &covariance,
                  const unsigned int         sides,
                  const std::string         &path) const;

    unsigned int                dim;
    std::array<unsigned int, 3> n_parents;
    std::vector<Neighbourhood>  neighbourhoods; // number: sides_of_parent
  };
} // namespace Waker

#endif
