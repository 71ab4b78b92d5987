// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_newton_h
#define waker_mechanics_newton_h

#include <waker/mechanics/direct_solver.h>
#include <waker/mechanics/parameters.h>
#include <waker/mechanics/system_operator.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/nodal_state.h>
#include <waker/nodes/reached_nodes.h>
#include <waker/nodes/resistance.h>

#include <memory>

namespace Waker
{
  /// What Newton did in one step.
  struct NewtonReport
  {
    bool         converged         = false;
    unsigned int iterations        = 0; // linear systems solved
    unsigned int linear_iterations = 0;
    /// Of these with the stronger preconditioner, and how often it could not be
    /// set up (LinearSolver).
    unsigned int strong_iterations = 0, strong_failures = 0;
    /// Relative residual before each iteration and after the last.
    std::vector<double> residuals;
  };

  /// How Newton's linear systems are solved.
  enum class LinearMethod
  {
    krylov, // GMRES (conjugate gradients if the tangent is symmetric)
    direct, // 2D: a factorisation. 3D: conjugate gradients, then GMRES, with
            // Multilevel where the diagonal takes long
    elastic // the same, of a linear body: one matrix for all iterations
  };

  /**
   * Newton's method for the equations of a step,
   *   R(u) = r (s F_ext - F_int(u)) - M (k u - q) - F_sup(u) = 0,
   * on the equations that are not removed (eq. 2.23 of Remmerswaal 2023). F_int
   * and F_sup are the sums of the resistances' forces (nodes/resistance.h);
   * F_int is left in the nodes' internal force.
   *
   * Convergence is measured by sqrt(sum_i phi_i |R_i|^2) relative to the same
   * norm of the external, internal and inertial forces, where phi_i = m_i / m
   * is the share of a full node's mass that node i has: the force on a node
   * that a support domain has hardly touched means nothing, and does not count.
   * A residual that is round-off of its own terms has converged as well: a body
   * in uniform motion has no force to compare with. So has, in a static step,
   * a small one of which only motions without stiffness are left
   * (DirectSolver).
   * Where nothing but supports acts on a body without inertia, the forces of
   * the supports are what the residual is compared with.
   */
  template <int dim>
  class NewtonSolver
  {
  public:
    /// All references must outlive this object.
    /// @param full_node_mass mass of a node inside the body (Mg)
    /// @param method direct where there is no inertia to help a Krylov method
    NewtonSolver(const BackgroundGrid<dim> &grid,
                 const Fixities<dim>       &fixities,
                 const NewtonParameters    &parameters,
                 const double               full_node_mass,
                 const LinearMethod         method = LinearMethod::krylov);

    /// What the residual has beside the resistances: the inertia M (k u - q),
    /// the ramp r and the load factor s (eqs. 2.22-2.25).
    struct ResidualTerms
    {
      double             ramp    = 1.;
      double             factor  = 0.;      // k, 1/s^2
      const NodalVector *history = nullptr; // q, m/s^2
      double             load    = 1.;
    };

    /**
     * @param resistances of the step, which has begun
     * @param nodes in: mass, external_force, increment (the first guess, with
     *        prescribed values in the removed dofs); out: increment,
     *        internal_force
     */
    NewtonReport
    solve(const Resistances<dim> &resistances,
          const ResidualTerms    &terms,
          NodalState             &nodes);

  private:
    /// The forces of the resistances at the nodes' increment.
    void
    set_forces(const Resistances<dim> &resistances, NodalState &nodes);

    /// R and its relative norm.
    double
    residual(const ResidualTerms &terms, const NodalState &nodes);

    /// Norm of the residual, by its last reference.
    double
    norm_of_residual(const std::vector<double> &mass) const;

    /// One linear system, after the resistances have been linearised. A direct
    /// solver leaves in R what it could solve for.
    LinearReport
    solve_linear(const Resistances<dim> &resistances,
                 const ResidualTerms    &terms,
                 const NodalState       &nodes,
                 const bool              first,
                 const double            norm);

    const Fixities<dim> *fixities;
    NewtonParameters     parameters;
    double               full_node_mass;
    LinearMethod         method;
    LinearSolver         linear_solver;
    ReachedNodes         reached;
    NodalVector          R;
    double               reference = 0.; // square of R's, kN^2
    NodalVector          correction;
    /// Of the resistances that are loads, and of supports (kN); empty without.
    NodalVector load_force, support_force;
    /// Only in 2D, unless the method is krylov.
    std::unique_ptr<DirectSolver<dim>> direct_solver;
  };
} // namespace Waker

#endif
