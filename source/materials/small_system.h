// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_small_system_h
#define waker_source_materials_small_system_h

#include "mohr_coulomb_return.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace Waker
{
  inline double
  dot(const Principal &a, const Principal &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }


  /// x = A^-1 b for m right-hand sides; false if A has no inverse.
  template <unsigned int size, unsigned int m>
  bool
  solve(const unsigned int n, double (&A)[size][size], double (&b)[size][m])
  {
    double largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        largest = std::max(largest, std::abs(A[i][j]));
    for (unsigned int i = 0; i < n; ++i)
      {
        unsigned int pivot = i;
        for (unsigned int r = i + 1; r < n; ++r)
          if (std::abs(A[r][i]) > std::abs(A[pivot][i]))
            pivot = r;
        if (!(std::abs(A[pivot][i]) > 1e-12 * largest))
          return false;
        std::swap(A[i], A[pivot]);
        std::swap(b[i], b[pivot]);
        for (unsigned int r = 0; r < n; ++r)
          if (r != i)
            {
              const double factor = A[r][i] / A[i][i];
              for (unsigned int j = i; j < n; ++j)
                A[r][j] -= factor * A[i][j];
              for (unsigned int j = 0; j < m; ++j)
                b[r][j] -= factor * b[i][j];
            }
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < m; ++j)
        b[i][j] /= A[i][i];
    return true;
  }
} // namespace Waker

#endif
