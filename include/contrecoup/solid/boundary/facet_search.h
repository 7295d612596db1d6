// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/place_search.h>
#include <contrecoup/io/output/load_file.h>

#include <deal.II/base/point.h>

#include <cstddef>
#include <vector>

namespace contrecoup::solid
{
/// Finds recorded facets near a place that face to its side.
class FacetSearch
{
public:
  /// @param facets must outlive this
  /// @param away by how much facets that face away count as farther [m]
  FacetSearch(const io::LoadFile::Facets &facets, double away);

  /// The nearest of the facets around @p place [m], of at least one, for an
  /// @p area vector there. The first of facets that are as near counts, so that
  /// the order of a search tree decides nothing.
  std::size_t find(const dealii::Point<3> &place,
                   const dealii::Tensor<1, 3> &area) const;

private:
  const io::LoadFile::Facets &facets_;
  double away_;
  std::vector<dealii::Point<3>> places_;
  PlaceSearch search_;
};
} // namespace contrecoup::solid
