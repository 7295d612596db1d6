// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <cmath>
#include <string>
#include <vector>

namespace contrecoup
{
/// Volume that an organ or a group of organs should have.
struct OrganReference
{
  std::string name;
  std::vector<std::string> parts; ///< parts that belong to it; empty: all
  double volume;                  ///< [m^3]
  double tolerance;               ///< accepted relative difference
  std::string source;             ///< such as "the literature (ICRP 89)"
};

/// Volume of an organ in a mesh, and the one that it should have.
struct OrganCheck
{
  OrganReference reference;
  double volume = 0.; ///< in the mesh [m^3]

  double difference() const
  {
    return volume / reference.volume - 1.;
  }
  bool holds() const
  {
    return std::abs(difference()) <= reference.tolerance;
  }
};

std::vector<OrganCheck>
check_organs(const HexMesh &mesh,
             const std::vector<OrganReference> &references);

/// A warning of organs whose volume in elements differs by more than a tenth
/// from that of their reference; empty where there are none.
std::string organ_warning(const std::vector<OrganCheck> &checks);
} // namespace contrecoup
