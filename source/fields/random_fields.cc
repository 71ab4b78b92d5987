// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/fields/conditioning.h>
#include <waker/fields/measurements.h>
#include <waker/fields/random_fields.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// With fewer cells per scale of fluctuation the log has a warning.
    constexpr double fewest_cells = 4.;


    /// Lower triangular L with L L^T = matrix (n x n, row by row), which may be
    /// singular: fields may be fully correlated.
    std::vector<double>
    mixing_matrix(const std::vector<double> &matrix, const std::size_t n)
    {
      constexpr double    round_off = 1e-12;
      std::vector<double> L(n * n, 0.);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = j; i < n; ++i)
          {
            double rest = matrix[i * n + j];
            for (std::size_t k = 0; k < j; ++k)
              rest -= L[i * n + k] * L[j * n + k];
            const bool impossible =
              i == j ? rest < -round_off
                     : L[j * n + j] == 0. && std::abs(rest) > round_off;
            if (impossible)
              throw UserError("Random fields/Correlations",
                              "are not those of any set of numbers",
                              "a positive semidefinite correlation matrix");
            if (i == j)
              L[i * n + i] = rest > round_off ? std::sqrt(rest) : 0.;
            else
              L[i * n + j] = L[j * n + j] > 0. ? rest / L[j * n + j] : 0.;
          }
      return L;
    }


    /// Cells so much larger than the field's scales average it to nothing, and
    /// their correlation is beyond double precision.
    void
    check_scales(const RandomFieldParameters &field,
                 const FieldLattice          &lattice,
                 const std::string           &path)
    {
      constexpr double most = 1e6; // cell by scale
      for (unsigned int d = 0; d < lattice.dim; ++d)
        if (!(lattice.cell_size[d] <= most * field.scales[d]))
          {
            std::ostringstream problem, allowed;
            problem << "contains " << field.scales[d]
                    << " m, but the field's cells are " << lattice.cell_size[d]
                    << " m long along "
                    << "xyz"[d];
            allowed << "at least " << lattice.cell_size[d] / most << " m";
            throw UserError(path + "/Scales of fluctuation",
                            problem.str(),
                            allowed.str());
          }
    }
  } // namespace


  RandomFields::RandomFields(const RandomFieldsParameters    &parameters,
                             const std::vector<FieldLattice> &lattices,
                             const Score                     &score,
                             const bool                       generates)
  {
    const std::size_t n = parameters.fields.size();
    for (std::size_t f = 0; f < n; ++f)
      {
        const RandomFieldParameters &p        = parameters.fields[f];
        const std::string            path     = "Random fields/" + p.name;
        const bool                   is_local = p.local_share > 0.;
        if (is_local)
          check_scales(p, lattices[f], path);
        const Correlation correlation(p.correlation, p.scales);
        const bool        of_cells = p.statistics == FieldStatistics::cells;
        Field             field;
        field.name    = p.name;
        field.lattice = lattices[f];
        field.gamma =
          is_local ? correlation.between_cells(lattices[f].cell_size, {}) : 1.;
        const double of_average = 1. - p.local_share;
        const double of_field   = p.local_share * (of_cells ? 1. : field.gamma);
        field.scale = (of_cells ? 1. / std::sqrt(field.gamma) : 1.) *
                      std::sqrt(p.local_share);
        field.average  = std::sqrt(of_average);
        field.variance = of_average + of_field;
        field.scales   = p.scales;
        if (is_local && generates)
          {
            field.generator =
              make_field_generator(p.generator, lattices[f], correlation, path);
            total_noise += field.generator->n_noise();
          }

        if (!p.measurements.empty() && generates)
          {
            std::vector<MeasuredScore> measured;
            for (const Measurement &m :
                 read_measurements(p.measurements, lattices[f]))
              measured.push_back(
                {m.cell, score(f, m.position, m.value, field.variance)});
            field.conditioning = std::make_unique<Conditioning>(
              lattices[f],
              correlation,
              measured,
              of_field,
              p.measurement_error * p.measurement_error * field.variance,
              path,
              of_average);
            total_noise += field.conditioning->n_noise();
          }
        fields.push_back(std::move(field));
      }
    // The averages come last: with and without them the fields are the same.
    if (generates)
      for (const Field &field : fields)
        total_noise += field.average > 0. ? 1 : 0;

    mixing = mixing_matrix(parameters.correlation_matrix(), n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        mixed = mixed || mixing[i * n + j] != 0.;
  }


  RandomFields::~RandomFields() = default;


  std::vector<std::string>
  RandomFields::description() const
  {
    std::vector<std::string> lines;
    for (const Field &field : fields)
      {
        std::ostringstream text;
        text << "Random field \"" << field.name << "\": ";
        if (field.generator)
          {
            text << field.generator->description() << std::setprecision(3);
            for (unsigned int d = 0; d < field.lattice.dim; ++d)
              text << (d > 0 ? " x " : ", ")
                   << field.scales[d] / field.lattice.cell_size[d];
            text << " cells per scale of fluctuation";
            if (field.average > 0.)
              text << "; " << field.average * field.average
                   << " of the variance is that of the average";
          }
        else
          text << "one number per realisation";
        if (field.conditioning)
          text << ", " << field.conditioning->description();
        lines.push_back(text.str());
      }
    return lines;
  }


  std::vector<std::string>
  RandomFields::warnings() const
  {
    std::vector<std::string> lines;
    for (const Field &field : fields)
      {
        if (!field.generator)
          continue;
        std::ostringstream few;
        for (unsigned int d = 0; d < field.lattice.dim; ++d)
          if (field.scales[d] / field.lattice.cell_size[d] <
              fewest_cells * (1. - 1e-9))
            few << (few.tellp() > 0 ? " and " : "") << "xyz"[d];
        if (few.tellp() > 0)
          lines.push_back("Random fields/" + field.name +
                          ": fewer than 4 cells per scale of fluctuation "
                          "along " +
                          few.str() +
                          ": averages over such cells lose what varies within "
                          "a scale; smaller cells would keep it");
      }
    return lines;
  }


  void
  RandomFields::generate(const double                     *noise,
                         std::vector<std::vector<double>> &scores,
                         std::vector<double>              &averages) const
  {
    const std::size_t n = fields.size();
    scores.resize(n);
    averages.assign(n, 0.);
    const double *of_average = noise + total_noise;
    for (std::size_t f = n; f-- > 0;)
      if (fields[f].average > 0.)
        averages[f] = fields[f].average * *--of_average;

    for (std::size_t f = 0; f < n; ++f)
      {
        const Field &field = fields[f];
        scores[f].assign(field.lattice.n(), averages[f]);
        if (field.generator)
          {
            field.generator->generate(noise, scores[f].data());
            noise += field.generator->n_noise();
            if (field.scale != 1.)
              for (double &value : scores[f])
                value *= field.scale;
            if (field.average > 0.)
              for (double &value : scores[f])
                value += averages[f];
          }
        if (field.conditioning)
          {
            averages[f] += field.conditioning->apply(noise, scores[f].data());
            noise += field.conditioning->n_noise();
          }
      }

    // The last field first: it needs those before it as they are.
    if (mixed)
      for (std::size_t i = n; i-- > 0;)
        {
          const double own = mixing[i * n + i];
          for (double &value : scores[i])
            value *= own;
          averages[i] *= own;
          for (std::size_t j = 0; j < i; ++j)
            if (mixing[i * n + j] != 0.)
              {
                for (std::size_t c = 0; c < scores[i].size(); ++c)
                  scores[i][c] += mixing[i * n + j] * scores[j][c];
                averages[i] += mixing[i * n + j] * averages[j];
              }
        }
  }
} // namespace Waker
