// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/image_body.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/grid_distance.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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
    const std::string where = "Body/Image/Labels, row \"" + text + "\"";
    const std::vector<std::string> ends = split(text.substr(0, colon), '-');
    if (ends.empty() || ends.size() > 2)
      throw InputError(where + ": must read \"label: tissue\" or \"first-last: "
                               "name = tissue\"");
    LabelRow row;
    row.text = text;
    row.first = parse_label(ends.front(), text);
    row.last = parse_label(ends.back(), text);
    if (row.last < row.first)
      throw InputError(where + ": its last label is below its first");
    row.part = parse_body_part(text.substr(colon + 1), where);
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

  /// The labels of an image in order, at most 30 of them.
  std::string list_labels(const std::vector<std::size_t> &n_voxels)
  {
    std::vector<std::string> labels;
    for (std::size_t label = 0; label < n_voxels.size(); ++label)
      if (n_voxels[label] > 0)
        labels.push_back(std::to_string(label));
    constexpr std::size_t most = 30;
    if (labels.size() > most)
      labels[most] = "...";
    labels.resize(std::min(labels.size(), most + 1));
    return join(labels, ", ");
  }

  /// @throws InputError for a row whose labels no voxel has; one that excludes
  /// labels from the body may be without
  void require_voxels(const std::vector<LabelRow> &table,
                      const std::vector<std::size_t> &n_voxels,
                      const std::string &file)
  {
    Selections selections;
    for (const LabelRow &row : table)
      if (row.part.tissue != Tissue::none)
        selections.add("Body/Image/Labels",
                       row.text,
                       "voxel of image \"" + file + "\"",
                       std::accumulate(n_voxels.begin() + row.first,
                                       n_voxels.begin() + row.last + 1,
                                       std::uint64_t(0)));
    selections.require_some(MPI_COMM_SELF,
                            "its labels are " + list_labels(n_voxels));
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
  for (std::size_t b = 1; b < table.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (table[a].first <= table[b].last && table[b].first <= table[a].last)
        throw InputError(
          "Body/Image/Labels names the label " +
          std::to_string(std::max(table[a].first, table[b].first)) +
          " twice: \"" + table[a].text + "\" and \"" + table[b].text + "\"");
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
  // Well above the digits that a header has for positions.
  const double shift =
    1e-4 * *std::min_element(mask.spacing.begin(), mask.spacing.end());
  tie_break_ = Point<3>(shift, shift, shift);
  set_remarks(image.remarks);
}

BodyPointer ImageBody::placed(const Placement &placement) const
{
  const auto body = std::make_shared<ImageBody>(*this);
  body->placements_.push_back(placement);
  body->surface_ = PlacedShape::in_own_box(surface_, placement);
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
  const Tensor<1, 3> index = to_index_ * (source + tie_break_ - origin_);
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

std::vector<double> ImageBody::part_volumes() const
{
  double voxel = 1. / std::abs(determinant(to_index_));
  for (const Placement &placement : placements_)
    voxel *= std::pow(placement.scale(), 3);
  std::vector<double> volumes(parts_.size(), 0.);
  for (const unsigned char label : *labels_)
    if (label != LabelGrid::outside)
      volumes[label] += voxel;
  return volumes;
}


void ImageDescription::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_selection(
    prm,
    "Kind",
    "labels",
    {"labels", "t1 and brain mask"},
    "A label map, or a T1-weighted image of a head with a brain mask.");
  declare_file(prm,
               "File",
               "",
               "NIfTI-1 image: .nii, .nii.gz, or .hdr beside its .img. The "
               "front by its header (+y) becomes +x of the body, its left +y.");
  declare_file(
    prm,
    "Brain mask",
    "",
    used_with("Body/Image/Kind = t1 and brain mask",
              "NIfTI-1 image with the same voxels as the T1-weighted "
              "image, positive inside the brain."));
  declare_string(
    prm,
    "Labels",
    "",
    used_with(
      "Body/Image/Kind = labels",
      selecting("Tissue of each label, such as \"1: brain; 2-5: skeleton; "
                "7: scalp = soft tissue\"; none excludes a label from the "
                "body, as is label 0 unless named.")));
  const Section section(prm, "Head");
  const UsedWith used("Body/Image/Kind = t1 and brain mask");
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
  std::vector<std::size_t> n_voxels(part_of.size(), 0);
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
    ++n_voxels[label];
    const unsigned char part = part_of[label];
    const bool is_body =
      part != LabelGrid::outside && table_[part].part.tissue != Tissue::none;
    labels.push_back(is_body ? part : LabelGrid::outside);
  }
  require_voxels(table_, n_voxels, file_);
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
