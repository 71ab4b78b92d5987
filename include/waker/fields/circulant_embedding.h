// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_circulant_embedding_h
#define waker_fields_circulant_embedding_h

#include <waker/fields/field_generator.h>

#include <vector>

namespace Waker
{
  /**
   * Circulant embedding (Dietrich & Newsam 1997; Wood & Chan 1994): the exact
   * covariance of the cell averages, by two Fourier transforms per field.
   *
   * The lattice is part of a torus of at least 2 (n - 1) cells per direction.
   * The covariance on it, even in each direction, is diagonal in the basis of
   * the discrete Hartley transform H (orthogonal, real, its own inverse):
   *   field = H sqrt(lambda) H noise,
   * the symmetric root of the covariance. The noise has a number per cell of
   * the torus, those of the lattice first: fields of the same noise and
   * different scales of fluctuation resemble each other. Where eigenvalues are
   * negative the torus grows, up to a limit; what is left below zero is cut off
   * if the sum of its absolute values is less than `tolerance` of the trace.
   */
  class CirculantEmbedding : public FieldGenerator
  {
  public:
    /// Largest share of negative eigenvalues that is cut off.
    static constexpr double tolerance = 1e-6;

    /// Bytes for each cell of the torus: it and its roots, the noise of a
    /// field, and at the start the table of covariances.
    static constexpr double bytes_per_cell = 32.;

    /// @throws UserError path + "/Generator" if no torus up to `maximum_cells`
    /// will do; says which share is negative and what to try instead. path +
    /// "/Cell size" if there is not as much memory
    CirculantEmbedding(const FieldLattice &lattice,
                       const Correlation  &correlation,
                       const std::string  &path,
                       const std::size_t   maximum_cells = 1 << 27);
    ~CirculantEmbedding() override;

    std::size_t
    n_noise() const override;

    void
    generate(const double *noise, double *values) const override;

    std::string
    description() const override;

    /// The torus that was found.
    const std::array<unsigned int, 3> &
    torus() const;

    /// Share of the trace that was cut off.
    double
    negative_share() const;

  private:
    struct Transform; // FFTW's plan and its aligned memory
    FieldLattice                lattice;
    std::array<unsigned int, 3> n_torus;
    double                      negative = 0.;
    std::vector<double>         root; // sqrt(eigenvalue), scaled
    std::unique_ptr<Transform>  transform;
  };
} // namespace Waker

#endif
