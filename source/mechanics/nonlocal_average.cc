// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/nonlocal_average.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    /// exp(-s) for 0 <= s <= 6.25, to 2e-6: the eighth power of a polynomial
    /// for exp(-s/8) (a minimax fit), in instructions that vectorise.
    inline float
    decay(const float s)
    {
      const float t = 0.125f * s;
      const float p =
        1.f + t * (-0.9999910360f +
                   t * (0.4998472875f +
                        t * (-0.1657982967f +
                             t * (0.03945125325f - t * 0.005649571274f))));
      const float p2 = p * p;
      const float p4 = p2 * p2;
      return p4 * p4;
    }


    /// To 20 binary digits: the order in which a sum was made does not matter
    /// any more.
    double
    rounded(const double x)
    {
      int          exponent;
      const double mantissa = std::frexp(x, &exponent);
      return std::ldexp(std::round(std::ldexp(mantissa, 20)), exponent - 20);
    }
  } // namespace


  template <int dim>
  NonlocalAverage<dim>::NonlocalAverage(const double          length,
                                        const NeighbourWeight weight)
    : length(length)
    , weight(weight)
  {
    Assert(length > 0., ExcMessage("the averaging length is not above 0"));
  }


  template <int dim>
  typename NonlocalAverage<dim>::Extent
  NonlocalAverage<dim>::extent_of(const std::vector<std::uint32_t> &members,
                                  const std::vector<Point<dim>>    &positions,
                                  const std::vector<double>        &volumes)
  {
    Extent extent;
    for (unsigned int d = 0; d < dim; ++d)
      {
        extent.low[d]  = std::numeric_limits<double>::max();
        extent.high[d] = std::numeric_limits<double>::lowest();
      }
    extent.n = static_cast<double>(members.size());
    for (const std::uint32_t p : members)
      {
        extent.volume += volumes[p];
        for (unsigned int d = 0; d < dim; ++d)
          {
            extent.low[d]  = std::min(extent.low[d], positions[p][d]);
            extent.high[d] = std::max(extent.high[d], positions[p][d]);
          }
      }
    return extent;
  }


  template <int dim>
  void
  NonlocalAverage<dim>::reinit(const std::vector<std::uint32_t> &members,
                               const std::vector<Point<dim>>    &positions,
                               const std::vector<double>        &volumes,
                               const std::vector<double>        &values,
                               const Extent                     &all)
  {
    lay_bins(all);
    sort(members, positions);

    const std::size_t n = members.size();
    // Beyond the end there is nothing, far away: loops may run over it.
    for (auto &x : place)
      x.assign(n + n_lanes, 0.f);
    volume.assign(n + n_lanes, 0.f);
    content.assign(n + n_lanes, 0.f);
    value.resize(n);
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::uint32_t p = sorted[k];
        for (unsigned int d = 0; d < dim; ++d)
          place[d][k] = (positions[p][d] - corner[d]) / length;
        volume[k]  = volumes[p] / mean_volume;
        value[k]   = values[p];
        content[k] = volume[k] * static_cast<float>(value[k]);
      }
    n_sources.resize(starts.size());
    unsigned int n_before = 0, k = 0;
    for (std::size_t b = 0; b < starts.size(); ++b)
      {
        for (; k < starts[b]; ++k)
          n_before += value[k] != 0.;
        n_sources[b] = n_before;
      }
  }


  template <int dim>
  double
  NonlocalAverage<dim>::lay_bins(const Extent &all)
  {
    Point<dim> low = all.low, high = all.high;
    if (all.n == 0.)
      low = high = Point<dim>();
    corner = low;

    // Bins as large as points, but not much smaller than the reach; not many
    // more than points either, if these lie scattered.
    const double n = std::max(all.n, 1.);
    mean_volume    = all.volume > 0. ? rounded(all.volume / n) : 1.;
    bin_size = std::max(0.1 * reach, std::pow(mean_volume, 1. / dim) / length);
    while (true)
      {
        double n_all = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          n_all *= std::floor((high[d] - low[d]) / (length * bin_size)) + 1.;
        if (n_all <= 8. * n + 64.)
          break;
        bin_size *= 1.25;
      }
    for (unsigned int d = 0; d < dim; ++d)
      n_of_all[d] =
        static_cast<int>((high[d] - low[d]) / (length * bin_size)) + 1;
    // Places are floats.
    const double extent = (high - low).norm();
    return length * (reach + bin_size) + 1e-6 * extent;
  }


  template <int dim>
  void
  NonlocalAverage<dim>::sort(const std::vector<std::uint32_t> &members,
                             const std::vector<Point<dim>>    &positions)
  {
    const double inverse = 1. / (length * bin_size);
    const auto   bin_at  = [&](const double x, const unsigned int d) {
      return std::min(static_cast<int>((x - corner[d]) * inverse),
                      n_of_all[d] - 1);
    };
    // Those of the members, which on several ranks are a part of all.
    Point<dim> low, high;
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        const Point<dim> &x = positions[members[i]];
        for (unsigned int d = 0; d < dim; ++d)
          {
            low[d]  = i == 0 ? x[d] : std::min(low[d], x[d]);
            high[d] = i == 0 ? x[d] : std::max(high[d], x[d]);
          }
      }
    unsigned int n_all = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        first_bin[d] = members.empty() ? 0 : bin_at(low[d], d);
        n_bins[d] = members.empty() ? 1 : bin_at(high[d], d) + 1 - first_bin[d];
        n_all *= n_bins[d];
      }

    bin_of.resize(members.size());
    starts.assign(n_all + 1, 0);
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        const Point<dim> &x   = positions[members[i]];
        unsigned int      bin = 0;
        for (int d = dim - 1; d >= 0; --d)
          bin = bin * n_bins[d] + (bin_at(x[d], d) - first_bin[d]);
        bin_of[i] = bin;
        ++starts[bin + 1];
      }
    for (unsigned int b = 0; b < n_all; ++b)
      starts[b + 1] += starts[b];
    cursor.assign(starts.begin(), starts.end() - 1);
    sorted.resize(members.size());
    for (std::size_t i = 0; i < members.size(); ++i)
      sorted[cursor[bin_of[i]]++] = members[i];
  }


  template <int dim>
  bool
  NonlocalAverage<dim>::find_stretches(const unsigned int k) const
  {
    stretches.clear();
    const double inverse = 1. / bin_size;
    // From the first one that has members.
    const auto bin = [&](const double x, const unsigned int d) {
      return std::min(
        std::max(static_cast<int>(std::floor(x * inverse)) - first_bin[d], 0),
        n_bins[d] - 1);
    };
    // How far a row of bins is from the point, in one direction.
    const auto distance =
      [&](const int place, const unsigned int d, const double x) {
        const int row = first_bin[d] + place;
        return std::max({row * bin_size - x, x - (row + 1) * bin_size, 0.});
      };
    const double x = place[0][k], y = place[1][k], z = place[dim - 1][k];
    bool         has_sources = false;
    for (int i_z = dim == 3 ? bin(z - reach, 2) : 0;
         i_z <= (dim == 3 ? bin(z + reach, 2) : 0);
         ++i_z)
      {
        const double in_z = dim == 3 ? distance(i_z, 2, z) : 0.;
        for (int i_y = bin(y - reach, 1); i_y <= bin(y + reach, 1); ++i_y)
          {
            const double in_y   = distance(i_y, 1, y);
            const double square = reach * reach - in_y * in_y - in_z * in_z;
            if (square <= 0.)
              continue;
            const double       half = std::sqrt(square);
            const unsigned int row  = (i_z * n_bins[1] + i_y) * n_bins[0];
            const unsigned int from = row + bin(x - half, 0),
                               to   = row + bin(x + half, 0) + 1;
            if (starts[from] < starts[to])
              stretches.push_back({starts[from], starts[to]});
            has_sources = has_sources || n_sources[from] < n_sources[to];
          }
      }
    return has_sources;
  }


  template <int dim>
  template <NeighbourWeight weight_function>
  double
  NonlocalAverage<dim>::average(const unsigned int k) const
  {
    constexpr float square_of_reach  = reach * reach;
    float           weights[n_lanes] = {}, contents[n_lanes] = {};
    const float     x = place[0][k], y = place[1][k], z = place[dim - 1][k];
    for (const Stretch &stretch : stretches)
      for (unsigned int begin = stretch.begin; begin < stretch.end;
           begin += n_lanes)
        {
          const float *const x_q = place[0].data() + begin;
          const float *const y_q = place[1].data() + begin;
          const float *const z_q = place[dim - 1].data() + begin;
          const float *const v_q = volume.data() + begin;
          const float *const c_q = content.data() + begin;
          const unsigned int n   = stretch.end - begin;
#pragma GCC ivdep
          for (unsigned int l = 0; l < n_lanes; ++l)
            {
              const float dx = x_q[l] - x, dy = y_q[l] - y,
                          dz = dim == 3 ? z_q[l] - z : 0.f;
              const float s  = dx * dx + dy * dy + dz * dz;
              const float in = s < square_of_reach && l < n ? 1.f : 0.f;
              const float t  = std::min(s, square_of_reach);
              const float w =
                weight_function == NeighbourWeight::galavi_schweiger
                  ? in * std::sqrt(t) * decay(t)
                  : in * decay(t);
              weights[l] += w * v_q[l];
              contents[l] += w * c_q[l];
            }
        }
    double weight_sum = 0., content_sum = 0.;
    for (unsigned int l = 0; l < n_lanes; ++l)
      {
        weight_sum += weights[l];
        content_sum += contents[l];
      }
    return weight_sum > 0. ? content_sum / weight_sum : value[k];
  }


  template <int dim>
  double
  NonlocalAverage<dim>::at(const unsigned int k) const
  {
    if (!find_stretches(k))
      return 0.;
    switch (weight)
      {
        case NeighbourWeight::galavi_schweiger:
          return average<NeighbourWeight::galavi_schweiger>(k);
        case NeighbourWeight::gaussian:
          return average<NeighbourWeight::gaussian>(k);
      }
    return 0.;
  }


  template class NonlocalAverage<2>;
  template class NonlocalAverage<3>;
} // namespace Waker
