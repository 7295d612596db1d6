// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/image_body.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/grid_distance.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr unsigned int largest_label = 1000000;

  unsigned int parse_label(const std::string &text, const std::string &row)
  {
    if (text.empty() || text.size() > 6 ||
        text.find_first_not_of("0123456789") != std::string::npos)
      throw InputError("Body/Image/Labels, row \"" + row + "\": \"" + text +
                       "\" is not a label; whole numbers from 0 to " +
                       std::to_string(largest_label - 1) + " are");
    return std::stoul(text);
  }

  LabelRow parse_row(const std::string &text)
  {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos)
      throw InputError("Body/Image/Labels, row \"" + text +
                       "\": must read \"label: tissue\" or \"first-last: name "
                       "= tissue\"");
    const std::vector<std::string> ends = split(text.substr(0, colon), '-');
    const std::vector<std::string> names = split(text.substr(colon + 1), '=');
    if (ends.empty() || ends.size() > 2 || names.empty() || names.size() > 2)
      throw InputError("Body/Image/Labels, row \"" + text +
                       "\": must read \"label: tissue\" or \"first-last: name "
                       "= tissue\"");
    LabelRow row;
    row.first = parse_label(ends.front(), text);
    row.last = parse_label(ends.back(), text);
    if (row.last < row.first)
      throw InputError("Body/Image/Labels, row \"" + text +
                       "\": its last label is below its first");
    row.part.name = names.front();
    try
    {
      row.part.tissue = find_tissue(names.back());
    }
    catch (const InputError &error)
    {
      throw InputError("Body/Image/Labels, row \"" + text +
                       "\": " + error.what());
    }
    return row;
  }

  /// Part number of each label.
  std::vector<unsigned char> tabulate(const std::vector<LabelRow> &table)
  {
    unsigned int last = 0;
    for (const LabelRow &row : table)
      last = std::max(last, row.last);
    std::vector<unsigned char> part(last + 1, LabelGrid::outside);
    for (std::size_t i = 0; i < table.size(); ++i)
      for (unsigned int label = table[i].first; label <= table[i].last; ++label)
        part[label] = i;
    return part;
  }

  /// Whether the table names each label; 0 (background) counts as named.
  std::vector<bool> known_labels(const std::vector<LabelRow> &table,
                                 const std::size_t count)
  {
    std::vector<bool> known(count, false);
    known[0] = true;
    for (const LabelRow &row : table)
      for (unsigned int label = row.first; label <= row.last; ++label)
        known[label] = true;
    return known;
  }
} // namespace


std::vector<LabelRow> parse_label_table(const std::string &text)
{
  std::vector<LabelRow> table;
  for (const std::string &row : split(text, ';'))
    if (!row.empty())
      table.push_back(parse_row(row));
  if (table.empty())
    throw InputError("Body/Image/Labels is empty: it must name the labels of "
                     "the image, such as \"1: brain; 2-5: skeleton\"");
  if (table.size() >= LabelGrid::outside)
    throw InputError("Body/Image/Labels has " + std::to_string(table.size()) +
                     " rows, at most 254 are allowed");
  return table;
}


ImageBody::ImageBody(const VoxelImage &image,
                     const std::vector<unsigned char> &labels,
                     const std::vector<BodyPart> &parts)
  : size_(image.size)
  , to_index_(invert(image.axes))
  , origin_(image.origin)
  , labels_(std::make_shared<const std::vector<unsigned char>>(labels))
{
  parts_ = parts;
  VoxelMask mask{image.size, image.spacing(), {}};
  for (const unsigned char label : labels)
    mask.inside.push_back(label != LabelGrid::outside);
  if (mask.count() == 0)
    throw InputError("image \"" + image.file +
                     "\": no voxel belongs to a part of the body");
  const double skewness =
    1. - std::abs(determinant(image.axes)) /
           (mask.spacing[0] * mask.spacing[1] * mask.spacing[2]);
  if (skewness > 1e-3)
    throw InputError("image \"" + image.file +
                     "\": its axes are not at right angles to each other");
  surface_ = std::make_shared<GridDistance>(mask, image.axes, image.origin);
}

BodyPointer ImageBody::placed(const Placement &placement) const
{
  const auto body = std::make_shared<ImageBody>(*this);
  body->placements_.push_back(placement);
  body->surface_ = std::make_shared<PlacedShape>(surface_, placement);
  return body;
}

ShapePointer ImageBody::surface() const
{
  return surface_;
}

