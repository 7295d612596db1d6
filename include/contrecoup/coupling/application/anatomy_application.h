// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/io/application/tool.h>
#include <contrecoup/io/output/manifest.h>

#include <functional>

namespace contrecoup
{
namespace coupling
{
  /// Application `anatomy`: hexahedral mesh of a body, by tissue, with its
  /// surface, its quality report and pictures.
  /// @param on_cost_estimate receives the cost estimate of --check
  io::ToolDescription anatomy_application(
    const std::function<void(const CostEstimate &)> &on_cost_estimate = {});

  /// Names of the files that `anatomy` writes.
  io::FileNames anatomy_files();
} // namespace coupling
} // namespace contrecoup
