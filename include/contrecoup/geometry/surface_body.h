// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// A body of one tissue, bounded by triangles from a file.
class SurfaceBody
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError for an unknown tissue or without a file
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Reads and repairs the surface. What was found is in the body's remarks.
  /// @throws InputError when the file cannot be read, the surface encloses no
  ///   volume, or its holes are too large
  BodyPointer create() const;

private:
  std::string file_;
  double unit_ = 1.; ///< [m]
  Tissue tissue_ = Tissue::soft_tissue;
  double largest_hole_area_ = 0.; ///< of all holes, over that of the surface
};
} // namespace contrecoup
