// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/image/label_grid.h>
#include <contrecoup/geometry/shape/shape.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Horizontal layers of voxels of a standing person, each divided into patches.
class PersonLayers
{
public:
  /// A face-connected set of voxels of one layer.
  struct Patch
  {
    std::vector<std::size_t> voxels;
    double x = 0., y = 0.; ///< of its centre [m]

    /// Standard deviation along x (0) or y (1) [m].
    double spread(const LabelGrid &grid, unsigned int direction) const;
  };

  /**
   * Fills 200 layers. Small pieces are dropped. Arms that touch the trunk are
   * divided from it, where they are thinnest along x, by walls one voxel wide
   * along y, which belong to no patch.
   * @throws InputError for several large pieces, and without two ankles
   */
  explicit PersonLayers(const Shape &surface);

protected:
  /// Label of a voxel that has no region yet.
  static constexpr unsigned char unknown_ = 254;

  std::size_t layer_size() const
  {
    return static_cast<std::size_t>(grid_.size[0]) * grid_.size[1];
  }

  /// Index along y of a voxel.
  unsigned int column(const std::size_t voxel) const
  {
    return voxel / grid_.size[0] % grid_.size[1];
  }

  /// Square of the height times a factor, in voxels of one layer.
  double area(const double factor) const
  {
    return factor * n_layers_ * n_layers_;
  }

  /// Whether a voxel is inside, has no region yet, and is no wall.
  bool is_open(const std::size_t voxel) const
  {
    return grid_.labels[voxel] == unknown_ && !is_wall_[voxel];
  }

  /// Divides each layer into patches of open voxels.
  void find_patches();

  dealii::Point<3> center(const std::vector<std::size_t> &voxels) const;

  /// Index of the patch above or below that shares most voxels with @p patch of
  /// a layer; -1: none.
  int next(const Patch &patch, unsigned int layer, bool is_up) const;

  /// Patches of the left and the right of two limbs in a layer: the same one
  /// twice if they touch each other. If there are more than two, those count
  /// that continue down to the feet, as hands next to a seat do not.
  /// @throws InputError for other numbers of limbs
  std::vector<int> find_two(const std::string &what, unsigned int layer) const;

  LabelGrid grid_;                          ///< unknown_, or LabelGrid::outside
  unsigned int sole_ = 0;                   ///< lowest layer
  unsigned int n_layers_ = 0;               ///< from there to the highest place
  std::vector<std::vector<Patch>> patches_; ///< by layer
  std::vector<int> patch_of_;               ///< by voxel; -1: none

private:
  std::size_t count_inside(unsigned int layer) const;
  void keep_one_piece();
  void put_walls();
  int find_gap(const std::vector<unsigned int> &thickness,
               unsigned int outer,
               unsigned int inner) const;
  void require_ankles() const;
  bool stands(const Patch &patch, unsigned int layer) const;

  std::vector<bool> is_wall_; ///< by voxel
};
} // namespace contrecoup
