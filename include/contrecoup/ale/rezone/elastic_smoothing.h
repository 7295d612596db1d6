// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/hex_space.h>

#include <array>
#include <memory>

namespace contrecoup::ale
{
/// How a mesh is smoothed.
struct ElasticOptions
{
  double poisson_ratio = 0.3; ///< of the matter that the mesh is taken for [-]
  /// Young's modulus grows with the inverse volume of a cell to this power:
  /// small cells keep their shape.
  double stiffening = 1.;
  double tolerance = 1e-6; ///< of the residual, relative [-]
  unsigned int largest_iterations = 1000;
  /// The multigrid hierarchy is made anew when a solution takes this many times
  /// the iterations of the first one with it.
  double renewal = 1.5;
};

/// A node that goes with the matter in a direction that is no axis: one
/// component of what it is ahead of the matter follows from the free ones.
struct InclinedNode
{
  std::uint32_t node = 0;
  unsigned int component = 0;     ///< that follows
  std::array<double, 3> factor{}; ///< of the others; 0 for what is prescribed
};

/// Components of the displacements that are prescribed at the nodes, copies
/// included, and nodes that slide along inclined planes.
struct PrescribedNodes
{
  std::vector<std::array<bool, 3>> components;
  std::vector<InclinedNode> inclined;
};

/// What a solution takes over from those before it, AleState::width numbers at
/// each node: with it a resumed run finds the same bits.
struct SmoothingMemory
{
  SmoothingMemory() = default;
  explicit SmoothingMemory(const HexSpace &space);

  dealii::AlignedVector<double> displacement; ///< of the last solution [m]
  /// Of the mesh that the multigrid hierarchy was made for [m].
  dealii::AlignedVector<double> hierarchy_position;
  unsigned int first_iterations = 0; ///< with this hierarchy; 0: there is none
};

/**
 * Displacements of the nodes of a mesh, as if it were elastic matter at rest:
 * div sigma = 0 with displacements that are prescribed at some of the nodes,
 * or normal to planes along which they slide
 * (Tan, Saunders and Bagchi 2017, section 2.2). Continuous trilinear elements,
 * conjugate gradients and algebraic multigrid, which is kept from one solution
 * to the next, as is the solution to start from.
 */
class ElasticSmoothing
{
public:
  ElasticSmoothing();
  ~ElasticSmoothing();

  /// @param space the mesh; it must live as long
  void reinit(HexSpace &space,
              const PrescribedNodes &prescribed,
              const ElasticOptions &options);

  /**
   * @param position of the nodes before, AleState::width numbers each [m]
   * @param displacement that of the matter where nodes go with it; the others
   *   are set [m]
   * @return iterations that it took
   * @throws NumericsError when the solver does not converge
   */
  unsigned int solve(const dealii::AlignedVector<double> &position,
                     dealii::AlignedVector<double> &displacement);

  const SmoothingMemory &memory() const;

  /// Takes up what another object had.
  void resume(const SmoothingMemory &memory);

private:
  class System;
  std::unique_ptr<System> system_;
};
} // namespace contrecoup::ale
