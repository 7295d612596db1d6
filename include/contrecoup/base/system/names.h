// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// Position of @p name in @p names.
/// @param kind what is chosen by name, for the message: "slope limiter"
/// @throws InputError that suggests the nearest name, for an unknown name
std::size_t position_of(const std::string &name,
                        const std::vector<std::string> &names,
                        const std::string &kind);

/// One of several values of an entry that have names.
template <typename Kind>
struct NamedChoice
{
  Kind kind;
  const char *name;    ///< in parameter files
  const char *purpose; ///< clause of the help text, which begins with a verb
};

/// Names of all @p choices, a container of NamedChoice.
template <typename Choices>
std::vector<std::string> names_of(const Choices &choices)
{
  std::vector<std::string> names;
  for (const auto &choice : choices)
    names.push_back(choice.name);
  return names;
}

/// What all @p choices are for: "NAME PURPOSE; NAME PURPOSE".
template <typename Choices>
std::string help_of(const Choices &choices)
{
  std::string help;
  for (const auto &choice : choices)
    help += (help.empty() ? "" : "; ") + std::string(choice.name) + " " +
            choice.purpose;
  return help;
}

/// The choice with this name.
/// @param what is chosen, for the message: "slope limiter"
/// @throws InputError that suggests the nearest name, for an unknown name
template <typename Choices>
auto find_choice(const Choices &choices,
                 const std::string &name,
                 const std::string &what)
{
  return choices[position_of(name, names_of(choices), what)].kind;
}
} // namespace contrecoup
