// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * What the entries of a stage are called by somebody who wrote a scene: the
 * entry of the scene that they follow from, or, where the scene chose them by
 * itself or the user wrote them, their name in the section of the stage.
 */
class SceneWords
{
public:
  /// Those of no stage, which change nothing.
  SceneWords() = default;

  /**
   * @param section of the scene's file that has the stage's entries
   * @param entries of the scene's choice, whose origins are the entries of the
   *   scene that they follow from, or empty
   * @param sections of the stage, and what the scene has for the whole of them
   * @param wrote all that the user wrote
   * @param stage the stage's parameters
   */
  SceneWords(const std::string &section,
             const std::vector<Assignment> &entries,
             const std::map<std::string, std::string> &sections,
             const std::vector<Assignment> &wrote,
             const dealii::ParameterHandler &stage);

  /// Names an entry of the stage by itself.
  void rename(const std::string &entry, const std::string &name);

  /// A message or line of the stage with these names in it. Where it begins
  /// with a section or an entry, names without a section are of that one.
  std::string operator()(const std::string &text) const;

private:
  /// What a message begins with.
  struct Head
  {
    std::string section;    ///< of the stage; empty without one
    std::string name;       ///< what the scene has for that
    std::size_t length = 0; ///< that it takes; 0 where an entry begins
  };
  Head head_of(const std::string &text) const;
  void read_head(const std::string &begin, Head &head) const;

  /// The longest of the names that stands at this place, and how it is called.
  const std::pair<const std::string, std::string> *
  name_at(const std::string &text, std::size_t place) const;

  std::map<std::string, std::string> entries_;  ///< stage's, scene's
  std::map<std::string, std::string> sections_; ///< stage's, scene's
};
} // namespace contrecoup::coupling
