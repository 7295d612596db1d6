// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/image/head_segmentation.h>
#include <contrecoup/geometry/image/voxel_mask.h>

namespace contrecoup
{
void HeadRules::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_double(prm,
                 "Head threshold",
                 "0.25",
                 0.01,
                 1.,
                 "-",
                 "Brightness relative to the brain's median above which a "
                 "voxel belongs to the head.");
  declare_double(prm,
                 "Fluid threshold",
                 "0.45",
                 0.,
                 1.,
                 "-",
                 "Brightness relative to the brain's median below which a "
                 "voxel of the brain mask is fluid.");
  declare_double(prm,
                 "Closing radius",
                 "0.008",
                 0.,
                 0.1,
                 "m",
                 "Sulci of the brain and gaps of the head narrower than "
                 "twice this radius are closed.");
  declare_double(
    prm,
    "Fluid thickness",
    "0.002",
    0.,
    0.1,
    "m",
    "Thickness of the fluid between the closed brain and the skull.");
  declare_double(prm,
                 "Skull thickness",
                 "0.0065",
                 0.,
                 0.1,
                 "m",
                 "Thickness of the skull around brain and fluid.");
  declare_double(prm,
                 "Scalp thickness",
                 "0.003",
                 0.,
                 0.1,
                 "m",
                 "Least thickness of the scalp; the skull is made thinner "
                 "where necessary.");
}

void HeadRules::parse_parameters(dealii::ParameterHandler &prm)
{
  head_threshold = read_double(prm, "Head threshold");
  fluid_threshold = read_double(prm, "Fluid threshold");
  closing = read_double(prm, "Closing radius");
  fluid_thickness = read_double(prm, "Fluid thickness");
  skull_thickness = read_double(prm, "Skull thickness");
  scalp_thickness = read_double(prm, "Scalp thickness");
}

namespace
{
  VoxelMask above(const VoxelImage &image, const double threshold)
  {
    VoxelMask mask{image.size, image.spacing(), {}};
    for (const float value : image.values)
      mask.inside.push_back(value > threshold);
    return mask;
  }

  double median_within(const VoxelImage &image, const VoxelMask &mask)
  {
    std::vector<float> values;
    for (std::size_t i = 0; i < image.values.size(); ++i)
      if (mask.inside[i])
        values.push_back(image.values[i]);
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  void unite(VoxelMask &mask, const VoxelMask &other)
  {
    for (std::size_t i = 0; i < mask.inside.size(); ++i)
      mask.inside[i] |= other.inside[i];
  }
} // namespace

std::vector<HeadLabel> segment_head(const VoxelImage &image,
                                    const VoxelImage &mask_image,
                                    const HeadRules &rules)
{
  require_same_grid(image, mask_image);
  const VoxelMask brain = largest_piece(above(mask_image, 0.));
  if (brain.count() == 0)
    throw InputError("image \"" + mask_image.file +
                     "\": no voxel is above 0, the mask of the brain is "
                     "empty");
  const double median = median_within(image, brain);
  if (!(median > 0.))
    throw InputError("image \"" + image.file +
                     "\": half of the brain is not above 0");
  const VoxelMask cavity = grown(
    with_filled_holes(closed(brain, rules.closing)), rules.fluid_thickness);
  VoxelMask head = above(image, rules.head_threshold * median);
  unite(head, cavity);
  head = with_filled_holes(closed(largest_piece(head), rules.closing));

  const std::vector<float> to_cavity = distance_to(cavity);
  const std::vector<float> to_outside = distance_to(head.complement());
  std::vector<HeadLabel> labels(head.inside.size(), HeadLabel::outside);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (head.inside[i])
    {
      const bool is_bright = image.values[i] > rules.fluid_threshold * median;
      if (cavity.inside[i])
        labels[i] =
          brain.inside[i] && is_bright ? HeadLabel::brain : HeadLabel::fluid;
      else if (to_cavity[i] <= rules.skull_thickness &&
               to_outside[i] > rules.scalp_thickness)
        labels[i] = HeadLabel::skull;
      else
        labels[i] = HeadLabel::scalp;
    }
  return labels;
}
} // namespace contrecoup
