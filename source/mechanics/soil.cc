// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/point_stiffness.h>
#include <waker/mechanics/soil.h>

#include <utility>

namespace Waker
{
  template <int dim>
  Soil<dim>::Soil(const Weights<dim> &weights,
                  StressUpdate<dim>   stress_update,
                  const Tangent       tangent)
    : weights(&weights)
    , stress_update(std::move(stress_update))
    , tangent(std::in_place_type<ConsistentTangent<dim>>, weights)
    , reached(weights.background_grid())
    , work_space(weights.background_grid().n_dofs())
  {
    switch (tangent)
      {
        case Tangent::consistent:
          break;
        case Tangent::double_mapping:
          this->tangent.template emplace<DoubleMappedTangent<dim>>(weights);
          break;
      }
  }


  template <int dim>
  void
  Soil<dim>::begin(const MaterialPoints<dim> &points,
                   const NodalState          &nodes,
                   const double,
                   const double)
  {
    this->points = &points;
    reached.reinit(nodes.mass);
    stress_update.begin(points, *weights);
  }


  template <int dim>
  void
  Soil<dim>::add_force(const NodalVector &increment, NodalVector &internal)
  {
    reached.ranks().together([&]() {
      stress_update.evaluate(*points, *weights, increment, work_space);
    });
    internal += work_space;
  }


  template <int dim>
  void
  Soil<dim>::add_start_force(NodalVector &internal)
  {
    stress_update.point_motion().add_force_of_stress(*points,
                                                     *weights,
                                                     internal);
  }


  template <int dim>
  void
  Soil<dim>::linearise()
  {
    std::visit([&](auto &t) { t.reinit(stress_update, *points); }, tangent);
  }


  template <int dim>
  const Operator &
  Soil<dim>::stiffness() const
  {
    return std::visit([](const auto &t) -> const Operator & { return t; },
                      tangent);
  }


  template <int dim>
  void
  Soil<dim>::vmult_add(NodalVector &dst, const NodalVector &src) const
  {
    stiffness().vmult(work_space, src);
    double *const       y = dst.begin();
    const double *const f = work_space.begin();
    for (const auto &run : reached)
      for (std::size_t i = dim * run.begin; i < dim * run.end; ++i)
        y[i] += f[i];
  }


  template <int dim>
  void
  Soil<dim>::add_diagonal(NodalVector &diagonal) const
  {
    stiffness().add_diagonal(diagonal);
  }


  template <int dim>
  void
  Soil<dim>::add_entries(MatrixEntries &entries) const
  {
    add_point_stiffness(stress_update, *points, *weights, entries);
  }


  template <int dim>
  bool
  Soil<dim>::is_symmetric() const
  {
    return stiffness().is_symmetric();
  }


  template <int dim>
  Tensor<1, dim>
  Soil<dim>::accept(const NodalVector &, MaterialPoints<dim> &points)
  {
    stress_report = stress_update.accept(points);
    stress_update.soften(points, weights->background_grid());
    return Tensor<1, dim>(); // it holds nothing
  }


  template <int dim>
  ResistanceWork
  Soil<dim>::work(const NodalVector &) const
  {
    return {-stress_report.work_start, -stress_report.work_end};
  }


  template class Soil<2>;
  template class Soil<3>;
} // namespace Waker
