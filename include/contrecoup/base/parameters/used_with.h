// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * States for all entries declared during its lifetime with which choices they
 * are used; their help text says so, and find_unused() reads it there.
 *
 * A condition names entries, separated by " or ", of which one must have one
 * of the values, or, with "not", another value:
 * "Body/Kind = surface", "Mesh/Kind = ball octant, shell octant",
 * "Loads/Recorded/File not empty", "Lines or Gauge planes not empty". A path
 * counts from the innermost section around the entry in which it exists. The
 * scopes of conditions nest.
 */
class UsedWith
{
public:
  explicit UsedWith(const std::string &condition);
  ~UsedWith();
  UsedWith(const UsedWith &) = delete;
  UsedWith &operator=(const UsedWith &) = delete;

  /// The help text of an entry that is declared now.
  static std::string annotate(const std::string &sentence);
};

/// The sentence of a single entry with its condition, see UsedWith.
std::string used_with(const std::string &condition,
                      const std::string &sentence);

/**
 * Entries of @p assignments whose values in @p prm differ from the defaults
 * but are not used with the other choices there, as warnings, one for all
 * entries with the same reason, except what an included file sets, as presets
 * do for choices of others, and what a later choice by "--set" leaves unused:
 * "WARNING: Body/Surface/File is set but not used: Body/Kind is phantom, not
 * surface".
 */
std::vector<std::string>
find_unused(const dealii::ParameterHandler &prm,
            const std::vector<Assignment> &assignments);

/// The warning of find_unused() for these entries.
std::string unused_warning(const std::vector<std::string> &entries,
                           const std::string &reason);
} // namespace contrecoup
