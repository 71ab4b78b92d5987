// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_coverage.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  void
  BlockCoverage<dim>::reinit(const std::vector<Box<dim>> &boxes,
                             const BoxUnionRules<dim>    &new_rules,
                             const BoxExtents<dim>       &all)
  {
    rules = new_rules;
    choose_lattice(boxes, all);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double block = bits_per_block * cell[d];
        inverse_block[d]   = 1. / block;
        block_origin[d]    = origin[d] + rules.tolerance;
        searched.lower[d]  = block_origin[d];
        searched.upper[d]  = origin[d] + (n[d] - 0.5) * block;
        // Blocks that merely touch a closed face are not searched.
        if (rules.is_closed(2 * d))
          searched.lower[d] =
            std::max(searched.lower[d], rules.lower[d] + 2 * rules.tolerance);
        if (rules.is_closed(2 * d + 1))
          searched.upper[d] =
            std::min(searched.upper[d], rules.upper[d] - 2 * rules.tolerance);
      }
    mark(boxes);
    mark_beyond_closed_faces();

    const auto gap = [&](const unsigned int d) {
      return static_cast<unsigned int>(
        (rules.minimum_gap[d] + 0.5 * rules.tolerance) / cell[d]);
    };
    fill_along_x(gap(0));
    if (dim == 3)
      fill_along(2, gap(2));
    fill_along(1, gap(1));
    find_covered_blocks();
  }



  template <int dim>
  typename BlockCoverage<dim>::Lattice
  BlockCoverage<dim>::lattice(const BoxUnionRules<dim> &rules,
                              const Tensor<1, dim>     &block,
                              const Point<dim>         &lower,
                              const Point<dim>         &upper)
  {
    Lattice lattice;
    lattice.n_words = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        // Blocks to spare at either end for a gap between a box and a closed
        // face.
        const double spare = 1. + std::floor(rules.minimum_gap[d] / block[d]);
        const double first =
          std::floor((lower[d] - rules.lower[d]) / block[d]) - spare;
        const double origin = rules.lower[d] + first * block[d];
        const double blocks = std::ceil((upper[d] - origin) / block[d]) + spare;
        lattice.first[d] =
          static_cast<int>(std::min(std::max(first, -1e6), 1e6));
        lattice.n[d]      = static_cast<int>(std::min(blocks, 1e6));
        const int n_lines = bits_per_block * lattice.n[d];
        lattice.n_words *= d == 0 ? (n_lines + 63) / 64 : n_lines;
      }
    return lattice;
  }



  template <int dim>
  Tensor<1, dim>
  BlockCoverage<dim>::block_extent(const BoxUnionRules<dim> &rules,
                                   const BoxExtents<dim>    &all)
  {
    if (all.n == 0.)
      {
        Tensor<1, dim> one;
        for (unsigned int d = 0; d < dim; ++d)
          one[d] = 1.;
        return one;
      }
    Tensor<1, dim> block = all.smallest / 4. * bits_per_block;
    // Few tiny boxes among large ones must not cost memory.
    const double max_words = 4096. + 16. * all.n;
    while (true)
      {
        const Lattice of_all = lattice(rules, block, all.lower, all.upper);
        bool          fits   = of_all.n_words <= max_words;
        for (unsigned int d = 0; d < dim; ++d)
          fits = fits && std::abs(of_all.first[d]) + of_all.n[d] < 1000000;
        if (fits)
          return block;
        block *= 2.;
      }
  }



  template <int dim>
  void
  BlockCoverage<dim>::choose_lattice(const std::vector<Box<dim>> &boxes,
                                     const BoxExtents<dim>       &all)
  {
    const Tensor<1, dim> block = block_extent(rules, all);
    cell                       = block / static_cast<double>(bits_per_block);
    // Around these boxes, which need not be all.
    BoxExtents<dim> here =
      static_cast<double>(boxes.size()) == all.n ? all : extents_of(boxes);
    if (boxes.empty())
      here.lower = here.upper = Point<dim>();
    const Lattice chosen = lattice(rules, block, here.lower, here.upper);
    first                = chosen.first;
    n                    = chosen.n;
    for (unsigned int d = 0; d < dim; ++d)
      {
        origin[d]  = rules.lower[d] + first[d] * block[d];
        n_lines[d] = bits_per_block * n[d];
      }
    words_per_row = (n_lines[0] + 63) / 64;
    bits.assign(chosen.n_words, 0);
    dilated.resize(chosen.n_words);
  }



  template <int dim>
  void
  BlockCoverage<dim>::open_blocks_at_closed_faces()
  {
    for (unsigned int face = 0; face < 2 * dim; ++face)
      {
        if (!rules.is_closed(face))
          continue;
        const unsigned int d = face / 2;
        const double place   = face % 2 == 0 ? rules.lower[d] : rules.upper[d];
        const double line    = (place - origin[d]) * inverse_block[d];
        const double slack   = rules.tolerance * inverse_block[d];
        // Blocks before, of and after one layer: number = (k n_d + i) m + j.
        std::size_t m = 1;
        for (unsigned int e = 0; e < d; ++e)
          m *= n[e];
        for (int i = 0; i < n[d]; ++i)
          if (i <= line + slack && i + 1 >= line - slack)
            for (std::size_t first = i * m; first < covered.size();
                 first += n[d] * m)
              std::fill_n(covered.begin() + first, m, 0);
      }
  }



  template <int dim>
  Box<dim>
  BlockCoverage<dim>::block(const Index &index) const
  {
    Box<dim> box;
    for (unsigned int d = 0; d < dim; ++d)
      {
        // The same to the bit, whichever blocks are here.
        const double extent = bits_per_block * cell[d];
        box.lower[d]        = rules.lower[d] + (first[d] + index[d]) * extent;
        box.upper[d] = rules.lower[d] + (first[d] + index[d] + 1) * extent;
      }
    return box;
  }



  template <int dim>
  void
  BlockCoverage<dim>::append_covered_rows(std::vector<Box<dim>> &rows) const
  {
    Index     i;
    const int nz = dim == 3 ? n[dim - 1] : 1;
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < n[1]; ++j)
        {
          i[dim - 1] = k;
          i[1]       = j;
          for (i[0] = 0; i[0] < n[0]; ++i[0])
            {
              if (!is_covered(i))
                continue;
              Box<dim> row = block(i);
              while (i[0] + 1 < n[0])
                {
                  ++i[0];
                  if (!is_covered(i))
                    break;
                  row.upper[0] = block(i).upper[0];
                }
              rows.push_back(row);
            }
        }
  }



  template class BlockCoverage<3>;
} // namespace Waker
