// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>
#include <contrecoup/geometry/image_body.h>
#include <contrecoup/geometry/phantom.h>
#include <contrecoup/geometry/placement.h>
#include <contrecoup/geometry/simple_bodies.h>
#include <contrecoup/geometry/surface_body.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * A body as a subsection of a parameter file describes it: the human phantom, a
 * simple shape, what a surface from a file encloses, or a medical image;
 * scaled, turned and moved.
 */
class BodyDescription
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError when they do not go together
  void parse_parameters(dealii::ParameterHandler &prm);

  /// The body; the last one is kept, so that it is there at once when it is
  /// asked for again, wherever it is placed. @throws InputError when a file
  /// cannot be used
  BodyPointer create() const;

  /// What the literature says of its parts; only of an unscaled phantom.
  std::vector<OrganReference> references() const;

  /// The mass of the man that the phantom is asked to be [kg].
  double reference_mass() const
  {
    return phantom_.mass();
  }

  const std::string &kind() const
  {
    return kind_;
  }

private:
  BodyPointer create_unplaced() const;

  std::string text_; ///< what it is before it is placed, as it was read
  std::vector<std::string> files_; ///< and those that may say more
  std::string kind_;
  Phantom phantom_;
  SimpleBody simple_;
  SurfaceBody from_surface_;
  ImageDescription from_image_;
  std::string origin_;
  Placement placement_;
};
} // namespace contrecoup
