// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// A body of one tissue, bounded by triangles from a file; it may get the
/// organs of the phantom, see borrow_organs().
class SurfaceBody
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError for an unknown tissue or without a file
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Reads and repairs the surface. What was found is in the body's remarks.
  /// @param scale that the body gets afterwards, which counts for its size
  /// @throws InputError when the file cannot be read, the surface encloses no
  ///   volume, its holes are too large, or it is itself, or no person's
  BodyPointer create(double scale = 1.) const;

  /// Whether the phantom's organs belong into it.
  bool has_organs() const
  {
    return has_organs_;
  }

  /// Part of their volume that may be outside [-].
  double largest_loss() const
  {
    return largest_loss_;
  }

private:
  /// @throws InputError for a size that hints at another unit
  void check_size(const dealii::BoundingBox<3> &box) const;

  std::string file_;
  double unit_ = 1.;            ///< [m]
  double largest_size_ = 5.;    ///< [m]
  dealii::Tensor<1, 3> angles_; ///< [rad]
  Tissue tissue_ = Tissue::soft_tissue;
  bool has_organs_ = false;
  double largest_loss_ = 0.;      ///< of organs [-]
  double largest_hole_area_ = 0.; ///< of all holes, over that of the surface
};
} // namespace contrecoup
