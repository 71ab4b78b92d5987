// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_mapping_lattice_h
#define waker_tests_mapping_lattice_h

#include <waker/mapping/stencil.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/particles/material_points.h>

#include <cmath>
#include <random>

/// Small bodies and random numbers for the tests of mapping and mechanics.
namespace Lattice
{
  using namespace Waker;

  /// Random numbers that are the same on every machine.
  class Random
  {
  public:
    explicit Random(const unsigned int seed)
      : engine(seed)
    {}

    /// Uniform in [a, b).
    double
    operator()(const double a, const double b)
    {
      return a + (b - a) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }

    template <int dim>
    Tensor<1, dim>
    vector(const double a, const double b)
    {
      Tensor<1, dim> v;
      for (unsigned int d = 0; d < dim; ++d)
        v[d] = (*this)(a, b);
      return v;
    }

    template <int dim>
    Tensor<2, dim>
    matrix(const double a, const double b)
    {
      Tensor<2, dim> m;
      for (unsigned int d = 0; d < dim; ++d)
        m[d] = vector<dim>(a, b);
      return m;
    }

    /// A stress as plane strain has it (xz = yz = 0) in 2D, any in 3D.
    template <int dim>
    SymmetricTensor<2, 3>
    stress(const double size)
    {
      SymmetricTensor<2, 3> s;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          if (i == j || j < dim)
            s[i][j] = (*this)(-size, size);
      return s;
    }

  private:
    std::mt19937_64 engine;
  };


  /// Append a point of the given volume and half-size (the same in all
  /// directions), at rest and without stress.
  template <int dim>
  void
  add_point(MaterialPoints<dim> &points,
            const Point<dim>    &x,
            const double         volume,
            const double         half_size,
            const double         density = 1.)
  {
    Tensor<1, dim> l;
    for (unsigned int d = 0; d < dim; ++d)
      l[d] = half_size;
    points.id.push_back(points.n_points());
    points.material.push_back(0);
    points.mass.push_back(density * volume);
    points.volume.push_back(volume);
    points.half_size.push_back(l);
    points.position.push_back(x);
    points.initial_position.push_back(x);
    points.velocity.emplace_back();
    points.acceleration.emplace_back();
    points.stress.emplace_back();
  }


  /// A box of n^dim points with the given spacing from its corner `lower`:
  /// the support domains tile it.
  template <int dim>
  MaterialPoints<dim>
  box(const Point<dim>  &lower,
      const unsigned int n,
      const double       spacing,
      const double       density = 1.)
  {
    MaterialPoints<dim> points;
    unsigned int        total = 1;
    for (unsigned int d = 0; d < dim; ++d)
      total *= n;
    for (unsigned int p = 0; p < total; ++p)
      {
        Point<dim>   x    = lower;
        unsigned int rest = p;
        for (unsigned int d = 0; d < dim; ++d, rest /= n)
          x[d] += (rest % n + 0.5) * spacing;
        add_point(points, x, std::pow(spacing, dim), 0.5 * spacing, density);
      }
    return points;
  }


  /// A grid that spans [0, length]^dim, margin not included.
  template <int dim>
  BackgroundGrid<dim>
  grid(const double length, const double h)
  {
    Point<dim> upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = length;
    return BackgroundGrid<dim>(Point<dim>(), upper, h, MPI_COMM_SELF);
  }


  /// The nodal vector of the field u(x) = A (x - centre) + b.
  template <int dim>
  NodalVector
  linear_field(const BackgroundGrid<dim> &grid,
               const Tensor<2, dim>      &A,
               const Tensor<1, dim>      &b,
               const Point<dim>          &centre = Point<dim>())
  {
    NodalVector u(grid.n_dofs());
    for (unsigned int i = 0; i < grid.n_nodes(); ++i)
      {
        const Tensor<1, dim> value = A * (grid.node_position(i) - centre) + b;
        for (unsigned int c = 0; c < dim; ++c)
          u.begin()[dim * i + c] = value[c];
      }
    return u;
  }


  /// A rotation: by `angle` about z in 2D, about `axis` in 3D.
  template <int dim>
  Tensor<2, dim>
  rotation(const double angle, const Tensor<1, 3> &axis)
  {
    const Tensor<1, 3> n = axis / axis.norm();
    Tensor<2, dim>     R;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        R[i][j] = (i == j ? std::cos(angle) : 0.) +
                  (1. - std::cos(angle)) * n[i] * n[j];
    const double s = std::sin(angle);
    R[0][1] -= s * n[2];
    R[1][0] += s * n[2];
    if constexpr (dim == 3)
      {
        R[0][2] += s * n[1];
        R[2][0] -= s * n[1];
        R[1][2] -= s * n[0];
        R[2][1] += s * n[0];
      }
    return R;
  }


  /// R in three dimensions: a rotation in 2D leaves z alone.
  template <int dim>
  Tensor<2, 3>
  embedded(const Tensor<2, dim> &R)
  {
    Tensor<2, 3> Q;
    Q[2][2] = 1.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        Q[i][j] = R[i][j];
    return Q;
  }
} // namespace Lattice

#endif
