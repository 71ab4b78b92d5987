// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/loads/nodal_support.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace Waker
{
  namespace
  {
    using Integers = std::array<long long, 3>;


    Integers
    cross_product(const Integers &a, const Integers &b)
    {
      return {{a[1] * b[2] - a[2] * b[1],
               a[2] * b[0] - a[0] * b[2],
               a[0] * b[1] - a[1] * b[0]}};
    }


    // Do the nodes determine a linear function? Exact, in integers.
    template <int dim>
    bool
    determine_linear_function(const std::vector<SupportNode<dim>> &nodes)
    {
      const auto from_first = [&](const std::size_t k) {
        Integers a = {{0, 0, 0}};
        for (unsigned int d = 0; d < dim; ++d)
          a[d] = nodes[k].offset[d] - nodes[0].offset[d];
        return a;
      };
      const Integers zero = {{0, 0, 0}};

      // The first node off the line through the first two gives a normal; in
      // 3D another one must lie off that plane.
      Integers normal = zero;
      for (std::size_t k = 2; k < nodes.size(); ++k)
        if (normal == zero)
          {
            normal = cross_product(from_first(1), from_first(k));
            if (dim == 2 && normal != zero)
              return true;
          }
        else
          {
            const Integers a = from_first(k);
            if (a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2] != 0)
              return true;
          }
      return false;
    }


    double
    inverse_quartic(const double distance_square)
    {
      return 1. / (distance_square * distance_square);
    }


    // Moving least squares at the origin with the first n nodes, sets their
    // weights.
    // @return the largest weight in size
    double
    set_weights(std::vector<SupportNode<2>> &nodes, const std::size_t n)
    {
      double a00 = 0, a01 = 0, a02 = 0, a11 = 0, a12 = 0, a22 = 0;
      for (std::size_t k = 0; k < n; ++k)
        {
          const double x   = nodes[k].offset[0];
          const double y   = nodes[k].offset[1];
          const double phi = inverse_quartic(nodes[k].distance);
          a00 += phi;
          a01 += phi * x;
          a02 += phi * y;
          a11 += phi * x * x;
          a12 += phi * x * y;
          a22 += phi * y * y;
        }

      // First column of the inverse of the symmetric matrix.
      const double c0  = a11 * a22 - a12 * a12;
      const double c1  = a12 * a02 - a01 * a22;
      const double c2  = a01 * a12 - a11 * a02;
      const double det = a00 * c0 + a01 * c1 + a02 * c2;

      double largest = 0.;
      for (std::size_t k = 0; k < n; ++k)
        {
          const double phi = inverse_quartic(nodes[k].distance);
          nodes[k].weight =
            phi * (c0 + c1 * nodes[k].offset[0] + c2 * nodes[k].offset[1]) /
            det;
          largest = std::max(largest, std::abs(nodes[k].weight));
        }
      return largest;
    }


    double
    set_weights(std::vector<SupportNode<3>> &nodes, const std::size_t n)
    {
      const auto basis = [](const SupportNode<3> &s) {
        return Eigen::Vector4d(1., s.offset[0], s.offset[1], s.offset[2]);
      };

      Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
      for (std::size_t k = 0; k < n; ++k)
        a += inverse_quartic(nodes[k].distance) * basis(nodes[k]) *
             basis(nodes[k]).transpose();
      const Eigen::Vector4d c = a.ldlt().solve(Eigen::Vector4d::Unit(0));

      double largest = 0.;
      for (std::size_t k = 0; k < n; ++k)
        {
          nodes[k].weight =
            inverse_quartic(nodes[k].distance) * c.dot(basis(nodes[k]));
          largest = std::max(largest, std::abs(nodes[k].weight));
        }
      return largest;
    }


    // Call f(index) for the nodes of the lattice at the (Chebyshev) distance r.
    template <typename Function>
    void
    visit_ring(const std::array<int, 2> &centre,
               const std::array<int, 2> &n,
               const int                 r,
               const Function           &f)
    {
      const auto visit = [&](const int i, const int j) {
        if (i >= 0 && j >= 0 && i < n[0] && j < n[1])
          f(std::array<int, 2>{{i, j}});
      };
      for (int i = centre[0] - r; i <= centre[0] + r; ++i)
        {
          visit(i, centre[1] - r);
          visit(i, centre[1] + r);
        }
      for (int j = centre[1] - r + 1; j < centre[1] + r; ++j)
        {
          visit(centre[0] - r, j);
          visit(centre[0] + r, j);
        }
    }


    template <typename Function>
    void
    visit_ring(const std::array<int, 3> &centre,
               const std::array<int, 3> &n,
               const int                 r,
               const Function           &f)
    {
      const auto first = [&](const int d) {
        return std::max(centre[d] - r, 0);
      };
      const auto last = [&](const int d) {
        return std::min(centre[d] + r, n[d] - 1);
      };
      for (int k = first(2); k <= last(2); ++k)
        for (int j = first(1); j <= last(1); ++j)
          {
            const bool all =
              std::abs(k - centre[2]) == r || std::abs(j - centre[1]) == r;
            for (int i = first(0); i <= last(0); ++i)
              if (all || std::abs(i - centre[0]) == r)
                f(std::array<int, 3>{{i, j, k}});
          }
    }
  } // namespace



  template <int dim>
  bool
  find_support(const double                        *mass,
               const double                         minimum_mass,
               const std::array<unsigned int, dim> &n,
               const unsigned int                   node,
               std::vector<SupportNode<dim>>       &nodes,
               const int                            reach)
  {
    constexpr double largest_weight = 2.;

    Assert(reach >= support_reach, dealii::ExcInternalError());
    nodes.clear();
    std::array<int, dim> size;
    std::array<int, dim> centre;
    unsigned int         rest = node;
    int                  last = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        size[d]   = n[d];
        centre[d] = rest % n[d];
        rest /= n[d];
        last = std::max({last, centre[d], size[d] - 1 - centre[d]});
      }

    const auto consider = [&](const std::array<int, dim> &index) {
      unsigned int other = 0;
      for (int d = dim - 1; d >= 0; --d)
        other = other * n[d] + index[d];
      if (mass[other] < minimum_mass)
        return;
      SupportNode<dim> s{other, {}, 0., 0.};
      for (unsigned int d = 0; d < dim; ++d)
        {
          s.offset[d] = index[d] - centre[d];
          s.distance += double(s.offset[d]) * s.offset[d];
        }
      nodes.push_back(s);
    };

    // Squares grow by rings, so a smaller square is a shorter part of `nodes`.
    std::size_t n_best = 0;
    double      best   = std::numeric_limits<double>::max();
    for (int r = 1; r <= std::min(last, reach); ++r)
      {
        visit_ring(centre, size, r, consider);
        if (determine_linear_function(nodes))
          {
            const double weight = set_weights(nodes, nodes.size());
            if (weight < best)
              {
                best   = weight;
                n_best = nodes.size();
              }
            if (best <= largest_weight)
              break;
          }
        if (n_best > 0 && r >= support_reach)
          break;
      }

    if (n_best > 0)
      {
        if (n_best < nodes.size())
          {
            nodes.resize(n_best);
            set_weights(nodes, n_best);
          }
        return true;
      }
    if (reach < anywhere)
      {
        nodes.clear();
        return false;
      }

    // No linear function: the nearest.
    if (nodes.empty())
      return true;
    const auto closer = [](const SupportNode<dim> &a,
                           const SupportNode<dim> &b) {
      return a.distance < b.distance;
    };
    const double nearest =
      std::min_element(nodes.begin(), nodes.end(), closer)->distance;
    nodes.erase(std::remove_if(nodes.begin(),
                               nodes.end(),
                               [=](const SupportNode<dim> &s) {
                                 return s.distance > nearest;
                               }),
                nodes.end());
    for (SupportNode<dim> &s : nodes)
      s.weight = 1. / nodes.size();
    return true;
  }


  template bool
  find_support<2>(const double *,
                  const double,
                  const std::array<unsigned int, 2> &,
                  const unsigned int,
                  std::vector<SupportNode<2>> &,
                  const int);
  template bool
  find_support<3>(const double *,
                  const double,
                  const std::array<unsigned int, 3> &,
                  const unsigned int,
                  std::vector<SupportNode<3>> &,
                  const int);
} // namespace Waker
