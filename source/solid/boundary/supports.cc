// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/boundary/supports.h>

#include <set>

namespace contrecoup::solid
{
void Supports::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Supports");
  const Section support(prm, "Support *");
  declare_string(
    prm,
    "Where",
    "0",
    selecting(
      "muParser expression of x, y, z that is true at the supported nodes."));
  declare_string(
    prm, "Directions", "x, y, z", "Supported components, separated by commas.");
  for (const std::string axis : {"x", "y", "z"})
    declare_string(prm,
                   "Velocity " + axis,
                   "0",
                   "[m/s] Prescribed velocity as a muParser expression of "
                   "x, y, z (undeformed coordinates), t and pi; 0 holds the "
                   "nodes.");
}


void Supports::parse_parameters(ParameterHandler &prm)
{
  for (const std::string &name : item_names(prm, "Supports/Support"))
  {
    const Section section(prm, "Supports");
    const Section one(prm, "Support " + name);
    const std::string path = "Supports/Support " + name;
    Support support{
      name, Expression(path + "/Where", prm.get("Where")), {}, {}};
    for (const std::string &axis : split(prm.get("Directions"), ','))
    {
      const auto index = std::string("xyz").find(axis);
      if (axis.size() != 1 || index == std::string::npos)
        throw InputError(path + "/Directions = \"" + prm.get("Directions") +
                         "\" must be some of x, y, z, separated by commas");
      support.directions.push_back(static_cast<unsigned int>(index));
    }
    for (const std::string axis : {"x", "y", "z"})
      support.velocity.emplace_back(path + "/Velocity " + axis,
                                    prm.get("Velocity " + axis));
    supports_.push_back(std::move(support));
  }
}


void Supports::reinit(const SolidMesh &mesh)
{
  entries_.clear();
  std::set<std::pair<std::uint32_t, unsigned int>> taken;
  std::vector<unsigned char> hangs(mesh.nodes.size(), 0);
  for (const HexMesh::HangingNode &one : mesh.hanging_nodes)
    hangs[one.node] = 1;
  for (unsigned int s = 0; s < supports_.size(); ++s)
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i)
      if (hangs[i] == 0 && supports_[s].where.value(mesh.nodes[i]) != 0.)
        for (const unsigned int direction : supports_[s].directions)
          if (taken.insert({i, direction}).second)
            entries_.push_back(
              {i, direction, s, mesh.owned[i] != 0, mesh.nodes[i], 0.});
}


std::vector<std::string> Supports::selecting_entries() const
{
  std::vector<std::string> entries;
  for (const Support &support : supports_)
    entries.push_back("Supports/Support " + support.name + "/Where");
  return entries;
}


std::vector<unsigned char>
Supports::find_held_nodes(const SolidMesh &mesh) const
{
  constexpr unsigned char all = 7;
  std::vector<unsigned char> directions(mesh.nodes.size(), 0);
  for (const Support &support : supports_)
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (support.where.value(mesh.nodes[i]) != 0.)
        for (const unsigned int direction : support.directions)
          directions[i] |= static_cast<unsigned char>(1U << direction);
  for (const HexMesh::HangingNode &one : mesh.hanging_nodes)
    directions[one.node] = all;
  for (unsigned char &held : directions)
    held = held == all ? 1 : 0;
  return directions;
}


void Supports::add_selections(const SolidMesh &mesh,
                              Selections &selections) const
{
  for (const Support &support : supports_)
  {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (mesh.owned[i] != 0 && support.where.value(mesh.nodes[i]) != 0.)
        ++count;
    selections.add("Supports/Support " + support.name + "/Where",
                   support.where.text(),
                   "node of the body",
                   count);
  }
}


bool Supports::moves() const
{
  for (const Support &support : supports_)
    for (const unsigned int direction : support.directions)
      if (!support.velocity[direction].is_zero())
        return true;
  return false;
}


template <typename Real>
void Supports::set_forces(NodeFields<Real> &nodes,
                          const double time,
                          const double before,
                          const double next)
{
  for (Entry &entry : entries_)
  {
    Real &force = nodes.force_of(entry.node)[entry.direction];
    const double other_forces = double(force) - entry.reaction;
    const Expression &velocity =
      supports_[entry.support].velocity[entry.direction];
    const double wanted = velocity.is_zero()
                            ? 0.
                            : velocity.value(entry.position, time + 0.5 * next);
    const double now = nodes.velocity_of(entry.node)[entry.direction];
    const double mass = 1. / double(nodes.inverse_mass_of(entry.node));
    force = static_cast<Real>(mass * (wanted - now) / (0.5 * (before + next)));
    entry.reaction = double(force) - other_forces;
  }
}


void Supports::reset_reactions()
{
  for (Entry &entry : entries_)
    entry.reaction = 0.;
}


template <typename Real>
void Supports::zero_supported_forces(NodeFields<Real> &nodes) const
{
  for (const Entry &entry : entries_)
    nodes.force_of(entry.node)[entry.direction] = Real();
}


template <typename Real>
double Supports::power(const NodeFields<Real> &nodes) const
{
  double sum = 0.;
  for (const Entry &entry : entries_)
    if (entry.counted)
      sum +=
        entry.reaction * double(nodes.velocity_of(entry.node)[entry.direction]);
  return sum;
}


template void Supports::set_forces(NodeFields<double> &,
                                   const double,
                                   const double,
                                   const double);
template void Supports::set_forces(NodeFields<float> &,
                                   const double,
                                   const double,
                                   const double);
template void Supports::zero_supported_forces(NodeFields<double> &) const;
template void Supports::zero_supported_forces(NodeFields<float> &) const;
template double Supports::power(const NodeFields<double> &) const;
template double Supports::power(const NodeFields<float> &) const;
} // namespace contrecoup::solid
