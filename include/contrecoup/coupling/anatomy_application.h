// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/io/manifest.h>
#include <contrecoup/io/tool.h>

#include <functional>

namespace contrecoup
{
namespace coupling
{
  /// `anatomy`: makes hexahedra by tissue of a body, with its surface, its
  /// quality and pictures.
  /// @param take_cost gets what --check finds
  io::ToolDescription anatomy_application(
    const std::function<void(const CostEstimate &)> &take_cost = {});

  /// The files that it writes.
  io::FileNames anatomy_files();
} // namespace coupling
} // namespace contrecoup
