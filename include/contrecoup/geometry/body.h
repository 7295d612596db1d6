// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/tissues.h>
#include <contrecoup/geometry/label_grid.h>
#include <contrecoup/geometry/placement.h>
#include <contrecoup/geometry/shape.h>

#include <memory>
#include <string>
#include <vector>

namespace contrecoup
{
/// A piece of a body: an organ, a bone, a layer.
struct BodyPart
{
  std::string name;
  Tissue tissue;
};

/// A named place on the surface of a body.
struct Landmark
{
  std::string name;       ///< in lower case
  dealii::Point<3> place; ///< [m]
};

/// A body of several parts in space. Lengths in m.
class Body
{
public:
  virtual ~Body() = default;

  /// This body scaled, turned and moved.
  virtual std::shared_ptr<const Body>
  placed(const Placement &placement) const = 0;

  /// The parts by number; at most LabelGrid::nothing of them.
  const std::vector<BodyPart> &parts() const
  {
    return parts_;
  }

  /// What whoever uses the body should know of where it came from.
  const std::vector<std::string> &remarks() const
  {
    return remarks_;
  }
  void set_remarks(const std::vector<std::string> &remarks)
  {
    remarks_ = remarks;
  }

  /// Places on the surface that have a name; only shapes known beforehand
  /// have some.
  const std::vector<Landmark> &landmarks() const
  {
    return landmarks_;
  }
  void set_landmarks(const std::vector<Landmark> &landmarks)
  {
    landmarks_ = landmarks;
  }

  /// The outer surface, which holds all parts: what gas meets.
  virtual ShapePointer surface() const = 0;

  /// The number of the part at a point, or LabelGrid::nothing.
  virtual unsigned char part_at(const dealii::Point<3> &point) const = 0;

  /// Gives every cube of a grid the part at its centre.
  virtual void fill(LabelGrid &grid) const = 0;

protected:
  std::vector<BodyPart> parts_;

private:
  std::vector<std::string> remarks_;
  std::vector<Landmark> landmarks_;
};

using BodyPointer = std::shared_ptr<const Body>;

/// A body of shapes: a point belongs to the first of them that holds it, and
/// only what is in the surface is there at all.
class ShapeBody : public Body
{
public:
  struct Piece
  {
    BodyPart part;
    ShapePointer shape;
  };

  /// @param pieces fewer than LabelGrid::nothing
  ShapeBody(ShapePointer surface, const std::vector<Piece> &pieces);
  BodyPointer placed(const Placement &placement) const override;
  ShapePointer surface() const override;
  unsigned char part_at(const dealii::Point<3> &point) const override;
  void fill(LabelGrid &grid) const override;

  /// What it was made of.
  std::vector<Piece> pieces() const;

private:
  struct Block;
  void fill_block(LabelGrid &grid, const Block &block) const;

  ShapePointer surface_;
  std::vector<ShapePointer> shapes_;
};
} // namespace contrecoup
