// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * Translates entry names in messages of a task to the names that the user of
 * the scene knows: the entry of the scene that determines a task's entry or,
 * where the scene chose it or the user wrote it, its name in the section of
 * the task.
 */
class SceneWords
{
public:
  /// Identity: changes nothing.
  SceneWords() = default;

  /**
   * @param section section of the scene's file with the task's entries
   * @param entries entries chosen by the scene; an origin is the entry of the
   * scene that determines the entry, or empty
   * @param sections sections of the task and the section of the scene that
   * stands for each
   * @param wrote all assignments of the user
   * @param stage parameters of the task
   */
  SceneWords(const std::string &section,
             const std::vector<Assignment> &entries,
             const std::map<std::string, std::string> &sections,
             const std::vector<Assignment> &wrote,
             const dealii::ParameterHandler &stage);

  /// Sets the name of one entry of the task.
  void rename(const std::string &entry, const std::string &name);

  /// Translates a message of the task. If it begins with a section or an
  /// entry, names without a section belong to that section.
  std::string operator()(const std::string &text) const;

private:
  /// Beginning of a message.
  struct Head
  {
    std::string section;    ///< section of the task; empty: none
    std::string name;       ///< name of the section in the scene
    std::size_t length = 0; ///< characters of the section; 0 before an entry
  };
  Head head_of(const std::string &text) const;
  void read_head(const std::string &begin, Head &head) const;

  /// Longest entry name at position @p place of @p text and its translation.
  const std::pair<const std::string, std::string> *
  name_at(const std::string &text, std::size_t place) const;

  std::map<std::string, std::string> entries_;  ///< by name in the task
  std::map<std::string, std::string> sections_; ///< by name in the task
};
} // namespace contrecoup::coupling
