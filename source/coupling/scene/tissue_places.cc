// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/tissue_places.h>
#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/geometry/mesh/hex_quality.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace contrecoup::coupling
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Body sampled in cubes.
  class Samples
  {
  public:
    Samples(const Body &body, const double spacing)
      : body_(body)
      , grid_(make_grid(body.surface()->bounding_box(), spacing))
    {
      body.fill(grid_);
    }

    /// Calls @p work for the centre of each cube of a tissue.
    void for_each(const Tissue tissue,
                  const std::function<void(const Point<3> &)> &work) const
    {
      for (unsigned int k = 0; k < grid_.size[2]; ++k)
        for (unsigned int j = 0; j < grid_.size[1]; ++j)
          for (unsigned int i = 0; i < grid_.size[0]; ++i)
          {
            const unsigned char label = grid_.at(i, j, k);
            if (label != LabelGrid::outside &&
                body_.parts()[label].tissue == tissue)
              work(grid_.center(i, j, k));
          }
    }

    /// Mean of the centres of a tissue for which @p counts is true; nothing if
    /// there are none.
    std::optional<Point<3>>
    centroid(const Tissue tissue,
             const std::function<bool(const Point<3> &)> &counts) const
    {
      Tensor<1, 3> sum;
      double n = 0.;
      for_each(tissue, [&](const Point<3> &place) {
        if (!counts(place))
          return;
        sum += place;
        n += 1.;
      });
      if (n == 0.)
        return {};
      return Point<3>(sum / n);
    }

    /// Cube centre of a tissue nearest to @p place, where the mesh has an
    /// element of that tissue; @p place itself if the tissue is missing.
    Point<3> nearest(const Tissue tissue, const Point<3> &place) const
    {
      Point<3> result = place;
      double least = std::numeric_limits<double>::max();
      for_each(tissue, [&](const Point<3> &center) {
        const double distance = center.distance_square(place);
        // Among equally near positions the first one wins, whatever the
        // round-off.
        if (distance < least * (1. - 1e-9))
        {
          least = distance;
          result = center;
        }
      });
      return result;
    }

    bool is(const Tissue tissue, const Point<3> &place) const
    {
      const unsigned char part = body_.part_at(place);
      return part != LabelGrid::outside && body_.parts()[part].tissue == tissue;
    }

  private:
    const Body &body_;
    LabelGrid grid_;
  };


  /// Last position of a tissue on the ray from @p begin along @p direction.
  Point<3> last_of(const Samples &samples,
                   const Tissue tissue,
                   const Point<3> &begin,
                   const Tensor<1, 3> &direction,
                   const double spacing)
  {
    constexpr unsigned int most = 200;
    Point<3> last = begin;
    for (unsigned int i = 0; i < most; ++i)
    {
      const Point<3> place = begin + i * spacing * direction;
      if (samples.is(tissue, place))
        last = place;
    }
    return last;
  }


  void add_brain(const Samples &samples,
                 const Point<3> &from,
                 const double spacing,
                 std::vector<TissuePlace> &places)
  {
    const auto all = [](const Point<3> &) { return true; };
    const auto centre = samples.centroid(Tissue::brain, all);
    if (!centre)
      return;
    Tensor<1, 3> towards = from - *centre;
    towards[2] = 0.;
    towards /= std::max(towards.norm(), 1e-12);
    const double inside = 2. * spacing;
    const Point<3> front =
      last_of(samples, Tissue::brain, *centre, towards, spacing);
    const Point<3> back =
      last_of(samples, Tissue::brain, *centre, -towards, spacing);
    const auto add = [&](const std::string &name, const Point<3> &place) {
      places.push_back({name, samples.nearest(Tissue::brain, place)});
    };
    add("coup", front - inside * towards);
    add("brain", *centre);
    add("contrecoup", back + inside * towards);
    for (unsigned int i = 1; i < 20; ++i)
    {
      const Point<3> place = front + i * spacing * towards;
      if (samples.is(Tissue::skeleton, place))
      {
        places.push_back({"skull", samples.nearest(Tissue::skeleton, place)});
        break;
      }
    }
  }


  /// Adds mirror-symmetric positions in both lungs: the mean of one lung's
  /// centroid and the image of the other's, so that the histories on both sides
  /// of a symmetric body can be compared although its lungs differ.
  void add_lungs(const Samples &samples,
                 const Point<3> &middle,
                 const Tensor<1, 3> &to_left,
                 std::vector<TissuePlace> &places)
  {
    const auto side_of = [&](const double sign) {
      return samples.centroid(Tissue::lung, [&](const Point<3> &place) {
        return sign * ((place - middle) * to_left) > 0.;
      });
    };
    const auto image_of = [&](const Point<3> &place) {
      return place - 2. * ((place - middle) * to_left) * to_left;
    };
    const auto left = side_of(1.), right = side_of(-1.);
    if (!left && !right)
      return;
    const Point<3> mean = left && right
                            ? *left + 0.5 * (image_of(*right) - *left)
                            : (left ? *left : image_of(*right));
    if (left)
      places.push_back({"lung left", samples.nearest(Tissue::lung, mean)});
    if (right)
      places.push_back(
        {"lung right", samples.nearest(Tissue::lung, image_of(mean))});
  }
} // namespace


double estimate_mass(const Body &body,
                     const double spacing,
                     const std::function<double(Tissue)> &density)
{
  double mass = 0.;
  // Samples of oblique hexahedra would depend on how these are turned.
  if (const auto own = body.own_mesh())
  {
    for (std::size_t c = 0; c < own->cells.size(); ++c)
    {
      HexCorners corners;
      for (unsigned int v = 0; v < 8; ++v)
        corners[v] = own->nodes[own->cells[c][v]];
      mass += density(own->parts[own->part[c]].tissue) * volume(corners);
    }
    return mass;
  }
  LabelGrid grid = make_grid(body.surface()->bounding_box(), spacing);
  body.fill(grid);
  const auto &parts = body.parts();
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (const auto n = std::count(grid.labels.begin(),
                                  grid.labels.end(),
                                  static_cast<unsigned char>(i)))
      mass += density(parts[i].tissue) * static_cast<double>(n);
  return mass * grid.volume();
}


std::vector<TissuePlace>
find_tissue_places(const Body &body,
                   const Point<3> &from,
                   const std::optional<PersonAxes> &axes,
                   const double spacing)
{
  const Samples samples(body, spacing);
  std::vector<TissuePlace> places;
  add_brain(samples, from, spacing, places);
  Tensor<1, 3> to_left;
  to_left[1] = 1.;
  add_lungs(samples,
            body.surface()->bounding_box().center(),
            axes ? axes->left : to_left,
            places);
  const auto all = [](const Point<3> &) { return true; };
  if (const auto cord = samples.centroid(Tissue::spinal_cord, all))
    places.push_back(
      {"spinal cord", samples.nearest(Tissue::spinal_cord, *cord)});
  return places;
}
} // namespace contrecoup::coupling
