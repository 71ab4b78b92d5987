// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/near_cells.h>
#include <waker/mechanics/nonlocal_softening.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace Waker
{
  template <int dim>
  NonlocalSoftening<dim>::NonlocalSoftening(
    const std::vector<std::unique_ptr<Material>> &materials)
  {
    for (unsigned int m = 0; m < materials.size(); ++m)
      {
        const SofteningMeasure measure = materials[m]->softening_measure();
        if (!measure.is_local())
          averages.push_back(
            {m,
             materials[m].get(),
             measure,
             NonlocalAverage<dim>(measure.length, measure.weight)});
      }
  }


  namespace
  {
    /// What a rank is told of a point.
    template <int dim>
    struct Told
    {
      std::array<double, dim> position;
      double                  volume, increment;
      std::uint64_t           id;
      std::uint64_t           place; // of an own one
    };


    /// That of all ranks.
    template <int dim>
    typename NonlocalAverage<dim>::Extent
    of_all(typename NonlocalAverage<dim>::Extent extent,
           const NodeExchange                   &ranks)
    {
      double ends[2 * dim], sums[] = {extent.volume, extent.n};
      for (unsigned int d = 0; d < dim; ++d)
        {
          ends[d]       = -extent.low[d];
          ends[dim + d] = extent.high[d];
        }
      ranks.largest(ends, 2 * dim);
      ranks.sum(sums, 2);
      for (unsigned int d = 0; d < dim; ++d)
        {
          extent.low[d]  = -ends[d];
          extent.high[d] = ends[dim + d];
        }
      extent.volume = sums[0];
      extent.n      = sums[1];
      return extent;
    }
  } // namespace


  template <int dim>
  void
  NonlocalSoftening<dim>::gather(const BackgroundGrid<dim> &grid,
                                 const double               reach,
                                 const MaterialPoints<dim> &points,
                                 const std::vector<double> &increments,
                                 const unsigned int         material)
  {
    const auto tell = [&](const std::size_t p, Told<dim> &told) {
      if (points.material[p] != material)
        return false;
      for (unsigned int d = 0; d < dim; ++d)
        told.position[d] = points.position[p][d];
      told.volume    = points.volume[p];
      told.increment = increments[p];
      told.id        = points.id[p];
      told.place     = not_here;
      return true;
    };
    std::vector<Told<dim>> all =
      grid.near_cells().template gather<Told<dim>>(points.position,
                                                   reach,
                                                   tell);
    for (const std::uint32_t p : members)
      {
        all.emplace_back();
        tell(p, all.back());
        all.back().place = p;
      }
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return a.id < b.id;
    });

    const std::size_t n = all.size();
    around.position.resize(n);
    around.volume.resize(n);
    around.increment.resize(n);
    around.place.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        for (unsigned int d = 0; d < dim; ++d)
          around.position[i][d] = all[i].position[d];
        around.volume[i]    = all[i].volume;
        around.increment[i] = all[i].increment;
        around.place[i]     = static_cast<std::uint32_t>(all[i].place);
      }
  }


  template <int dim>
  void
  NonlocalSoftening<dim>::soften(
    const std::vector<double>           &increments,
    const std::vector<std::vector<int>> &variable_arrays,
    const BackgroundGrid<dim>           &grid,
    MaterialPoints<dim>                 &points)
  {
    const NodeExchange &ranks    = grid.exchange();
    const bool          on_ranks = !ranks.is_one_rank();
    std::vector<double> variables;
    for (MaterialAverage &of_material : averages)
      {
        members.clear();
        bool any = false;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          if (points.material[p] == of_material.number)
            {
              members.push_back(p);
              any = any || increments[p] != 0.;
            }
        if (ranks.largest(any ? 1. : 0.) == 0.)
          continue;
        NonlocalAverage<dim> &average = of_material.average;
        if (on_ranks)
          {
            const auto all = of_all<dim>(average.extent_of(members,
                                                           points.position,
                                                           points.volume),
                                         ranks);
            gather(grid,
                   average.lay_bins(all),
                   points,
                   increments,
                   of_material.number);
            members.resize(around.place.size());
            std::iota(members.begin(), members.end(), 0u);
            average.reinit(
              members, around.position, around.volume, around.increment, all);
          }
        else
          average.reinit(members, points.position, points.volume, increments);

        std::vector<double *> arrays;
        for (const int array : variable_arrays[of_material.number])
          arrays.push_back(points.scalars[array].values.data());
        variables.resize(arrays.size());
        for (unsigned int k = 0; k < average.order().size(); ++k)
          {
            const std::uint32_t member = average.order()[k];
            const std::uint32_t p = on_ranks ? around.place[member] : member;
            if (p == not_here)
              continue;
            for (unsigned int v = 0; v < arrays.size(); ++v)
              variables[v] = arrays[v][p];
            if (!of_material.material->can_soften(variables.data()))
              continue;
            const double increment =
              of_material.measure.own * increments[p] +
              of_material.measure.averaged * average.at(k);
            if (increment == 0.)
              continue;
            of_material.material->soften(increment, variables.data());
            for (unsigned int v = 0; v < arrays.size(); ++v)
              arrays[v][p] = variables[v];
          }
      }
  }


  template class NonlocalSoftening<2>;
  template class NonlocalSoftening<3>;
} // namespace Waker
