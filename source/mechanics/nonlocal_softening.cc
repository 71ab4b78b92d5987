// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

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


  template <int dim>
  void
  NonlocalSoftening<dim>::gather(const NodeExchange        &ranks,
                                 const MaterialPoints<dim> &points,
                                 const std::vector<double> &increments,
                                 const unsigned int         material)
  {
    // Of each point: place, volume, increment, and its id, rank and own place
    // as doubles, which hold integers up to 2^53.
    constexpr unsigned int n_numbers = dim + 5;
    std::vector<double>    mine;
    const double rank = Utilities::MPI::this_mpi_process(ranks.communicator());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (points.material[p] == material)
        {
          for (unsigned int d = 0; d < dim; ++d)
            mine.push_back(points.position[p][d]);
          for (const double number : {points.volume[p],
                                      increments[p],
                                      static_cast<double>(points.id[p]),
                                      rank,
                                      static_cast<double>(p)})
            mine.push_back(number);
        }
    const std::vector<double>                   all = ranks.all_gather(mine);
    std::vector<std::pair<double, std::size_t>> order; // id, begin
    for (std::size_t k = 0; k < all.size(); k += n_numbers)
      order.emplace_back(all[k + dim + 2], k);
    std::sort(order.begin(), order.end());

    const std::size_t n = order.size();
    around.position.resize(n);
    around.volume.resize(n);
    around.increment.resize(n);
    around.place.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const double *const numbers = all.data() + order[i].second;
        for (unsigned int d = 0; d < dim; ++d)
          around.position[i][d] = numbers[d];
        around.volume[i]    = numbers[dim];
        around.increment[i] = numbers[dim + 1];
        around.place[i]     = numbers[dim + 3] == rank
                                ? static_cast<std::uint32_t>(numbers[dim + 4])
                                : not_here;
      }
  }


  template <int dim>
  void
  NonlocalSoftening<dim>::soften(
    const std::vector<double>           &increments,
    const std::vector<std::vector<int>> &variable_arrays,
    const NodeExchange                  &ranks,
    MaterialPoints<dim>                 &points)
  {
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
            gather(ranks, points, increments, of_material.number);
            members.resize(around.place.size());
            std::iota(members.begin(), members.end(), 0u);
            average.reinit(members,
                           around.position,
                           around.volume,
                           around.increment);
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
