// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/io/output/load_reader.h>
#include <contrecoup/solid/boundary/load_alignment.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::solid
{
namespace
{
  using dealii::Point;
  using dealii::Tensor;

  /// Largest number of facets in the means; more change nothing.
  constexpr std::size_t max_sampled_facets = 4000;

  /// Centre of the bounding box of facets and their mirror images.
  Point<3> middle_of_facets(const io::LoadFile::Facets &facets,
                            const std::array<bool, 3> &mirrored)
  {
    Point<3> lower = io::LoadFile::point_at(facets.centroids, 0), upper = lower;
    for (std::size_t i = 0; i < facets.areas.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double place = facets.centroids[3 * i + d];
        const double image = mirrored[d] ? -place : place;
        lower[d] = std::min({lower[d], place, image});
        upper[d] = std::max({upper[d], place, image});
      }
    return lower + 0.5 * (upper - lower);
  }


  /// The body to mesh, or null.
  BodyPointer read_body(ParameterHandler &prm)
  {
    {
      const Section section(prm, "Mesh");
      if (prm.get("Kind") != "body")
        return nullptr;
    }
    const Section section(prm, "Body");
    BodyDescription description;
    description.parse_parameters(prm);
    return description.create();
  }


  /// Three coordinates, rounded to 0.1 mm.
  std::string text_of(const Tensor<1, 3> &vector)
  {
    std::vector<std::string> numbers;
    for (unsigned int d = 0; d < 3; ++d)
      numbers.push_back(brief(1e-4 * std::round(1e4 * vector[d]) + 0., 3));
    return join(numbers, ", ");
  }


  std::string text_of(const LoadAlignment &alignment,
                      const double largest_misfit)
  {
    return "its facets, " + brief(1e3 * alignment.facet_edge, 3) +
           " mm wide, are in the mean " + brief(1e3 * alignment.distance, 3) +
           " mm off the body's surface (Largest misfit = " +
           brief(largest_misfit) + " allows " +
           brief(1e3 * largest_misfit * alignment.facet_edge, 3) +
           " mm), the cosine between normals is " +
           brief(alignment.agreement, 2) + ", and their middle is " +
           text_of(alignment.offset) + " m from the body's";
  }
} // namespace


LoadAlignment measure_load_alignment(const io::LoadFile::Facets &facets,
                                     const Shape &surface,
                                     const std::array<bool, 3> &mirrored)
{
  LoadAlignment alignment;
  const std::size_t n_facets = facets.areas.size();
  const std::size_t stride = 1 + n_facets / max_sampled_facets;
  double area = 0.;
  for (std::size_t i = 0; i < n_facets; i += stride)
  {
    const Point<3> middle = io::LoadFile::point_at(facets.centroids, i);
    const Point<3> foot = surface.project(middle);
    area += facets.areas[i];
    alignment.distance += facets.areas[i] * middle.distance(foot);
    alignment.agreement +=
      facets.areas[i] *
      (Tensor<1, 3>(io::LoadFile::point_at(facets.normals, i)) *
       surface.normal(foot));
  }
  if (!(area > 0.))
    return alignment;
  alignment.distance /= area;
  alignment.agreement /= area;
  alignment.facet_edge = std::sqrt(area * static_cast<double>(stride) /
                                   static_cast<double>(n_facets));
  alignment.offset =
    middle_of_facets(facets, mirrored) - surface.bounding_box().center();
  return alignment;
}


void require_mirror(const io::LoadReader &loads,
                    const std::array<bool, 3> &mirrored,
                    const dealii::BoundingBox<3> &box)
{
  if (!loads.symmetry())
    return;
  std::vector<std::string> recorded, asked;
  std::string reason;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const std::string axis(1, "xyz"[d]);
    const bool is_half = (*loads.symmetry())[d];
    // Elements at a plane of symmetry may lie partly beyond it.
    const double least = 0.05 * box.side_length(d);
    const bool is_whole =
      box.lower_bound(d) < -least && box.upper_bound(d) > least;
    if (is_half)
      recorded.push_back(axis);
    if (mirrored[d])
      asked.push_back(axis);
    if (mirrored[d] && !is_half)
      reason = "the loads were recorded on both sides of " + axis + " = 0";
    else if (is_half && !mirrored[d] && is_whole)
      reason = "the loads were recorded on one side of the plane of symmetry " +
               axis + " = 0, and the body is on both";
  }
  if (!reason.empty())
    throw InputError("Loads/Recorded/Mirror = " +
                     (asked.empty() ? "none" : join(asked, " and ")) + ": " +
                     reason + "; Mirror must be " +
                     (recorded.empty() ? "none" : join(recorded, " and ")));
}


void check_load_alignment(ParameterHandler &prm)
{
  std::string file;
  std::array<bool, 3> mirrored{};
  double largest_misfit = 0.;
  {
    const Section section(prm, "Loads");
    const Section recorded(prm, "Recorded");
    file = prm.get("File");
    const std::string mirror = prm.get("Mirror");
    for (unsigned int d = 0; d < 3; ++d)
      mirrored[d] =
        mirror != "none" && mirror.find("xyz"[d]) != std::string::npos;
    largest_misfit = read_double(prm, "Largest misfit");
  }
  if (file.empty())
    return;
  const BodyPointer body = read_body(prm);
  if (!body)
    return;
  const io::LoadReader loads(file);
  const LoadAlignment alignment =
    measure_load_alignment(loads.facets(), *body->surface(), mirrored);
  if (!(alignment.distance <= largest_misfit * alignment.facet_edge) ||
      !(alignment.agreement > 0.))
    throw InputError("Loads/Recorded/File = \"" + file +
                     "\" is not of this body where it is: " +
                     text_of(alignment, largest_misfit) +
                     "; Body must be that of the blast, whose parameters.prm "
                     "has its Shift, Rotation and Scale");
  require_mirror(loads, mirrored, body->surface()->bounding_box());
}
} // namespace contrecoup::solid
