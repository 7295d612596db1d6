// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>
#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

namespace contrecoup
{
using dealii::Point;

/// A cube of voxels, and the shapes that may contain some of them.
struct ShapeBody::Block
{
  std::array<unsigned int, 3> begin;
  unsigned int width; ///< voxels along an edge, a power of 2
  std::vector<unsigned char> shapes;
  bool meets_surface;
};

ShapeBody::ShapeBody(ShapePointer surface,
                     const std::vector<PartShape> &part_shapes)
  : surface_(std::move(surface))
{
  AssertThrow(part_shapes.size() < LabelGrid::outside,
              dealii::ExcInternalError());
  for (const PartShape &part_shape : part_shapes)
  {
    parts_.push_back(part_shape.part);
    shapes_.push_back(part_shape.shape);
  }
}

BodyPointer ShapeBody::placed(const Placement &placement) const
{
  std::vector<PartShape> part_shapes;
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    part_shapes.push_back(
      {parts_[i], std::make_shared<PlacedShape>(shapes_[i], placement)});
  const auto body = std::make_shared<ShapeBody>(
    PlacedShape::in_own_box(surface_, placement), part_shapes);
  body->set_remarks(remarks());
  std::vector<Landmark> moved = landmarks();
  for (Landmark &landmark : moved)
    landmark.place = placement.apply(landmark.place);
  body->set_landmarks(moved);
  std::optional<OrganFit> fit = organ_fit();
  if (fit)
  {
    fit->brain_cover *= placement.scale();
    fit->lung_cover *= placement.scale();
  }
  body->set_organ_fit(fit);
  return body;
}

std::vector<ShapeBody::PartShape> ShapeBody::part_shapes() const
{
  std::vector<PartShape> result;
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    result.push_back({parts_[i], shapes_[i]});
  return result;
}

ShapePointer ShapeBody::surface() const
{
  return surface_;
}

unsigned char ShapeBody::part_at(const Point<3> &point) const
{
  if (surface_->value(point) <= 0.)
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (shapes_[i]->value(point) <= 0.)
        return i;
  return LabelGrid::outside;
}

void ShapeBody::fill(LabelGrid &grid) const
{
  constexpr unsigned int width = 32;
  std::vector<unsigned char> all(shapes_.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  for (unsigned int k = 0; k < grid.size[2]; k += width)
    for (unsigned int j = 0; j < grid.size[1]; j += width)
      for (unsigned int i = 0; i < grid.size[0]; i += width)
        fill_block(grid, {{{i, j, k}}, width, all, true});
}

void ShapeBody::fill_block(LabelGrid &grid, const Block &block) const
{
  const double half_width = 0.5 * block.width * grid.spacing;
  Point<3> center = grid.origin;
  std::array<unsigned int, 3> end;
  for (unsigned int d = 0; d < 3; ++d)
  {
    if (block.begin[d] >= grid.size[d])
      return;
    center[d] += block.begin[d] * grid.spacing + half_width;
    end[d] = std::min(block.begin[d] + block.width, grid.size[d]);
  }
  // All voxel centres lie in a ball of this radius, in which the value of a
  // shape changes by at most the radius.
  const double radius = std::sqrt(3.) * 0.5 * (block.width - 1) * grid.spacing;

  Block child{block.begin, block.width / 2, {}, false};
  if (block.meets_surface)
  {
    const double value = surface_->value(center);
    if (value > radius)
      return;
    child.meets_surface = value > -radius;
  }
  bool is_covered = false;
  for (const unsigned char i : block.shapes)
  {
    const double value = shapes_[i]->value(center);
    if (value > radius)
      continue;
    child.shapes.push_back(i);
    is_covered = value <= -radius;
    if (is_covered)
      break;
  }
  if (child.shapes.empty())
    return;
  if (is_covered && child.shapes.size() == 1 && !child.meets_surface)
  {
    for (unsigned int k = block.begin[2]; k < end[2]; ++k)
      for (unsigned int j = block.begin[1]; j < end[1]; ++j)
        for (unsigned int i = block.begin[0]; i < end[0]; ++i)
          grid.labels[grid.index(i, j, k)] = child.shapes.front();
    return;
  }
  if (block.width == 1)
  {
    grid.labels[grid.index(block.begin[0], block.begin[1], block.begin[2])] =
      child.shapes.front();
    return;
  }
  for (unsigned int c = 0; c < 8; ++c)
  {
    for (unsigned int d = 0; d < 3; ++d)
      child.begin[d] = block.begin[d] + ((c >> d) & 1) * child.width;
    fill_block(grid, child);
  }
}

void log_warnings(const Body &body)
{
  for (const std::string &remark : body.remarks())
    if (remark.rfind("WARNING: ", 0) == 0)
      log_line(remark);
}

LabelGrid fill_shape(const Shape &shape, const double spacing)
{
  const auto box = shape.bounding_box();
  LabelGrid grid = make_grid(box, spacing);
  // A part that contains everything is evaluated faster than the shape.
  const double far = 10. * box.get_boundary_points().first.distance(
                             box.get_boundary_points().second);
  const auto all =
    std::make_shared<RoundedBox>(box.center(), Point<3>(far, far, far));
  const ShapePointer unowned(ShapePointer(), &shape);
  ShapeBody(unowned, {{{"", Tissue::none}, all}}).fill(grid);
  return grid;
}
} // namespace contrecoup
