// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/driven_loads.h>
#include <waker/loads/point_force.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// Number of the load of that name; there is one.
    template <typename Load>
    std::size_t
    number_of(const std::string &name, const std::vector<Load> &loads)
    {
      return std::find_if(loads.begin(),
                          loads.end(),
                          [&](const Load &load) { return load.name == name; }) -
             loads.begin();
    }


    template <int dim>
    class WeightDriver : public LoadDriver<dim>
    {
    public:
      explicit WeightDriver(const LoadProgrammeParameters &programme)
        : programme(programme)
      {}

      void
      drive(const double            factor,
            const double            now,
            const DrivenScene<dim> &scene) override
      {
        // What is mass of the points already weighs by itself.
        const double in_mass =
          programme.weight.mass == LoadMass::with_mass ? now : 0.;
        add_weight(carried_load(programme, scene.points),
                   factor - in_mass,
                   scene.weights,
                   scene.force);
      }

    private:
      const LoadProgrammeParameters programme;
    };


    template <int dim>
    class TractionDriver : public LoadDriver<dim>
    {
    public:
      explicit TractionDriver(const std::size_t number)
        : number(number)
      {}

      void
      drive(const double factor,
            const double,
            const DrivenScene<dim> &scene) override
      {
        scene.tractions.set_factor(number, factor);
      }

    private:
      const std::size_t number;
    };


    template <int dim>
    class PointLoadDriver : public LoadDriver<dim>
    {
    public:
      PointLoadDriver(const LoadProgrammeParameters &programme,
                      const PointLoadParameters     &parameters)
        : programme(programme)
      {
        for (unsigned int d = 0; d < dim; ++d)
          force[d] = parameters.force[d];
      }

      void
      drive(const double factor,
            const double,
            const DrivenScene<dim> &scene) override
      {
        const std::vector<double> &share =
          carried_load(programme, scene.points);
        for (std::size_t p = 0; p < share.size(); ++p)
          if (share[p] != 0.)
            add_point_force(scene.weights.background_grid(),
                            scene.points.position[p],
                            factor * share[p] * force,
                            scene.force);
      }

    private:
      const LoadProgrammeParameters programme;
      Tensor<1, dim>                force; // kN
    };


    template <int dim>
    class WaterDriver : public LoadDriver<dim>
    {
    public:
      void
      drive(const double factor,
            const double,
            const DrivenScene<dim> &scene) override
      {
        scene.water.set_added_rise(factor);
      }
    };


    template <int dim>
    std::unique_ptr<LoadDriver<dim>>
    make_driver(const LoadProgrammeParameters &programme,
                const Parameters              &parameters)
    {
      switch (programme.drives)
        {
          case LoadTarget::weight:
            return std::make_unique<WeightDriver<dim>>(programme);
          case LoadTarget::traction:
            return std::make_unique<TractionDriver<dim>>(
              number_of(programme.load, parameters.tractions));
          case LoadTarget::point_load:
            return std::make_unique<PointLoadDriver<dim>>(
              programme,
              parameters.point_loads[number_of(programme.load,
                                               parameters.point_loads)]);
          case LoadTarget::water:
            return std::make_unique<WaterDriver<dim>>();
        }
      Assert(false, ExcInternalError());
      return {};
    }
  } // namespace


  template <int dim>
  DrivenLoads<dim>::DrivenLoads(const LoadProgrammes<dim> &programmes,
                                const Parameters          &parameters)
    : programmes(&programmes)
  {
    for (const LoadProgrammeParameters &programme : parameters.load_programmes)
      drivers.push_back(make_driver<dim>(programme, parameters));
  }


  template <int dim>
  void
  DrivenLoads<dim>::drive(const std::vector<LoadRecord> &records,
                          const double                   time,
                          const DrivenScene<dim>        &scene)
  {
    AssertDimension(records.size(), drivers.size());
    for (std::size_t i = 0; i < drivers.size(); ++i)
      drivers[i]->drive(programmes->list()[i].factor(records[i], time),
                        records[i].factor,
                        scene);
  }


  template class DrivenLoads<2>;
  template class DrivenLoads<3>;
} // namespace Waker
