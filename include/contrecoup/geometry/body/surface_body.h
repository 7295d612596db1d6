// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/file_unit.h>
#include <contrecoup/geometry/body/inserted_organs.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// A body of one tissue with a triangulated surface from a file; optionally
/// with the organs of the phantom, see insert_organs().
class SurfaceBody
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError for an unknown tissue or without a file
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Reads and repairs the surface; findings become remarks of the body.
  /// @param scale later scale of the body, for the check of its size
  /// @throws InputError when the file cannot be read, the surface encloses no
  /// volume, or its size or its holes are too large, or for organs in a body
  /// that is not of a person's size
  BodyPointer create(double scale = 1.) const;

  /// Whether the body gets the organs of the phantom.
  bool has_organs() const
  {
    return has_organs_;
  }

  /// How organs are inserted.
  /// @param scale later scale of the body [-]
  OrganInsertion insertion(double scale) const
  {
    OrganInsertion result = insertion_;
    result.scale = scale;
    return result;
  }

private:
  std::string file_;
  FileUnit unit_;
  dealii::Tensor<1, 3> angles_; ///< [rad]
  Tissue tissue_ = Tissue::soft_tissue;
  bool has_organs_ = false;
  OrganInsertion insertion_;
  /// area of all holes over that of the surface [-]
  double largest_hole_area_ = 0.;
};
} // namespace contrecoup
