// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/body/solid_mesh.h>
#include <contrecoup/solid/boundary/pressure_history.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * Pressure loads on the surface: subsection "Loads". The force p n A of a
 * facet is distributed to its nodes by their shape functions, with areas and
 * normals of the undeformed body.
 */
class SurfaceLoads
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  void reinit(const SolidMesh &mesh, MPI_Comm communicator);

  /// Adds the number of boundary facets of this rank that each load selects.
  void add_selections(const SolidMesh &mesh, Selections &selections) const;

  /// Warns of loads whose records end before the end time of the run [s], or
  /// whose waves arrive after it. Call after reinit(). Collective.
  void warn_of_times(double end_time) const;

  /// Computes the pressures and nodal forces of this rank at a time [s].
  void set_time(double time);

  /// Adds the nodal forces to @p nodes.
  template <typename Real>
  void add_forces(NodeFields<Real> &nodes) const;

  /// Power of the loads with the current velocities [W], of this rank.
  template <typename Real>
  double power(const NodeFields<Real> &nodes) const;

  /// Number of boundary facets with a load, counted once for each load.
  /// Collective.
  std::uint64_t n_loaded_facets(MPI_Comm communicator) const;

  /// Checks of recorded loads, for the summary. Collective.
  std::vector<NamedValue> check_values() const;

  /// Pressure on the loaded facet whose centre is nearest to @p point, without
  /// correction() [Pa]; the mean of equally near facets, 0 without loads.
  /// Collective.
  double pressure_near(const dealii::Point<3> &point,
                       MPI_Comm communicator) const;

  /// Total load of this rank [N].
  dealii::Tensor<1, 3> total() const;

private:
  struct Load
  {
    std::string name;
    Expression where;
    Expression pressure;
    std::shared_ptr<PressureHistory> history; ///< replaces the expression
  };

  /// A loaded facet with the area vectors of its nodes [m^2].
  struct Facet
  {
    std::size_t boundary; ///< index among the boundary facets of this rank
    std::size_t number;   ///< index among the facets of its load
    unsigned int load;
    dealii::Point<3> middle;
    std::array<unsigned int, 4> entry; ///< indices in forces_
    std::array<dealii::Tensor<1, 3>, 4> area;
    double pressure; ///< at the current time, without correction() [Pa]
  };

  void add_facets(const SolidMesh &mesh, unsigned int load);

  std::vector<Load> loads_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> nodes_; ///< loaded nodes
  std::vector<std::uint32_t> entry_of_node_;
  std::vector<dealii::Tensor<1, 3>> forces_;
};
} // namespace contrecoup::solid
