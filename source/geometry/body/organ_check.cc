// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/organ_check.h>
#include <contrecoup/geometry/mesh/hex_quality.h>

#include <algorithm>

namespace contrecoup
{
namespace
{
  bool belongs_to(const OrganReference &reference, const std::string &part)
  {
    const auto &parts = reference.parts;
    return parts.empty() ||
           std::find(parts.begin(), parts.end(), part) != parts.end();
  }

  std::string told_difference(const OrganCheck &check)
  {
    if (check.volume == 0.)
      return check.reference.name + " without an element";
    const double percent = 100. * check.difference();
    return check.reference.name + (percent > 0. ? " +" : " ") +
           brief(percent, 2) + " %";
  }
} // namespace


std::vector<OrganCheck>
check_organs(const HexMesh &mesh, const std::vector<OrganReference> &references)
{
  const std::vector<HexQuality> qualities = measure_quality(mesh);
  std::vector<OrganCheck> checks;
  for (const OrganReference &reference : references)
  {
    OrganCheck check{reference, 0.};
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
      if (belongs_to(reference, mesh.parts[i].name))
        check.volume += qualities[i].volume;
    checks.push_back(check);
  }
  return checks;
}


std::string organ_warning(const std::vector<OrganCheck> &checks)
{
  constexpr double most = 0.1;
  std::vector<std::string> words;
  std::string source;
  for (const OrganCheck &check : checks)
    if (!(std::abs(check.difference()) <= most))
    {
      words.push_back(told_difference(check));
      source = check.reference.source;
    }
  if (words.empty())
    return "";
  return "WARNING: the elements' volumes differ by more than " +
         brief(100. * most) + " % from those of " +
         source.substr(0, source.find(" (")) + ": " + join(words, ", ") +
         "; a smaller Mesh/Element size brings them closer";
}
} // namespace contrecoup
