// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/place_search.h>

#include <deal.II/numerics/rtree.h>

#include <utility>

namespace contrecoup
{
using dealii::Point;

struct PlaceSearch::Tree
{
  dealii::RTree<std::pair<Point<3>, std::size_t>> places;
};


PlaceSearch::PlaceSearch(const std::vector<Point<3>> &places)
{
  std::vector<std::pair<Point<3>, std::size_t>> entries;
  for (const Point<3> &place : places)
    entries.emplace_back(place, entries.size());
  tree_ = std::make_shared<Tree>(Tree{dealii::pack_rtree(entries)});
}


std::vector<std::size_t> PlaceSearch::nearest(const Point<3> &point,
                                              const unsigned int n) const
{
  std::vector<std::size_t> found;
  const auto query = boost::geometry::index::nearest(point, n);
  for (auto entry = tree_->places.qbegin(query); entry != tree_->places.qend();
       ++entry)
    found.push_back(entry->second);
  return found;
}
} // namespace contrecoup
