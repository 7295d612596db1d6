// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// A layer of a body, a part of a known thickness.
struct BodyLayer
{
  std::string part;      ///< name of the part
  double thickness;      ///< [m]
  std::string entry;     ///< that gives the thickness
  bool is_usual = false; ///< whether the thickness is the default
};

/// Layers of the body that the entries of subsection "Body" describe; those of
/// hexahedra of one's own are as they are.
std::vector<BodyLayer> read_layers(dealii::ParameterHandler &prm);

/// Usual thickness of the layers of a shape of SimpleBody [m].
const std::vector<double> &usual_layers(const std::string &shape);

/**
 * Lines for the log about layers that are thinner than an element, which have
 * holes in the mesh: a warning of those whose thickness the user gave, and of
 * all if the user wants larger elements than usual; a remark on the others.
 * @param element_size [m]
 * @param usual_size that without the user's choice [m]
 * @param entry that gives the element size
 */
std::vector<std::string> thin_layer_lines(const std::vector<BodyLayer> &layers,
                                          double element_size,
                                          double usual_size,
                                          const std::string &entry);
} // namespace contrecoup
