// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/materials/gas_material.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <vector>

namespace contrecoup::gas
{
/// Boundary conditions of the gas, read from subsection "Boundaries".
template <int dim>
class Boundary
{
public:
  enum class Kind
  {
    wall, ///< rigid slip wall; also a plane of symmetry or the axis
    /// Non-reflecting: outside() is the inner state. On boxes, finite volumes
    /// change that state where a shock leaves, Galerkin at every open side.
    open,
    inflow,  ///< one prescribed state
    initial, ///< initial state at that position
    exact    ///< reference solution at that position and time
  };

  /// Declares subsection "Boundaries".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unknown names, an inflow state that the
  /// material cannot have, "exact" without a reference solution.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasMaterial &material,
                        const CoarseMesh<dim> &coarse_mesh,
                        const InitialState<dim> &initial_state,
                        const ReferenceSolution<dim> &reference);

  Kind kind(const unsigned int boundary_id) const
  {
    return boundary_id < kind_of_id_.size() ? kind_of_id_[boundary_id]
                                            : default_kind_;
  }

  /// Whether every boundary is a wall, so that mass and energy are conserved.
  bool is_closed(const CoarseMesh<dim> &coarse_mesh) const;

  /**
   * Exterior state for the interior state @p inside.
   *
   * Walls of boxes and of Galerkin leaves do not come here: see
   * BatchSweep::fill_images() and GalerkinFaces::beyond_boundary(). At walls of
   * mapped leaves of finite volumes the result only bounds slopes.
   *
   * @param normal outward unit normal
   */
  GasState<dim> outside(const unsigned int boundary_id,
                        const GasState<dim> &inside,
                        const dealii::Tensor<1, dim> &normal,
                        const dealii::Point<dim> &point,
                        const double time) const;

private:
  std::map<unsigned int, Kind> kinds_;
  std::vector<Kind> kind_of_id_; ///< kinds_ as an array, for fast access
  Kind default_kind_ = Kind::wall;
  GasState<dim> inflow_;
  const InitialState<dim> *initial_state_ = nullptr;
  const ReferenceSolution<dim> *reference_ = nullptr;
};
} // namespace contrecoup::gas
