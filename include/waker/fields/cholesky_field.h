// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_cholesky_field_h
#define waker_fields_cholesky_field_h

#include <waker/fields/field_generator.h>

#include <memory>
#include <string>

namespace Waker
{
  /**
   * The exact covariance C of the cell averages, for small lattices:
   *   field = L noise,  C = L L^T (Cholesky).
   * A very smooth field (Gaussian correlation, long scales) has a covariance
   * that is singular in double precision: then the pivoted factorisation, which
   * stops at the numerical rank, and noise beyond the rank has no effect.
   * Setting up costs n^3 / 3 operations, a field n^2, memory 8 n^2 bytes.
   */
  class CholeskyField : public FieldGenerator
  {
  public:
    /// 288 MB, 12 s to set up and 40 ms per field on one core.
    static constexpr std::size_t maximum_cells = 6000;

    /// @throws UserError path + "/Generator" for a lattice of more than
    /// maximum_cells cells, or a covariance that is not positive semidefinite
    CholeskyField(const FieldLattice &lattice,
                  const Correlation  &correlation,
                  const std::string  &path);
    ~CholeskyField() override;

    /// The number of cells.
    std::size_t
    n_noise() const override;

    void
    generate(const double *noise, double *values) const override;

    std::string
    description() const override;

  private:
    struct Factor; // keeps Eigen out of this header
    std::size_t             n;
    std::unique_ptr<Factor> factor;
  };
} // namespace Waker

#endif
