// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/nodal_average.h>
#include <contrecoup/solid/body/node_exchange.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <vector>

namespace contrecoup::solid
{
/// NodalAverage restricted to the elements of one tissue.
class TissueAverage
{
public:
  /// @param tissue index in SolidMesh::tissues; beyond its end: no elements
  /// @param exchange of the mesh; must outlive this object
  void reinit(const SolidMesh &mesh,
              const NodeExchange &exchange,
              const unsigned int tissue);

  /// Elements of the tissue, ascending, by local cell number.
  const std::vector<std::uint32_t> &elements() const
  {
    return elements_;
  }

  /// Undeformed volumes of elements() [m^3].
  const std::vector<double> &volumes() const
  {
    return average_.volumes();
  }

  /// Returns the average of @p values; both are indexed as
  /// elements().
  /// Collective.
  std::vector<double> average(const std::vector<double> &values) const
  {
    return average_.average(values);
  }

private:
  std::vector<std::uint32_t> elements_;
  NodalAverage average_;
};
} // namespace contrecoup::solid
