// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/inserted_organs.h>

#include <random>

namespace contrecoup
{
using dealii::Point;

namespace
{
  bool is_organ(const BodyPart &part)
  {
    return part.tissue != Tissue::skin && part.tissue != Tissue::soft_tissue;
  }


  /// Fraction of the organs' volume outside of a surface, by sampling.
  double part_outside(const ShapeBody &organs, const Shape &surface)
  {
    const unsigned int n_samples = 200000;
    const auto box = organs.surface()->bounding_box();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0., 1.);
    double n_all = 0., n_outside = 0.;
    for (unsigned int i = 0; i < n_samples; ++i)
    {
      Point<3> point;
      for (unsigned int d = 0; d < 3; ++d)
        point[d] = box.lower_bound(d) + place(random) * box.side_length(d);
      const unsigned char part = organs.part_at(point);
      if (part == LabelGrid::outside || !is_organ(organs.parts()[part]))
        continue;
      n_all += 1.;
      n_outside += surface.value(point) > 0. ? 1. : 0.;
    }
    return n_all > 0. ? n_outside / n_all : 0.;
  }
} // namespace


BodyPointer insert_organs(const Body &recipient,
                          const ShapeBody &donor,
                          const double largest_loss)
{
  const ShapePointer skin = recipient.surface();
  const auto box = skin->bounding_box();
  const auto original = donor.surface()->bounding_box();
  const double scale = box.side_length(2) / original.side_length(2);
  dealii::Tensor<1, 3> shift = box.center() - scale * original.center();
  const auto placed = std::dynamic_pointer_cast<const ShapeBody>(
    donor.placed(Placement(scale, dealii::Tensor<1, 3>(), shift)));
  const double lost = part_outside(*placed, *skin);
  if (lost > largest_loss)
    throw InputError(
      "Body/Surface/Organs = phantom: " + brief(100. * lost, 3) +
      " % of the organs' volume would be outside of the surface, allowed "
      "are " +
      brief(100. * largest_loss, 3) +
      " %; does the person stand upright, face +x and reach from the soles to "
      "the vertex?");
  std::vector<ShapeBody::PartShape> part_shapes;
  for (const ShapeBody::PartShape &part_shape : placed->part_shapes())
    if (is_organ(part_shape.part))
      part_shapes.push_back(part_shape);
  part_shapes.push_back({recipient.parts()[0], skin});
  const auto body = std::make_shared<ShapeBody>(skin, part_shapes);
  auto remarks = recipient.remarks();
  remarks.push_back("organs are those of the phantom, " + brief(scale) +
                    " times as large; they are not this person's. " +
                    brief(100. * lost, 2) +
                    " % of their volume was outside and is left out");
  body->set_remarks(remarks);
  std::vector<Landmark> landmarks = placed->landmarks();
  for (Landmark &landmark : landmarks)
    landmark.place = skin->project(landmark.place);
  body->set_landmarks(landmarks);
  return body;
}
} // namespace contrecoup
