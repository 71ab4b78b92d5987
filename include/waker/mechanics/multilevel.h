// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_multilevel_h
#define waker_mechanics_multilevel_h

#include <waker/grid/background_grid.h>
#include <waker/mechanics/preconditioner.h>

#include <memory>
#include <vector>

namespace Waker
{
  template <int dim>
  class NodeMatrix;


  /**
   * Algebraic multigrid by smoothed aggregation (Trilinos ML) for a static
   * stiffness in space: iterations hardly grow with the number of cells, while
   * with the diagonal they grow with the body's length over the cell size.
   *
   * The matrix is that of Operator::add_entries(), which couples neighbours;
   * its coarse spaces have the rigid body motions. Where it is much stiffer
   * than the operator all the same, as at nodes that soil hardly touches, the
   * inverse of the operator's diagonal is added.
   */
  template <int dim>
  class Multilevel : public Preconditioner
  {
  public:
    /// @param grid must outlive this object
    explicit Multilevel(const BackgroundGrid<dim> &grid);

    ~Multilevel() override;

    bool
    reinit(const Operator &A) override;

    void
    clear() override;

    void
    vmult(NodalVector &dst, const NodalVector &src) const override;

  private:
    struct Levels;

    /// @throws whatever ML throws
    void
    set_up(const Operator &A);

    /// The matrix, row after row.
    void
    fill(const NodeMatrix<dim>            &nodes,
         const NodalVector                &diagonal,
         const std::vector<unsigned char> &is_equation);

    /// Does it answer to a vector as it should?
    bool
    is_positive() const;

    const BackgroundGrid<dim> *grid;
    std::unique_ptr<Levels>    levels;
  };
} // namespace Waker

#endif
