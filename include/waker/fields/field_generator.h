// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_field_generator_h
#define waker_fields_field_generator_h

#include <waker/fields/correlation.h>
#include <waker/fields/lattice.h>

#include <memory>
#include <string>

namespace Waker
{
  /// How a field is made of white noise.
  enum class Generator
  {
    circulant_embedding,
    local_average_subdivision,
    cholesky
  };

  constexpr const char *
  name_of(const Generator choice)
  {
    switch (choice)
      {
        case Generator::circulant_embedding:
          return "circulant embedding";
        case Generator::local_average_subdivision:
          return "local average subdivision";
        case Generator::cholesky:
          return "Cholesky";
      }
    return nullptr;
  }


  /**
   * Turns white noise into the cell averages of a stationary Gaussian field of
   * zero mean and unit *point* variance. Linear in the noise, and nothing but a
   * function of it.
   */
  class FieldGenerator
  {
  public:
    virtual ~FieldGenerator() = default;

    /// Standard normal numbers that one field needs.
    virtual std::size_t
    n_noise() const = 0;

    /// @param noise n_noise() numbers
    /// @param values the field, one number per cell of the lattice
    /// Uses work space of the generator: not for two threads at a time.
    virtual void
    generate(const double *noise, double *values) const = 0;

    /// One line for the log: "circulant embedding on 480 x 96 cells".
    virtual std::string
    description() const = 0;
  };

  /**
   * @param path "Random fields/strength", for errors
   * @throws UserError the lattice or correlation is nothing for this method
   */
  std::unique_ptr<FieldGenerator>
  make_field_generator(const Generator     method,
                       const FieldLattice &lattice,
                       const Correlation  &correlation,
                       const std::string  &path);
} // namespace Waker

#endif
