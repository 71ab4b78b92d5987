// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_conditioning_h
#define waker_fields_conditioning_h

#include <waker/fields/correlation.h>
#include <waker/fields/lattice.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  /// The standard normal score of a measured value (Marginal::normal_score).
  struct MeasuredScore
  {
    std::size_t cell;  // of the lattice
    double      score; // in the unit of the fields that are conditioned
  };

  /**
   * Turns an unconditional field z_u of any generator into one that takes the
   * measured values z_obs, by kriging the residual (Journel 1974; simple
   * kriging with the known mean zero): z_c = z_u + C_lo (C_oo + E)^-1 (z_obs -
   * z_u(obs) - e), with the covariances of cell averages, C_lo between lattice
   * and measured cells, C_oo between these. E is the diagonal variance of the
   * errors of measurement, e a sample of them: without it the fields would vary
   * too little. Several measurements in one cell are averaged (their errors are
   * independent). Linear in z_u and the noise of e.
   *
   * For n cells and n_o measured ones: memory 2 n + n_o^2 numbers, 2 n n_o
   * operations per field.
   */
  class Conditioning
  {
  public:
    /**
     * @param cell_variance of the fields to be conditioned: their covariance is
     *        between_cells(lag) * cell_variance / between_cells(0). So
     *        between_cells(0) for fields as they come out of a generator,
     *        1 for those normalised to unit variance of the cells
     * @param error_variance of one measured score, >= 0
     * @param path "Random fields/strength", for errors
     * @param common_variance of a part that is the same in all cells, beside
     *        the cells' own: it is added to every covariance
     * @throws UserError path + "/Measurements" if C_oo + E is singular in
     * double precision, or if there are more than maximum_measured_cells
     */
    Conditioning(const FieldLattice               &lattice,
                 const Correlation                &correlation,
                 const std::vector<MeasuredScore> &measurements,
                 const double                      cell_variance,
                 const double                      error_variance,
                 const std::string                &path,
                 const double                      common_variance = 0.);
    ~Conditioning();
    Conditioning(Conditioning &&);
    Conditioning &
    operator=(Conditioning &&);

    static constexpr std::size_t maximum_measured_cells = 6000;

    /// Standard normal numbers that one field needs: one per measured cell if
    /// there are errors of measurement, otherwise none.
    std::size_t
    n_noise() const;

    /// Cells with at least one measurement.
    std::size_t
    n_measured_cells() const;

    /**
     * @param noise n_noise() numbers, independent of those of the field
     * @param values the field, one number per cell of the lattice: changed in
     *        place. Measured cells take the measured score exactly if there are
     *        no errors of measurement
     * @return what the measurements add to the common part
     */
    double
    apply(const double *noise, double *values) const;

    /// One line for the log: "conditioned on 36 measurements in 32 cells".
    std::string
    description() const;

  private:
    struct Kriging; // keeps Eigen out of this header
    std::unique_ptr<Kriging> kriging;
  };
} // namespace Waker

#endif
