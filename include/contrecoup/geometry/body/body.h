// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/image/body_part.h>
#include <contrecoup/geometry/image/label_grid.h>
#include <contrecoup/geometry/shape/placement.h>
#include <contrecoup/geometry/shape/shape.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup
{
struct HexMesh;

/// A named point on the surface of a body.
struct Landmark
{
  std::string name;       ///< lower case
  dealii::Point<3> place; ///< [m]
};

/// How organs fit into the surface of a person.
struct OrganFit
{
  /// Parts of the volume of all organs within the surface [-]; below this one
  /// the fit is poor.
  static constexpr double least_inside = 0.97;
  /// Least thickness of tissue over lungs and brain, as mean over patches of
  /// 3 cm [m]; as above.
  static constexpr double least_cover = 0.008;

  double inside = 1.;
  double brain_cover = 0.; ///< [m]
  double lung_cover = 0.;  ///< [m]

  bool holds() const
  {
    return inside >= least_inside &&
           std::min(brain_cover, lung_cover) >= least_cover;
  }
};

/// Interface: a body with one or several parts. Lengths in m.
class Body
{
public:
  virtual ~Body() = default;

  /// Returns this body scaled, rotated and shifted.
  virtual std::shared_ptr<const Body>
  placed(const Placement &placement) const = 0;

  /// The parts by number; at most LabelGrid::outside.
  const std::vector<BodyPart> &parts() const
  {
    return parts_;
  }

  /// Remarks for users on the origin of the body.
  const std::vector<std::string> &remarks() const
  {
    return remarks_;
  }
  void set_remarks(const std::vector<std::string> &remarks)
  {
    remarks_ = remarks;
  }

  /// Named points on the surface; empty unless the shape is predefined.
  const std::vector<Landmark> &landmarks() const
  {
    return landmarks_;
  }
  void set_landmarks(const std::vector<Landmark> &landmarks)
  {
    landmarks_ = landmarks;
  }

  /// How well organs of another body fit; none unless they were inserted.
  const std::optional<OrganFit> &organ_fit() const
  {
    return organ_fit_;
  }
  void set_organ_fit(const std::optional<OrganFit> &organ_fit)
  {
    organ_fit_ = organ_fit;
  }

  /// The outer surface, which encloses all parts; the gas solver sees this.
  virtual ShapePointer surface() const = 0;

  /// Number of the part at a point, or LabelGrid::outside.
  virtual unsigned char part_at(const dealii::Point<3> &point) const = 0;

  /// Labels every voxel of a grid with the part at its centre.
  virtual void fill(LabelGrid &grid) const = 0;

  /// The hexahedra of a body that was given as such; null for others, which
  /// are meshed from a grid.
  virtual std::shared_ptr<const HexMesh> own_mesh() const
  {
    return nullptr;
  }

protected:
  std::vector<BodyPart> parts_;

private:
  std::vector<std::string> remarks_;
  std::vector<Landmark> landmarks_;
  std::optional<OrganFit> organ_fit_;
};

using BodyPointer = std::shared_ptr<const Body>;

/// Logs the remarks of a body that are warnings.
void log_warnings(const Body &body);

/// A body of shapes inside an outer surface. A point inside the surface
/// belongs to the first shape that contains it.
class ShapeBody : public Body
{
public:
  struct PartShape
  {
    BodyPart part;
    ShapePointer shape;
  };

  /// @param part_shapes fewer than LabelGrid::outside
  ShapeBody(ShapePointer surface, const std::vector<PartShape> &part_shapes);
  BodyPointer placed(const Placement &placement) const override;
  ShapePointer surface() const override;
  unsigned char part_at(const dealii::Point<3> &point) const override;
  void fill(LabelGrid &grid) const override;

  /// The shapes given to the constructor.
  std::vector<PartShape> part_shapes() const;

private:
  struct Block;
  void fill_block(LabelGrid &grid, const Block &block) const;

  ShapePointer surface_;
  std::vector<ShapePointer> shapes_;
};

/// Voxels of a shape: 0 inside, LabelGrid::outside elsewhere.
LabelGrid fill_shape(const Shape &shape, double spacing);
} // namespace contrecoup
