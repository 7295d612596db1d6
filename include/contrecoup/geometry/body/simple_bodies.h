// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/body_layer.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Bodies of simple shape, centred at the origin: sphere, ellipsoid, cylinder,
 * box, a layered head (ellipsoidal, or spherical with one radius), and the
 * fluid-filled shell that serves as a head surrogate in shock tubes.
 */
class SimpleBody
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError when sizes, layers and tissues do not fit the shape
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Creates the body. Parts are named core, layer 1, layer 2, ... from the
  /// inside, each followed by its tissue.
  BodyPointer create() const;

  /// The layers around the core, named like their parts, from the inside.
  std::vector<BodyLayer> layers() const;

private:
  std::string shape_;
  std::vector<double> size_;    ///< [m]
  std::vector<double> layers_;  ///< thickness, from the inside [m]
  std::vector<Tissue> tissues_; ///< of core and layers
};
} // namespace contrecoup
