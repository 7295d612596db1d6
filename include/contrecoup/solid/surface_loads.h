// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/expression.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/solid/node_fields.h>
#include <contrecoup/solid/solid_mesh.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Pressures on facets over time, such as those that another run recorded.
class PressureHistory
{
public:
  virtual ~PressureHistory() = default;

  /// Takes the facets of this rank, by their middles [m] and area vectors out
  /// of the body [m^2]. Collective.
  virtual void reinit(const std::vector<dealii::Point<3>> &middles,
                      const std::vector<dealii::Tensor<1, 3>> &areas,
                      MPI_Comm communicator) = 0;

  /// Goes to a time [s]; times ascend.
  virtual void set_time(double time) = 0;

  /// Overpressure on a facet at that time [Pa].
  virtual double pressure(std::size_t facet) const = 0;

  /// What there is to say of how the loads were brought here. Collective.
  virtual std::vector<NamedValue> audit() const = 0;
};


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
  std::vector<NamedValue> audit() const
  {
    return history_ ? history_->audit() : std::vector<NamedValue>();
  }

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
  };

  /// A facet under pressure and the area vectors of its nodes.
  struct Facet
  {
    std::size_t number; ///< in the boundary of the mesh
    unsigned int load;  ///< number of loads: the history
    dealii::Point<3> middle;
    std::array<unsigned int, 4> entry; ///< in forces_
    std::array<dealii::Tensor<1, 3>, 4> area;
    double pressure; ///< at the time that was set [Pa]
  };

  void add_facets(const SolidMesh &mesh, unsigned int load);

  std::vector<Load> loads_;
  std::shared_ptr<PressureHistory> history_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> nodes_; ///< that have forces
  std::vector<std::uint32_t> entry_of_node_;
  std::vector<dealii::Tensor<1, 3>> forces_;
};
} // namespace contrecoup::solid
