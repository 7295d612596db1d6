// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// A layer of a mesh, which regions refer to by name or number.
struct MeshLayer
{
  std::string name;
  std::string number; ///< in a file; empty: none

  /// Whether @p word is the name or the number, ignoring case.
  bool is_called(const std::string &word) const;

  /// Name and number, for messages.
  std::string label() const
  {
    return number.empty() || number == name ? name : name + " (" + number + ")";
  }
};

/// Layers by material id; empty: a mesh without layers.
using MeshLayers = std::vector<MeshLayer>;
} // namespace contrecoup::ale
