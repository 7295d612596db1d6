// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// A part of a mesh that regions call by its name or its number.
struct MeshLayer
{
  std::string name;
  std::string number; ///< in a file; empty: it has none

  /// Upper and lower case being the same.
  bool is_called(const std::string &word) const;

  /// Both, for messages.
  std::string told() const
  {
    return number.empty() || number == name ? name : name + " (" + number + ")";
  }
};

/// By material ids of the mesh; none: it has no layers.
using MeshLayers = std::vector<MeshLayer>;
} // namespace contrecoup::ale
