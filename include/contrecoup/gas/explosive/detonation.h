// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/explosive/charge_set.h>
#include <contrecoup/gas/octree/ghost_exchange.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/burn.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Programmed burn of all charges on a mesh: a front runs from the ignition
 * points at the detonation speed D, and a subcell of size h burns while the
 * front advances by w h,
 *
 *   F(x, t) = min(1, max(0, D (t - t_b(x)) / (w h))),
 *
 * w being ChargeSet::burn_width. Burning begins when the front is still
 * w h / 2 away, t_b = min over i of t_i + max(0, |x - x_i| - w h / 2)
 * / D, so that the captured front, which is w h wide, arrives on time. The
 * explosive ahead of the front is at rest; F is therefore a function of
 * position and time alone, needs neither storage nor transport and never
 * decreases. Subcells without explosive burn too if they lie within their
 * diameter of a charge. See Burn for the effect of F.
 */
template <int dim>
class Detonation
{
public:
  /// Computes t_b of all points. Collective.
  void reinit(const LeafMesh<dim> &mesh,
              const LeafPoints<dim> &points,
              const ChargeSet<dim> &charges);

  /// Burn data for Stage and GasField; valid until reinit().
  const Burn &burn() const
  {
    return burn_;
  }

  /// Time when all explosive has burned [s].
  double end() const
  {
    return end_;
  }

private:
  void set_leaf(const unsigned int leaf,
                const LeafMesh<dim> &mesh,
                const LeafPoints<dim> &points,
                const ChargeSet<dim> &charges);

  Burn burn_;
  dealii::AlignedVector<double> start_;
  dealii::AlignedVector<double> rate_;
  std::vector<unsigned char> burns_;
  double end_ = 0.;
};
} // namespace contrecoup::gas
