// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/expression.h>
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
 * Pressures on the surface: subsection "Loads". Each facet has the force
 * p n A, shared by its nodes as their shape functions say, with areas and
 * normals of the undeformed body.
 */
class SurfaceLoads
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  void reinit(const SolidMesh &mesh, MPI_Comm communicator);

  /// Makes the forces of this rank's facets at a time [s].
  void set_time(double time);

  /// Adds them.
  template <typename Real>
  void add_forces(NodeFields<Real> &nodes) const;

  /// Their power with the nodes' velocities [W], of this rank.
  template <typename Real>
  double power(const NodeFields<Real> &nodes) const;

  /// What there is to say of recorded loads. Collective.
  std::vector<NamedValue> audit() const;

  /// Pressure on the loaded facet whose middle is nearest to a point [Pa], the
  /// mean of several that are equally near, 0 without any. Collective.
  double pressure_near(const dealii::Point<3> &point,
                       MPI_Comm communicator) const;

  /// Their sum, of this rank [N].
  dealii::Tensor<1, 3> total() const;

private:
  struct Load
  {
    std::string name;
    Expression where;
    Expression pressure;
    std::shared_ptr<PressureHistory> history; ///< in place of the expression
  };

  /// A facet under pressure and the area vectors of its nodes.
  struct Facet
  {
    std::size_t boundary; ///< among the outer facets of this rank
    std::size_t number;   ///< among the facets of its load
    unsigned int load;
    dealii::Point<3> middle;
    std::array<unsigned int, 4> entry; ///< in forces_
    std::array<dealii::Tensor<1, 3>, 4> area;
    double pressure; ///< at the time that was set [Pa]
  };

  void add_facets(const SolidMesh &mesh, unsigned int load);

  std::vector<Load> loads_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> nodes_; ///< that have forces
  std::vector<std::uint32_t> entry_of_node_;
  std::vector<dealii::Tensor<1, 3>> forces_;
};
} // namespace contrecoup::solid
