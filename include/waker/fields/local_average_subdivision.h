// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_local_average_subdivision_h
#define waker_fields_local_average_subdivision_h

#include <waker/fields/field_generator.h>
#include <waker/fields/subdivision_stage.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Local average subdivision (Fenton & Vanmarcke 1990) in 1D, 2D and 3D, with
   * a scale of fluctuation per direction. Stage 0 is a coarse field of
   * k_1 x k_2 x k_3 local averages with their exact covariance; m times, every
   * cell is then split into 2^dim (SubdivisionStage).
   *
   * k_d = ceil(n_d / 2^m) with the smallest m for which k_1 k_2 k_3 is at most
   * maximum_stage_0. So k_d 2^m >= n_d cells are generated; the lattice is the
   * part at the lower corner (cells 0 <= i_d < n_d).
   *
   * Not exact for m > 1: the neighbourhood of three parents a direction makes
   * variance and covariance depend on the place, with the pattern of the
   * subdivision. doc/verification/local_average_subdivision.md says how much.
   */
  class LocalAverageSubdivision : public FieldGenerator
  {
  public:
    /// Largest field that is generated.
    static constexpr std::size_t maximum_cells = std::size_t(1) << 27;

    /// Cells of stage 0: 256, in 3D 512, as in las2g and las3g of Fenton.
    static constexpr unsigned int
    default_stage_0(const unsigned int dim)
    {
      return dim == 3 ? 512 : 256;
    }

    /// @param maximum_stage_0 cells of stage 0; 0: default_stage_0(dim)
    /// @throws UserError path + "/Generator" if the field would have more than
    /// maximum_cells cells, or a covariance is not positive semidefinite
    LocalAverageSubdivision(const FieldLattice &lattice,
                            const Correlation  &correlation,
                            const std::string  &path,
                            const unsigned int  maximum_stage_0 = 0);
    ~LocalAverageSubdivision() override;

    /// The number of cells k_1 k_2 k_3 2^(m dim) of the field that is
    /// generated. Order: stage 0; then per stage and parent cell 2^dim - 1
    /// numbers.
    std::size_t
    n_noise() const override;

    void
    generate(const double *noise, double *values) const override;

    std::string
    description() const override;

    /// k_1, k_2, k_3 of stage 0.
    const std::array<unsigned int, 3> &
    stage_0() const
    {
      return k;
    }

    /// m
    unsigned int
    n_subdivisions() const
    {
      return stages.size();
    }

  private:
    struct Factor; // of the covariance of stage 0
    FieldLattice                lattice;
    std::array<unsigned int, 3> k;
    std::unique_ptr<Factor>     factor;

    std::vector<SubdivisionStage> stages;

    mutable std::vector<double> coarse, fine; // work space of generate()
  };
} // namespace Waker

#endif
