// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/expression.h>
#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Nodes that are held, or moved as an expression says: subsection "Supports".
class Supports
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for directions other than x, y, z
  void parse_parameters(dealii::ParameterHandler &prm);

  void reinit(const SolidMesh &mesh);

  /// Sets forces so that supported components have their velocity in the
  /// middle of the next step, whatever they were made of before.
  /// @param time at the begin of the next step [s]
  /// @param before, next sizes of the steps around it [s]
  template <typename Real>
  void set_forces(NodeFields<Real> &nodes,
                  const double time,
                  const double before,
                  const double next);

  /// Call when the forces of nodes were computed anew.
  void forget();

  /// Forces zero where nodes are supported: for frequencies.
  template <typename Real>
  void hold(NodeFields<Real> &nodes) const;

  /// Calls @p function with node, direction and reaction [N] of each supported
  /// component.
  template <typename Function>
  void for_each_reaction(const Function &function)
  {
    for (Entry &entry : entries_)
      function(entry.node, entry.direction, entry.reaction);
  }

  /// Power of the supports with the nodes' velocities [W], of nodes that this
  /// rank counts.
  template <typename Real>
  double power(const NodeFields<Real> &nodes) const;

private:
  struct Support
  {
    std::string name;
    Expression where;
    std::vector<unsigned int> directions;
    std::vector<Expression> velocity; ///< x, y, z
  };

  struct Entry
  {
    std::uint32_t node;
    unsigned int direction;
    unsigned int support;
    bool counted;
    dealii::Point<3> place;
    double reaction; ///< in the node's force [N]
  };

  std::vector<Support> supports_;
  std::vector<Entry> entries_;
};
} // namespace contrecoup::solid
