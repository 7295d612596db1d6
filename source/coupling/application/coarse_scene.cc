// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/coarse_scene.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::coupling
{
namespace
{
  /// Reduces an integer entry of the current subsection by @p levels, at most
  /// to 0.
  void lower(ParameterHandler &prm,
             const std::string &entry,
             const unsigned int levels)
  {
    const unsigned int value = read_unsigned(prm, entry);
    prm.set(entry, static_cast<long int>(value - std::min(value, levels)));
  }

  /// How often the coarse leaves can be halved in all directions. Meshes of
  /// larger leaves have the levels of the scene wherever it has them.
  unsigned int exact_halvings(const ParameterHandler &prm)
  {
    if (prm.get("Mesh") != "box")
      return 0;
    std::vector<std::string> words = split(prm.get("Coarse leaves"), ',');
    words.resize(read_unsigned(prm, "Dimension"), "1");
    unsigned int times = 0;
    while (std::all_of(words.begin(), words.end(), [&](const auto &word) {
      return std::stol(word) % (2L << times) == 0;
    }))
      ++times;
    return times;
  }

  /// Halves the number of coarse leaves per direction @p times; returns
  /// whether the last time changed any.
  bool halve_leaves(ParameterHandler &prm, const unsigned int times)
  {
    bool changed = times == 0;
    std::vector<std::string> words;
    for (const std::string &word : split(prm.get("Coarse leaves"), ','))
    {
      const long int leaves = std::stol(word);
      const auto after = [&](const unsigned int n) {
        return static_cast<long int>(std::ceil(leaves / std::pow(2., n)));
      };
      words.push_back(std::to_string(after(times)));
      changed = changed || after(times) < after(times - 1);
    }
    prm.set("Coarse leaves", join(words, ", "));
    return changed;
  }


  /// Lowers the refinement levels at the body, which coarse leaves may then
  /// miss.
  void coarsen_body(ParameterHandler &prm, const unsigned int levels)
  {
    const Section section(prm, "Rigid body");
    prm.set("Required", "false");
    lower(prm, "Levels", levels);
    for (const std::string &name : item_names(prm, "Rigid body/Finer region"))
    {
      const Section region(prm, "Finer region " + name);
      lower(prm, "Levels", levels);
    }
  }
} // namespace


bool coarsen_scene(ParameterHandler &prm, const unsigned int all_levels)
{
  unsigned int halvings = 0;
  {
    const Section section(prm, "Domain");
    halvings = std::min(all_levels, exact_halvings(prm));
  }
  const unsigned int levels = all_levels - halvings;
  unsigned int refinements = 0;
  bool adapts = false;
  {
    const Section section(prm, "Adaptation");
    adapts = prm.get_bool("Active");
    if (adapts)
      refinements = read_unsigned(prm, "Largest level");
    lower(prm, "Largest level", levels);
    lower(prm, "Smallest level", levels);
    lower(prm, "Fine box levels", levels);
  }
  for (const std::string &name : item_names(prm, "Adaptation/Limit"))
  {
    const Section section(prm, "Adaptation");
    const Section limit(prm, "Limit " + name);
    lower(prm, "Largest level", levels);
    lower(prm, "Smallest level", levels);
  }
  {
    const Section section(prm, "First stage");
    for (const std::string entry : {"Cell size", "Spherical cell size"})
      prm.set(entry, read_double(prm, entry) * std::pow(2., all_levels));
  }
  unsigned int initial = 0;
  {
    const Section section(prm, "Domain");
    initial = read_unsigned(prm, "Initial refinement");
    lower(prm, "Initial refinement", levels);
  }
  refinements = adapts ? std::max(refinements, initial) : initial;
  // Levels that neither a lower initial refinement nor fewer coarse leaves
  // removes.
  coarsen_body(prm, std::min(levels, refinements) - std::min(levels, initial));
  const Section section(prm, "Domain");
  halvings += levels - std::min(levels, refinements);
  return prm.get("Mesh") == "box" ? halve_leaves(prm, halvings) : halvings == 0;
}
} // namespace contrecoup::coupling
