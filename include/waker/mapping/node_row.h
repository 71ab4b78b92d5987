// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_node_row_h
#define waker_mapping_node_row_h

#include <cstring>

namespace Waker
{
  /**
   * Two numbers, and the six numbers of a row of three nodes in 2D, as vectors
   * of the processor. The compiler (GCC's and Clang's vector extension) makes
   * what it can of them: AVX instructions, or pairs of SSE2. Left to itself it
   * unrolls such short loops into single numbers.
   */
  using Two  = double __attribute__((vector_size(16)));
  using Four = double __attribute__((vector_size(32)));

  struct NodeRow
  {
    Four first; // x and y of the nodes 0 and 1
    Two  last;  // x and y of node 2

    static NodeRow
    zero()
    {
      return {Four{0., 0., 0., 0.}, Two{0., 0.}};
    }

    static NodeRow
    load(const double *u)
    {
      NodeRow r;
      std::memcpy(&r.first, u, sizeof(r.first));
      std::memcpy(&r.last, u + 4, sizeof(r.last));
      return r;
    }

    void
    store(double *u) const
    {
      std::memcpy(u, &first, sizeof(first));
      std::memcpy(u + 4, &last, sizeof(last));
    }

    /// w_0 f, w_1 f, w_2 f: a vector for each node.
    static NodeRow
    outer(const double *w, const Two f)
    {
      const Two a = w[0] * f, b = w[1] * f;
      return {__builtin_shufflevector(a, b, 0, 1, 2, 3), w[2] * f};
    }

    /// w_0 u_0 + w_1 u_1 + w_2 u_2
    Two
    sum(const double *w) const
    {
      return w[0] * __builtin_shufflevector(first, first, 0, 1) +
             w[1] * __builtin_shufflevector(first, first, 2, 3) + w[2] * last;
    }

    /// this += s r
    void
    add(const double s, const NodeRow &r)
    {
      first += s * r.first;
      last += s * r.last;
    }
  };
} // namespace Waker

#endif
