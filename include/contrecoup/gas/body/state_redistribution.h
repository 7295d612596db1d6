// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/cut_leaves.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * State redistribution of Berger and Giuliani (J. Comput. Phys. 428, 109820,
 * 2021), with constant states in the neighbourhoods: every cell becomes the
 * mean of the neighbourhoods that it belongs to, in each of which it counts
 * with its open volume over their number. Sums over open volumes stay, and
 * steps need not be shorter for small cells.
 */
template <int dim>
class StateRedistribution
{
public:
  /// Takes over the neighbourhoods of @p cut_leaves.
  void reinit(const CutLeaves<dim> &cut_leaves,
              const LeafMesh<dim> &mesh,
              const LeafLayout &layout);

  /// Redistributes @p state, whose ghosts are up to date; changes owned leaves
  /// alone.
  template <typename Real>
  void apply(Real *state) const;

private:
  /// A cell of a neighbourhood.
  struct Member
  {
    std::size_t position; ///< of its first component
    double weight;        ///< fraction of the neighbourhood's volume [-]
  };
  /// An owned cell and one of the neighbourhoods that it belongs to.
  struct Receiver
  {
    std::size_t position;
    unsigned int order; ///< place among the cell's neighbourhoods
    unsigned int neighborhood;
    double fraction; ///< one over the number of its neighbourhoods [-]

    friend bool operator<(const Receiver &a, const Receiver &b)
    {
      return a.position != b.position ? a.position < b.position
                                      : a.order < b.order;
    }
  };

  std::size_t stride_ = 1; ///< between components
  unsigned int n_components_ = 1;
  std::vector<Member> members_;
  std::vector<std::size_t> first_member_; ///< per neighbourhood, and the end
  std::vector<Receiver> receivers_;
};
} // namespace contrecoup::gas
