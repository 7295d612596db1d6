// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/nodal_average.h>
#include <contrecoup/solid/body/node_exchange.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <vector>

namespace contrecoup::solid
{
/// Averages over neighbours of what the elements of one tissue have, as
/// NodalAverage does.
class TissueAverage
{
public:
  /// @param tissue index in the mesh; one that it does not have is empty
  /// @param exchange of the mesh, is kept
  void reinit(const SolidMesh &mesh,
              const NodeExchange &exchange,
              const unsigned int tissue);

  /// The elements of the tissue, ascending: numbers in the mesh of this rank.
  const std::vector<std::uint32_t> &cells() const
  {
    return cells_;
  }

  /// Undeformed volumes of cells() [m^3].
  const std::vector<double> &volumes() const
  {
    return average_.volumes();
  }

  /// The average of @p values, by cells(). Collective.
  std::vector<double> average(const std::vector<double> &values) const
  {
    return average_.average(values);
  }

private:
  std::vector<std::uint32_t> cells_;
  NodalAverage average_;
};
} // namespace contrecoup::solid
