// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace contrecoup
{
/// A triangulated surface; corners are counterclockwise seen from outside of a
/// body.
struct TriangleMesh
{
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<dealii::Point<3>> vertices; ///< [m]
  std::vector<Triangle> triangles;

  /// Normal times area of a triangle [m^2].
  dealii::Tensor<1, 3> area_vector(const Triangle &triangle) const;

  double area() const; ///< [m^2]

  /// Enclosed volume [m^3]; positive for outward orientation.
  double volume() const;

  dealii::BoundingBox<3> bounding_box() const;
};

/// Adds a warning if a surface with positions in single precision is so far
/// from the origin that its shape has lost digits.
/// @throws InputError where hardly any shape is left
void check_single_precision(const TriangleMesh &mesh,
                            const std::string &file,
                            std::vector<std::string> &remarks);

/**
 * Reads a surface: STL (binary or ASCII), OBJ, PLY, or another format that the
 * Assimp library recognises by the file name extension. Coordinates have double
 * precision where the file has it; Assimp and binary STL have six digits.
 * @param unit length of a 1 in the file [m]
 * @param remarks gets what users should know of the file; warnings begin with
 * "WARNING: "
 * @throws InputError when the file cannot be read or is cut, holds no
 * triangles, or has coordinates that are not finite
 */
TriangleMesh read_surface(const std::string &file,
                          double unit,
                          std::vector<std::string> *remarks = nullptr);
} // namespace contrecoup
