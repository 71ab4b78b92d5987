// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/sliding_masses.h>
#include <waker/measures/two_means.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Waker
{
  namespace
  {
    constexpr char slide_name[]  = "slide";
    constexpr char volume_name[] = "initial volume";


    template <int dim>
    double
    displacement(const MaterialPoints<dim> &points, const std::size_t p)
    {
      return (points.position[p] - points.initial_position[p]).norm();
    }


    /// Is it soil of the start that has not slid yet?
    bool
    is_stable(const double slide, const double volume)
    {
      return slide == 0. && volume > 0.;
    }


    /// The largest displacement of soil that is stable (m).
    template <int dim>
    double
    largest_of_stable(const MaterialPoints<dim> &points)
    {
      const std::vector<double> &slide   = points.scalar(slide_name);
      const std::vector<double> &volumes = points.scalar(volume_name);
      double                     largest = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (is_stable(slide[p], volumes[p]))
          largest = std::max(
            largest,
            (points.position[p] - points.initial_position[p]).norm_square());
      return std::sqrt(largest);
    }


    /// Places in the arrays, by the points' ids.
    template <int dim>
    void
    sort_by_id(const MaterialPoints<dim> &points,
               std::vector<std::size_t>  &places)
    {
      std::sort(places.begin(),
                places.end(),
                [&](const std::size_t a, const std::size_t b) {
                  return points.id[a] < points.id[b];
                });
    }


    /// Total length of intervals, what they have in common once.
    double
    length_of(std::vector<std::pair<double, double>> intervals)
    {
      std::sort(intervals.begin(), intervals.end());
      double length = 0., end = std::numeric_limits<double>::lowest();
      for (const auto &[from, to] : intervals)
        {
          length += std::max(0., to - std::max(from, end));
          end = std::max(end, to);
        }
      return length;
    }


    /// Of points, in the order of their ids.
    template <int dim>
    SlidingMass
    measure(const double                    time,
            const MaterialPoints<dim>      &points,
            const std::vector<double>      &volumes,
            const std::vector<std::size_t> &places)
    {
      SlidingMass mass;
      mass.time = time;
      for (const std::size_t p : places)
        mass.volume += volumes[p];
      for (unsigned int d = 0; d < dim; ++d)
        {
          double sum    = 0.;
          mass.lower[d] = std::numeric_limits<double>::max();
          mass.upper[d] = std::numeric_limits<double>::lowest();
          for (const std::size_t p : places)
            {
              const double x    = points.initial_position[p][d];
              const double half = initial_half_size(points, p)[d];
              sum += volumes[p] * x;
              mass.lower[d] = std::min(mass.lower[d], x - half);
              mass.upper[d] = std::max(mass.upper[d], x + half);
            }
          mass.centre[d] = sum / mass.volume;
        }
      if constexpr (dim == 3)
        {
          std::vector<std::pair<double, double>> intervals;
          intervals.reserve(places.size());
          for (const std::size_t p : places)
            {
              const double z    = points.initial_position[p][2];
              const double half = initial_half_size(points, p)[2];
              intervals.emplace_back(z - half, z + half);
            }
          mass.width = length_of(std::move(intervals));
        }
      return mass;
    }
  } // namespace


  template <int dim>
  SlidingMassFinder<dim>::SlidingMassFinder(const MaterialPoints<dim> &points,
                                            Crest<dim>                 crest,
                                            const double               limit)
    : crest(std::move(crest))
    , limit(limit)
    , whole_volume(0.)
  {
    std::vector<std::size_t> places(points.n_points());
    std::iota(places.begin(), places.end(), std::size_t(0));
    sort_by_id(points, places);
    for (const std::size_t p : places)
      whole_volume += points.volume[p];
  }


  template <int dim>
  const char *
  SlidingMassFinder<dim>::changed_scalar()
  {
    return slide_name;
  }


  template <int dim>
  const char *
  SlidingMassFinder<dim>::volume_scalar()
  {
    return volume_name;
  }


  template <int dim>
  void
  SlidingMassFinder<dim>::start(MaterialPoints<dim> &points)
  {
    points.scalar(slide_name)  = std::vector<double>(points.n_points(), 0.);
    points.scalar(volume_name) = points.volume;
  }


  template <int dim>
  bool
  SlidingMassFinder<dim>::update(const double         time,
                                 const Body<dim>     &body,
                                 MaterialPoints<dim> &points,
                                 SlidingMasses       &sliding) const
  {
    sliding.direction    = crest.direction();
    sliding.whole_volume = whole_volume;
    if (dim == 3 && sliding.masses.empty())
      sliding.damaged_crest_width = 0.;
    sliding.largest_displacement = body.largest(largest_of_stable(body.own()));
    if (!(sliding.largest_displacement > limit))
      return false;

    body.whole(); // `points` know their places
    std::vector<double>       &slide   = points.scalar(slide_name);
    const std::vector<double> &volumes = points.scalar(volume_name);
    std::vector<std::size_t>   stable;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (is_stable(slide[p], volumes[p]))
        stable.push_back(p);
    sort_by_id(points, stable);
    while (sliding.largest_displacement > limit)
      {
        std::vector<double> moved, weights;
        for (const std::size_t p : stable)
          {
            moved.push_back(displacement(points, p));
            weights.push_back(volumes[p]);
          }
        const TwoMeans split = two_means(moved, weights);
        // All by one distance: there are no two parts, and none is stable.
        const bool all = !(split.upper_weight > 0.);

        std::vector<std::size_t> upper, lower;
        double                   rest = 0.;
        for (std::size_t i = 0; i < stable.size(); ++i)
          if (all || moved[i] >= split.threshold)
            upper.push_back(stable[i]);
          else
            {
              lower.push_back(stable[i]);
              rest = std::max(rest, moved[i]);
            }
        sliding.masses.push_back(measure(time, points, volumes, upper));
        sliding.failed_volume += sliding.masses.back().volume;
        for (const std::size_t p : upper)
          slide[p] = static_cast<double>(sliding.masses.size());
        stable                       = std::move(lower);
        sliding.largest_displacement = rest;
      }

    std::vector<bool> flags(points.n_points(), false);
    for (const std::size_t p : stable)
      flags[p] = true;
    const CrestDamage damage    = crest.damage(points, flags);
    sliding.retrogression       = damage.retrogression;
    sliding.damaged_crest_width = damage.width;
    return true;
  }


  template class SlidingMassFinder<2>;
  template class SlidingMassFinder<3>;
} // namespace Waker
