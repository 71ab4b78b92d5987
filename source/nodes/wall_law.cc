// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/wall_law.h>

namespace Waker
{
  namespace
  {
    template <int dim>
    Tensor<1, dim>
    along_wall(const Tensor<1, dim> &v, const Tensor<1, dim> &normal)
    {
      return v - (v * normal) * normal;
    }


    template <int dim>
    Tensor<2, dim>
    identity()
    {
      Tensor<2, dim> one;
      for (unsigned int d = 0; d < dim; ++d)
        one[d][d] = 1.;
      return one;
    }
  } // namespace


  /// Of a frictional wall.
  template <int dim>
  struct WallLaw<dim>::Trial
  {
    double         pressure; // < 0: none, the gap is open
    Tensor<1, dim> shear;    // if it sticks
    double         length;   // of the shear
    double         limit;    // of the length

    bool
    touches() const
    {
      return pressure >= 0.;
    }

    bool
    slides() const
    {
      return length > limit;
    }
  };


  template <int dim>
  typename WallLaw<dim>::Trial
  WallLaw<dim>::trial(const Start &start, const Tensor<1, dim> &w) const
  {
    const Tensor<1, dim> stuck = start.traction - stiffness * w;
    Trial                trial;
    trial.pressure = stuck * start.normal - stiffness * start.gap;
    trial.shear    = along_wall(stuck, start.normal);
    trial.length   = trial.shear.norm();
    trial.limit    = friction * trial.pressure + adhesion;
    return trial;
  }


  template <int dim>
  Tensor<1, dim>
  WallLaw<dim>::traction(const Start &start, const Tensor<1, dim> &w) const
  {
    switch (type)
      {
        case WallType::rough:
          return start.traction - stiffness * w;
        case WallType::smooth:
          return start.traction - stiffness * (w * start.normal) * start.normal;
        case WallType::frictional:
          {
            const Trial t = trial(start, w);
            if (!t.touches())
              break;
            return t.pressure * start.normal +
                   (t.slides() ? t.limit / t.length : 1.) * t.shear;
          }
      }
    return Tensor<1, dim>();
  }


  template <int dim>
  Tensor<2, dim>
  WallLaw<dim>::derivative(const Start &start, const Tensor<1, dim> &w) const
  {
    const Tensor<2, dim> one = identity<dim>();
    const Tensor<2, dim> nn  = outer_product(start.normal, start.normal);
    switch (type)
      {
        case WallType::rough:
          return stiffness * one;
        case WallType::smooth:
          return stiffness * nn;
        case WallType::frictional:
          {
            const Trial t = trial(start, w);
            if (!t.touches())
              break;
            if (!t.slides())
              return stiffness * one;
            const Tensor<1, dim> m = t.shear / t.length;
            return stiffness *
                   (nn + friction * outer_product(m, start.normal) +
                    t.limit / t.length * (one - nn - outer_product(m, m)));
          }
      }
    return Tensor<2, dim>();
  }


  template <int dim>
  bool
  WallLaw<dim>::slides(const Start &start, const Tensor<1, dim> &w) const
  {
    if (type != WallType::frictional || friction == 0.)
      return false;
    const Trial t = trial(start, w);
    return t.touches() && t.slides();
  }


  template <int dim>
  double
  WallLaw<dim>::dissipation(const Start &start, const Tensor<1, dim> &w) const
  {
    if (type != WallType::frictional)
      return 0.;
    const Trial t = trial(start, w);
    if (!t.touches() || !t.slides())
      return 0.;
    return t.limit * (t.length - t.limit) / stiffness;
  }


  template struct WallLaw<2>;
  template struct WallLaw<3>;
} // namespace Waker
