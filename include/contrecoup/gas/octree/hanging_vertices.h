// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Closes the gaps next to hanging faces of an octree with curved manifolds. The
 * edges and faces of a leaf are shaped by its vertices alone; a new vertex in
 * the middle of one is moved away from it by deal.II's manifold of a sphere or
 * a cylinder. Where that vertex hangs on a coarse leaf, it is put back on the
 * coarse edge or face. Then the fine faces make up the coarse one exactly.
 *
 * A manifold places new vertices by those around them. All vertices are put
 * back where it placed them before each refinement and each distribution over
 * the ranks, so that they do not depend on the order of either.
 */
template <int dim>
class HangingVertices
{
public:
  using Tria = dealii::parallel::distributed::Triangulation<dim>;

  /// @param triangulation must outlive this object
  explicit HangingVertices(Tria &triangulation);

  /// Puts all hanging vertices of owned and ghost leaves in their places.
  /// Collective.
  void settle();

private:
  /// Settles what hangs on the leaves of a refinement level.
  void settle_level(const unsigned int level);
  void exchange_vertices();
  void restore();

  Tria &triangulation_;
  boost::signals2::scoped_connection before_refinement_;
  boost::signals2::scoped_connection before_repartition_;
  boost::signals2::scoped_connection at_creation_;
  /// Places of all vertices before settle(); empty: nothing was moved.
  std::vector<dealii::Point<dim>> before_;
};
} // namespace contrecoup::gas
