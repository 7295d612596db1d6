// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/image/head_segmentation.h>
#include <contrecoup/geometry/image/voxel_image.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Range of image labels that belong to one part of a body.
struct LabelRow
{
  std::string text; ///< as in the table
  unsigned int first;
  unsigned int last;
  BodyPart part;
};

/**
 * Parses a label table: "1: brain; 2-5: skeleton; 7: soft tissue = scalp". The
 * colon is followed by a tissue, or by a part name, "=" and the tissue.
 * @throws InputError naming the wrong row
 */
std::vector<LabelRow> parse_label_table(const std::string &text);

/// A body of labelled voxels; between voxel centres the nearest counts, of
/// several the one that is farthest along the spatial axes.
class ImageBody : public Body
{
public:
  /**
   * @param image supplies size and position; its values are not used
   * @param labels part number of each voxel, or LabelGrid::outside
   * @throws InputError when no voxel has a part, or for axes that are not
   * orthogonal
   */
  ImageBody(const VoxelImage &image,
            const std::vector<unsigned char> &labels,
            const std::vector<BodyPart> &parts);

  BodyPointer placed(const Placement &placement) const override;
  ShapePointer surface() const override;
  unsigned char part_at(const dealii::Point<3> &point) const override;
  void fill(LabelGrid &grid) const override;

  /// Volume of the voxels of each part [m^3].
  std::vector<double> part_volumes() const;

private:
  std::array<unsigned int, 3> size_;
  dealii::Tensor<2, 3> to_index_; ///< inverse of the axes [1/m]
  dealii::Tensor<1, 3> origin_;
  dealii::Tensor<1, 3> tie_break_; ///< added to points [m]
  std::shared_ptr<const std::vector<unsigned char>> labels_;
  ShapePointer surface_;
  std::vector<Placement> placements_; ///< applied one after the other
};

/// Description of a body from medical images: a label map, or a T1-weighted
/// image of a head with a brain mask.
class ImageDescription
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError without a file, or for an invalid label table
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when images cannot be read or do not match each other,
  /// or for labels missing in the table or in the image
  BodyPointer create() const;

private:
  BodyPointer create_from_labels() const;
  BodyPointer create_head() const;

  std::string kind_;
  std::string file_;
  std::string mask_file_;
  std::vector<LabelRow> table_;
  HeadRules rules_;
};
} // namespace contrecoup
