// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>

namespace contrecoup
{
/// A block of coarse leaves of a box: indices begin to end - 1 in each
/// direction.
template <int dim>
struct LeafBlock
{
  std::array<unsigned int, dim> begin{};
  std::array<unsigned int, dim> end{};

  double n_leaves() const
  {
    double product = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      product *= end[d] - begin[d];
    return product;
  }
};


/**
 * Sums a value over the leaves of a block by recursive bisection. If @p
 * is_uniform(block) is true, each leaf of the block has the value @p of_each;
 * otherwise the block is halved along its longest edge. A single leaf has the
 * value @p of_one(block).
 *
 * For a surface in n^3 leaves this takes about n^2 evaluations.
 */
template <int dim, typename IsUniform, typename OfOne>
double sum_over_leaves(const LeafBlock<dim> &block,
                       const IsUniform &is_uniform,
                       const double of_each,
                       const OfOne &of_one)
{
  if (block.n_leaves() == 1.)
    return of_one(block);
  if (is_uniform(block))
    return of_each * block.n_leaves();
  unsigned int longest = 0;
  for (unsigned int d = 1; d < dim; ++d)
    if (block.end[d] - block.begin[d] >
        block.end[longest] - block.begin[longest])
      longest = d;
  LeafBlock<dim> first = block, second = block;
  first.end[longest] = second.begin[longest] =
    block.begin[longest] + (block.end[longest] - block.begin[longest]) / 2;
  return sum_over_leaves<dim>(first, is_uniform, of_each, of_one) +
         sum_over_leaves<dim>(second, is_uniform, of_each, of_one);
}
} // namespace contrecoup
