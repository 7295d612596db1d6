// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/own_grid.h>

#include <cstdlib>
#include <map>

namespace contrecoup::coupling
{
using dealii::Point;

std::optional<Point<3>> point_of(const std::string &text)
{
  const std::vector<std::string> words = split(text, ',');
  if (words.size() != 3)
    return {};
  Point<3> point;
  for (unsigned int d = 0; d < 3; ++d)
  {
    char *end = nullptr;
    point[d] = std::strtod(words[d].c_str(), &end);
    if (words[d].empty() || *end != '\0')
      return {};
  }
  return point;
}


OwnGrid OwnGrid::find(const std::vector<Assignment> &wrote)
{
  std::map<std::string, std::string> values; // the last assignment counts
  for (const Assignment &one : wrote)
    values[join(one.sections, "/") + "/" + one.entry] = trim(one.value);
  const auto point = [&](const std::string &entry) {
    const auto found = values.find("Blast/" + entry);
    return found == values.end() ? std::optional<Point<3>>()
                                 : point_of(found->second);
  };
  const auto is_other = [&](const std::string &side, const std::string &own) {
    const auto found = values.find("Blast/Boundaries/" + side);
    return found != values.end() && found->second != own;
  };
  OwnGrid own;
  own.lower = point("Domain/Lower corner");
  own.upper = point("Domain/Upper corner");
  if (const auto leaves = point("Domain/Coarse leaves"))
    own.n_leaves =
      std::array<unsigned int, 3>{{static_cast<unsigned int>((*leaves)[0]),
                                   static_cast<unsigned int>((*leaves)[1]),
                                   static_cast<unsigned int>((*leaves)[2])}};
  const bool is_mirrored = values.count("Blast/Boundaries/y low") > 0;
  own.has_unlike_sides = is_other("y low", "symmetry") ||
                         (is_other("y high", "open") && !is_mirrored);
  own.has_ground = !is_other("z low", "wall") || !is_other("z low", "symmetry");
  return own;
}
} // namespace contrecoup::coupling
