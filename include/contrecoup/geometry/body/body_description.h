// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/image_body.h>
#include <contrecoup/geometry/body/mesh_body.h>
#include <contrecoup/geometry/body/phantom.h>
#include <contrecoup/geometry/body/simple_bodies.h>
#include <contrecoup/geometry/body/surface_body.h>
#include <contrecoup/geometry/shape/placement.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * A body described in a parameter file: the human phantom, a simple shape, a
 * closed surface from a file, a medical image, or hexahedra from a file; then
 * scaled, rotated and shifted.
 */
class BodyDescription
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError for contradictory entries
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Creates the body. The last body is cached before placement, so that
  /// repeated calls are fast. @throws InputError when a file cannot be used
  BodyPointer create() const;

  /// Box of the body after scaling, before rotation and shift [m]: its sides do
  /// not depend on how the body is turned, nor on how its file has it turned
  /// about one axis.
  dealii::BoundingBox<3> unturned_box() const;

  /// Volumes that organs should have: those of the voxels of an image, or from
  /// the literature for an unscaled phantom; else empty.
  std::vector<OrganReference> references() const;

  /// Prescribed mass of the phantom [kg].
  double reference_mass() const
  {
    return phantom_.mass();
  }

  /// The same after scaling; NaN for other bodies.
  double phantom_mass() const;

  const std::string &kind() const
  {
    return kind_;
  }

private:
  BodyPointer create_unplaced() const;
  BodyPointer unplaced() const; ///< the same, cached

  std::string text_; ///< entries that define the body before placement
  std::vector<std::string> files_; ///< input files
  std::string kind_;
  Phantom phantom_;
  SimpleBody simple_;
  SurfaceBody from_surface_;
  ImageDescription from_image_;
  MeshBodyDescription from_mesh_;
  std::string origin_;
  double scale_ = 1.;
  Placement placement_;
};
} // namespace contrecoup
