// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_double_mapped_tangent_h
#define waker_mechanics_double_mapped_tangent_h

#include <waker/mechanics/stress_update.h>
#include <waker/nodes/operator.h>

#include <array>

namespace Waker
{
  /**
   * The double-mapped stiffness (Gonzalez Acosta et al. 2020): DM with linear
   * functions, DM-G with GIMP. The points' tangents D_p go to the nodes of each
   * element and from there to its Gauss points, where an ordinary Q1 stiffness
   * is integrated. Element-local, per active element e with n nodes:
   *   D_i = n / V_e sum_p D_p int_{Omega_p in e} N_i dV,
   *   D_g = sum_i N_i(x_g) D_i,  K_e = sum_g w_g |J| B_g^T D_g B_g.
   * Constant in a full element wherever the points lie, proportional to the
   * filled share in others, and blind to cell crossings; but not the derivative
   * of the internal force: Newton converges linearly with it.
   */
  template <int dim>
  class DoubleMappedTangent : public Operator
  {
  public:
    DoubleMappedTangent(const Weights<dim> &weights);

    /// Linearise where `stress_update` was last evaluated.
    void
    reinit(const StressUpdate<dim>   &stress_update,
           const MaterialPoints<dim> &points);

    void
    vmult(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    bool
    is_symmetric() const override
    {
      return true;
    }

  private:
    static constexpr unsigned int n_stresses = dim * (dim + 1) / 2;
    static constexpr unsigned int n_vertices = 1 << dim;
    static constexpr unsigned int n_gauss    = n_vertices;

    struct Element
    {
      unsigned int node; // lower left
      /// First the sums over points at the nodes, then the values at the Gauss
      /// points times their weight (kN m^(dim-2)).
      double D[n_gauss][n_stresses][n_stresses];
    };

    const Weights<dim>                *weights;
    std::vector<int>                   element_of_cell; // by lower left node
    std::vector<Element>               elements;        // the active ones
    std::vector<SymmetricTensor<4, 3>> material_tangents;
    /// N_i at the Gauss points, and their gradients (1/m).
    double shape_values[n_gauss][n_vertices];
    double shape_gradients[n_gauss][n_vertices][dim];
    std::array<unsigned int, n_vertices> vertex_offsets; // in node numbers
  };
} // namespace Waker

#endif
