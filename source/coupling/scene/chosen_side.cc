// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/chosen_side.h>

#include <map>

namespace contrecoup::coupling
{
std::string ChosenSide::in_words(const SceneLayout &layout) const
{
  return kind + " at " + name.substr(0, 1) + " = " + brief(place(layout)) +
         " m";
}


std::vector<ChosenSide> find_chosen_sides(const std::vector<Assignment> &wrote,
                                          const SceneLayout &layout)
{
  std::map<std::string, ChosenSide> chosen; // the last assignment counts
  for (const Assignment &assignment : wrote)
    if (join(assignment.sections, "/") == "Blast/Boundaries")
      for (unsigned int d = 0; d < 3; ++d)
        for (const bool is_high : {false, true})
        {
          const std::string name =
            std::string(1, "xyz"[d]) + (is_high ? " high" : " low");
          if (assignment.entry == name)
            chosen[name] = {name, trim(assignment.value), d, is_high};
        }
  std::vector<ChosenSide> sides;
  for (const auto &[name, side] : chosen)
  {
    const std::string own = name == "z low"                     ? "wall"
                            : name == "y low" && layout.is_half ? "symmetry"
                                                                : "open";
    if (side.kind != own && !(own == "symmetry" && side.kind == "wall"))
      sides.push_back(side);
  }
  return sides;
}
} // namespace contrecoup::coupling
