// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/leaf_origins.h>

#include <algorithm>
#include <stdexcept>

namespace contrecoup::gas
{
namespace
{
  /// Whether @p n levels from number @p first on exist and are @p level.
  bool are_all(const std::vector<unsigned char> &levels,
               const std::size_t first,
               const unsigned int n,
               const unsigned int level)
  {
    return first + n <= levels.size() &&
           std::all_of(
             levels.begin() + first,
             levels.begin() + first + n,
             [&](const unsigned int other) { return other == level; });
  }
} // namespace


template <int dim>
std::vector<unsigned char> leaf_levels(const LeafMesh<dim> &mesh)
{
  std::vector<unsigned char> levels;
  levels.reserve(mesh.n_owned());
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    levels.push_back(mesh.cell(leaf)->level());
  return levels;
}


template <int dim>
std::vector<LeafOrigin>
leaf_origins(const std::vector<unsigned char> &former_levels,
             const std::vector<unsigned char> &levels)
{
  using Change = LeafOrigin::Change;
  constexpr unsigned int n_children = 1U << dim;
  std::vector<LeafOrigin> origins;
  origins.reserve(levels.size());
  std::size_t former = 0;
  while (origins.size() < levels.size() && former < former_levels.size())
  {
    const std::size_t leaf = origins.size();
    const unsigned int level = levels[leaf], before = former_levels[former];
    const auto number = static_cast<unsigned int>(former);
    if (level == before)
    {
      origins.push_back({number, Change::none, 0});
      ++former;
    }
    else if (are_all(levels, leaf, n_children, before + 1))
    {
      for (unsigned char child = 0; child < n_children; ++child)
        origins.push_back({number, Change::refined, child});
      ++former;
    }
    else if (are_all(former_levels, former, n_children, level + 1))
    {
      origins.push_back({number, Change::merged, 0});
      former += n_children;
    }
    else
      break;
  }
  if (origins.size() < levels.size() || former < former_levels.size())
    throw std::logic_error("the leaves before and after an adaptation do not "
                           "match");
  return origins;
}


template std::vector<unsigned char> leaf_levels(const LeafMesh<1> &);
template std::vector<unsigned char> leaf_levels(const LeafMesh<2> &);
template std::vector<unsigned char> leaf_levels(const LeafMesh<3> &);
template std::vector<LeafOrigin>
leaf_origins<1>(const std::vector<unsigned char> &,
                const std::vector<unsigned char> &);
template std::vector<LeafOrigin>
leaf_origins<2>(const std::vector<unsigned char> &,
                const std::vector<unsigned char> &);
template std::vector<LeafOrigin>
leaf_origins<3>(const std::vector<unsigned char> &,
                const std::vector<unsigned char> &);
} // namespace contrecoup::gas
