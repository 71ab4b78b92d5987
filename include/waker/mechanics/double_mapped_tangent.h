// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_double_mapped_tangent_h
#define waker_mechanics_double_mapped_tangent_h

#include <waker/mechanics/stress_update.h>
#include <waker/nodes/operator.h>

namespace Waker
{
  template <int dim>
  class ElementTangents;


  /**
   * The double-mapped stiffness (Gonzalez Acosta et al. 2020): DM with linear
   * functions, DM-G with GIMP. The points' tangents D_p go to the nodes of each
   * element and from there to its Gauss points, where an ordinary Q1 stiffness
   * is integrated. Element-local, per active element e with n nodes:
   *   D_i = n / V_e sum_p D_p int_{Omega_p in e} N_i dV,
   *   D_g = sum_i N_i(x_g) D_i,  K_e = sum_g w_g |J| B_g^T D_g B_g.
   * Constant in a full element wherever the points lie, proportional to the
   * filled share in others, and blind to cell crossings; but not the derivative
   * of the internal force: Newton converges linearly with it. If the points'
   * dilatation is that of the cells' centres (MeanDilatationMotion), B_g has
   * the element's, too (Hughes 1980), with a full row zz in plane strain, by
   * the cell's share of B-bar (FilledCells).
   */
  template <int dim>
  class DoubleMappedTangent : public Operator
  {
  public:
    /// The weights must outlive this object.
    DoubleMappedTangent(const Weights<dim> &weights);
    ~DoubleMappedTangent();

    /// Linearise where `stress_update` was last evaluated: of the same motion
    /// each time.
    void
    reinit(const StressUpdate<dim>   &stress_update,
           const MaterialPoints<dim> &points);

    void
    vmult(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    /// As the materials' tangents.
    bool
    is_symmetric() const override
    {
      return symmetric;
    }

  private:
    const Weights<dim>                   *weights;
    std::unique_ptr<ElementTangents<dim>> elements;
    std::vector<SymmetricTensor<4, 3>>    material_tangents;
    bool                                  symmetric = true;
  };
} // namespace Waker

#endif
