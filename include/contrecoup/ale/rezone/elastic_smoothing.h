// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/hex_space.h>

#include <array>
#include <memory>

namespace contrecoup::ale
{
/// Parameters of the elastic mesh smoothing.
struct ElasticOptions
{
  double poisson_ratio = 0.3; ///< of the fictitious elastic material [-]
  /// Young's modulus is proportional to cell volume to the power of minus
  /// this: small cells keep their shape.
  double stiffening = 1.;
  double tolerance = 1e-6; ///< of the residual, relative [-]
  unsigned int largest_iterations = 1000;
  /// The multigrid hierarchy is rebuilt when a solution takes this many times
  /// the iterations of the first solution with the hierarchy.
  double rebuild_factor = 1.5;
};

/// A node on an inclined plane: one component of its displacement relative to
/// the matter is a linear combination of the free components.
struct InclinedNode
{
  std::uint32_t node = 0;
  unsigned int component = 0;     ///< the dependent component
  std::array<double, 3> factor{}; ///< of the other components; 0 if prescribed
};

/// Prescribed displacement components of all local nodes, and nodes that slide
/// along inclined planes.
struct PrescribedNodes
{
  std::vector<std::array<bool, 3>> components;
  std::vector<InclinedNode> inclined;
};

/// Data carried from one solution to the next, node_width numbers per
/// node. Checkpoints hold them, so that a resumed run is bitwise identical.
struct SmoothingMemory
{
  SmoothingMemory() = default;
  explicit SmoothingMemory(const HexSpace &space);

  dealii::AlignedVector<double> displacement; ///< of the last solution [m]
  /// Mesh for which the multigrid hierarchy was built [m].
  dealii::AlignedVector<double> hierarchy_position;
  /// with this hierarchy; 0: none was built
  unsigned int first_iterations = 0;
};

/**
 * Mesh smoothing by linear elasticity (Tan, Saunders and Bagchi 2017, section
 * 2.2): solves div sigma = 0 for nodal displacements that are prescribed at
 * some nodes, or normal to planes along which nodes slide. Continuous
 * trilinear elements, conjugate gradients with an algebraic multigrid
 * preconditioner, which is reused between solutions; the last solution is the
 * initial guess.
 */
class ElasticSmoothing
{
public:
  ElasticSmoothing();
  ~ElasticSmoothing();

  /// @param space the mesh; must outlive this object
  void reinit(HexSpace &space,
              const PrescribedNodes &prescribed,
              const ElasticOptions &options);

  /**
   * @param position of the nodes before smoothing, node_width numbers
   * each [m]
   * @param displacement prescribed values as input; the free components are
   * computed [m]
   * @return number of iterations
   * @throws NumericsError when the solver does not converge
   */
  unsigned int solve(const dealii::AlignedVector<double> &position,
                     dealii::AlignedVector<double> &displacement);

  const SmoothingMemory &memory() const;

  /// Restores memory() of a checkpoint.
  void resume(const SmoothingMemory &memory);

private:
  class System;
  std::unique_ptr<System> system_;
};
} // namespace contrecoup::ale
