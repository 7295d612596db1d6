// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/boundary/facet_search.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace contrecoup::solid
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  std::vector<Point<3>> places_of(const io::LoadFile::Facets &facets)
  {
    std::vector<Point<3>> places;
    for (std::size_t i = 0; i < facets.areas.size(); ++i)
      places.push_back(io::LoadFile::point_at(facets.centroids, i));
    return places;
  }
} // namespace


FacetSearch::FacetSearch(const io::LoadFile::Facets &facets, const double away)
  : facets_(facets)
  , away_(away)
  , places_(places_of(facets))
  , search_(places_)
{}


std::size_t FacetSearch::find(const Point<3> &place,
                              const Tensor<1, 3> &area) const
{
  constexpr std::size_t n_candidates = 12;
  constexpr double round_off = 1e-9; // [m]
  using Candidate = std::pair<double, std::size_t>;
  // Twice as many, to have all that are as near as the last candidate.
  std::vector<Candidate> near;
  for (const std::size_t found : search_.nearest(place, 2 * n_candidates))
    near.emplace_back(place.distance(places_[found]), found);
  std::sort(near.begin(), near.end());
  const double farthest =
    near[std::min(n_candidates, near.size()) - 1].first + round_off;
  Candidate best(std::numeric_limits<double>::max(), 0);
  for (const auto &[distance, facet] : near)
  {
    if (distance > farthest)
      break;
    const bool faces =
      area * Tensor<1, 3>(io::LoadFile::point_at(facets_.normals, facet)) > 0.;
    const Candidate here(distance + (faces ? 0. : away_), facet);
    if (here.first < best.first - round_off ||
        (here.first < best.first + round_off && facet < best.second))
      best = here;
  }
  return best.second;
}
} // namespace contrecoup::solid
