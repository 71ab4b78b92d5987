// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_driven_loads_h
#define waker_case_driven_loads_h

#include <waker/case/load_programmes.h>
#include <waker/loads/tractions.h>
#include <waker/loads/water_load.h>
#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_state.h>

#include <memory>
#include <vector>

namespace Waker
{
  /// What a load programme can drive in a scene.
  template <int dim>
  struct DrivenScene
  {
    const MaterialPoints<dim> &points; // on several ranks those of this one
    const Weights<dim>        &weights;
    NodalVector               &force; // of their nodes, kN
    Tractions<dim>            &tractions;
    WaterLoad<dim>            &water;
  };


  /// What the factor of one programme drives: a case of LoadTarget.
  template <int dim>
  class LoadDriver
  {
  public:
    virtual ~LoadDriver() = default;

    /// Add a load to the forces, or tell those who will.
    /// @param now the factor up to which the state has come: the points have
    ///        the mass of that
    virtual void
    drive(const double            factor,
          const double            now,
          const DrivenScene<dim> &scene) = 0;
  };


  /// What the load programmes of a case drive in a scene: work space.
  template <int dim>
  class DrivenLoads
  {
  public:
    /// @param programmes must outlive this object
    DrivenLoads(const LoadProgrammes<dim> &programmes,
                const Parameters          &parameters);

    /// The loads of the programmes at a time (s) of the step that begins with
    /// these records. Comes before water and tractions add theirs.
    void
    drive(const std::vector<LoadRecord> &records,
          const double                   time,
          const DrivenScene<dim>        &scene);

    bool
    empty() const
    {
      return drivers.empty();
    }

  private:
    const LoadProgrammes<dim>                    *programmes;
    std::vector<std::unique_ptr<LoadDriver<dim>>> drivers; // one each
  };
} // namespace Waker

#endif