unsigned char ImageBody::part_at(const Point<3> &point) const
{
  Point<3> source = point;
  for (auto placement = placements_.rbegin(); placement != placements_.rend();
       ++placement)
    source = placement->pull_back(source);
  const Tensor<1, 3> index = to_index_ * (source - origin_);
  std::array<std::size_t, 3> voxel;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double nearest = std::floor(index[d] + 0.5);
    if (!(nearest >= 0. && nearest < size_[d]))
      return LabelGrid::outside;
    voxel[d] = static_cast<std::size_t>(nearest);
  }
  return (*labels_)[voxel[0] + size_[0] * (voxel[1] + size_[1] * voxel[2])];
}

void ImageBody::fill(LabelGrid &grid) const
{
  for (unsigned int k = 0; k < grid.size[2]; ++k)
    for (unsigned int j = 0; j < grid.size[1]; ++j)
      for (unsigned int i = 0; i < grid.size[0]; ++i)
        grid.labels[grid.index(i, j, k)] = part_at(grid.center(i, j, k));
}


void ImageDescription::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_selection(
    prm,
    "Kind",
    "labels",
    {"labels", "t1 and brain mask"},
    "A label map, or a T1-weighted image of a head with a brain mask.");
  declare_file(
    prm, "File", "", "NIfTI-1 image: .nii, .nii.gz, or .hdr beside its .img.");
  declare_file(prm,
               "Brain mask",
               "",
               "NIfTI-1 image with the same voxels as the T1-weighted "
               "image, positive inside the brain.");
  declare_string(prm,
                 "Labels",
                 "",
                 "Tissue of each label, such as \"1: brain; 2-5: skeleton; "
                 "7: scalp = soft tissue\"; none excludes a label from the "
                 "body, as is label 0 unless named.");
  const Section section(prm, "Head");
  HeadRules::declare_parameters(prm);
}

void ImageDescription::parse_parameters(dealii::ParameterHandler &prm)
{
  kind_ = prm.get("Kind");
  file_ = prm.get("File");
  mask_file_ = prm.get("Brain mask");
  if (file_.empty())
    throw InputError("Body/Image/File is empty: it must name an image");
  if (kind_ == "labels")
    table_ = parse_label_table(prm.get("Labels"));
  else if (mask_file_.empty())
    throw InputError("Body/Image/Brain mask is empty: a T1-weighted image "
                     "needs one");
  const Section section(prm, "Head");
  rules_.parse_parameters(prm);
}

BodyPointer ImageDescription::create() const
{
  return kind_ == "labels" ? create_from_labels() : create_head();
}

BodyPointer ImageDescription::create_from_labels() const
{
  const VoxelImage image = read_image(file_);
  const std::vector<unsigned char> part_of = tabulate(table_);
  const std::vector<bool> known = known_labels(table_, part_of.size());
  std::vector<unsigned char> labels;
  labels.reserve(image.values.size());
  for (const float value : image.values)
  {
    if (value < 0.F || value != std::floor(value))
      throw InputError("image \"" + file_ + "\": " + brief(value) +
                       " is not a label; they are whole numbers from 0");
    const std::size_t label =
      std::min<float>(value, static_cast<float>(largest_label));
    if (label >= known.size() || !known[label])
      throw InputError("image \"" + file_ + "\" has voxels with the label " +
                       brief(value, 7) +
                       ", which Body/Image/Labels does not "
                       "name");
    const unsigned char part = part_of[label];
    const bool is_body =
      part != LabelGrid::outside && table_[part].part.tissue != Tissue::none;
    labels.push_back(is_body ? part : LabelGrid::outside);
  }
  std::vector<BodyPart> parts;
  for (const LabelRow &row : table_)
    parts.push_back(row.part);
  return std::make_shared<ImageBody>(image, labels, parts);
}

BodyPointer ImageDescription::create_head() const
{
  const VoxelImage image = read_image(file_);
  std::vector<unsigned char> labels;
  for (const HeadLabel label :
       segment_head(image, read_image(mask_file_), rules_))
    labels.push_back(static_cast<unsigned char>(label));
  return std::make_shared<ImageBody>(
    image,
    labels,
    std::vector<BodyPart>{{"brain", Tissue::brain},
                          {"cerebrospinal fluid", Tissue::cerebrospinal_fluid},
                          {"skull", Tissue::skeleton},
                          {"scalp", Tissue::soft_tissue}});
}
} // namespace contrecoup
