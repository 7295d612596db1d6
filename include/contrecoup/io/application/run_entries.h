// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application/application.h>
#include <contrecoup/io/run/command_line.h>

namespace contrecoup
{
namespace io
{
  /// Declares all entries of an application, with their defaults.
  void declare_entries(const ApplicationDescription &description,
                       dealii::ParameterHandler &prm);

  /**
   * As run_within(), with entries that declare_entries() declared and the
   * caller set. Collective.
   * @param command output folder and options; its parameter file only names
   * the run in messages, and its overrides are not applied
   */
  Failure run_entries(CommandLine command,
                      dealii::ParameterHandler &prm,
                      const ApplicationDescription &description);
} // namespace io
} // namespace contrecoup
