// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_random_fields_h
#define waker_fields_random_fields_h

#include <waker/fields/field_generator.h>
#include <waker/fields/parameters.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  class Conditioning;


  /**
   * All random fields of a case, as normal scores: a function of white noise.
   *
   * A score is a standard normal number where the statistics are those of the
   * cells; where they are those of points it has the variance of the cell
   * averages, gamma < 1. It may be a sum of two: that of the average of the
   * soil, one number for all cells, and what varies from cell to cell. Fields
   * that are correlated are mixed cell by cell with the Cholesky factor of
   * their correlation matrix. A marginal distribution turns scores into values
   * (marginal.h).
   */
  class RandomFields
  {
  public:
    /// Normal score of a measured value of field `field` at x (m); the scores
    /// of the field have the given variance.
    using Score = std::function<double(const unsigned int           field,
                                       const std::array<double, 3> &x,
                                       const double                 value,
                                       const double                 variance)>;

    /// @param lattices one per field; correlated fields have equal ones
    /// @param generates false: another rank does; this one has no arrays for
    /// it,
    ///        needs no noise and knows what the fields are, but for what
    ///        description() and warnings() say
    /// @throws UserError "Random fields/..."
    RandomFields(const RandomFieldsParameters    &parameters,
                 const std::vector<FieldLattice> &lattices,
                 const Score                     &score,
                 const bool                       generates = true);
    ~RandomFields();

    /// Standard normal numbers that one realisation needs.
    std::size_t
    n_noise() const
    {
      return total_noise;
    }

    unsigned int
    n_fields() const
    {
      return fields.size();
    }

    const FieldLattice &
    lattice(const unsigned int field) const
    {
      return fields[field].lattice;
    }

    /// gamma: variance of a cell average for unit variance of a point.
    double
    cell_variance(const unsigned int field) const
    {
      return fields[field].gamma;
    }

    /// Variance of a field's scores: 1; if its statistics are those of points
    /// the local part counts gamma times.
    double
    score_variance(const unsigned int field) const
    {
      return fields[field].variance;
    }

    /// For the log: a line per field, with the cells per scale of fluctuation.
    std::vector<std::string>
    description() const;

    /// What is likely not meant: fewer than 4 cells per scale.
    std::vector<std::string>
    warnings() const;

    /// @param noise n_noise() standard normal numbers
    /// @param scores one array per field, one number per cell of its lattice
    /// @param averages one number per field: the share of its average in the
    /// scores, before what varies from cell to cell; 0 if it has none
    /// Uses work space of the object: not for two threads at a time.
    void
    generate(const double                     *noise,
             std::vector<std::vector<double>> &scores,
             std::vector<double>              &averages) const;

  private:
    struct Field
    {
      std::string                     name;
      FieldLattice                    lattice;
      double                          gamma;     // variance of a cell average
      double                          scale;     // of the generator's values
      double                          average;   // standard deviation of it
      double                          variance;  // of the scores
      std::vector<double>             scales;    // of fluctuation, m
      std::unique_ptr<FieldGenerator> generator; // none: nothing is local
      std::unique_ptr<Conditioning>   conditioning; // or none
    };

    std::vector<Field>  fields;
    std::size_t         total_noise = 0;
    bool                mixed       = false;
    std::vector<double> mixing; // lower triangular, n x n, row by row
  };
} // namespace Waker

#endif
