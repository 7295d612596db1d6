// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Nodes with prescribed velocity components: subsection "Supports".
class Supports
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for directions other than x, y, z
  void parse_parameters(dealii::ParameterHandler &prm);

  void reinit(const SolidMesh &mesh);

  /// Paths of the entries that select nodes, one of each support.
  std::vector<std::string> selecting_entries() const;

  /// For each node of the mesh whether all of its components are prescribed.
  /// Hanging nodes, which follow others, count as such.
  std::vector<unsigned char> find_held_nodes(const SolidMesh &mesh) const;

  /// Adds the number of nodes that each support selects among those that this
  /// rank owns.
  void add_selections(const SolidMesh &mesh, Selections &selections) const;

  /// Whether the entries prescribe a velocity that is not the number 0.
  bool moves() const;

  /// Sets the forces on supported components so that the next step gives them
  /// the prescribed velocity. The previous reaction in the force is replaced.
  /// @param time at the beginning of the next step [s]
  /// @param before size of the last step [s]
  /// @param next size of the next step [s]
  template <typename Real>
  void set_forces(NodeFields<Real> &nodes,
                  const double time,
                  const double before,
                  const double next);

  /// Sets all reactions to zero. Call after forces were assembled again.
  void reset_reactions();

  /// Sets forces on supported components to zero, for the eigenvalue solver.
  template <typename Real>
  void zero_supported_forces(NodeFields<Real> &nodes) const;

  /// Calls @p function(node, direction, reaction [N]) for each supported
  /// component.
  template <typename Function>
  void for_each_reaction(const Function &function)
  {
    for (Entry &entry : entries_)
      function(entry.node, entry.direction, entry.reaction);
  }

  /// Power of the reactions with the current velocities [W], summed over the
  /// nodes that this rank owns.
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
    dealii::Point<3> position;
    double reaction; ///< part of the nodal force [N]
  };

  std::vector<Support> supports_;
  std::vector<Entry> entries_;
};
} // namespace contrecoup::solid
