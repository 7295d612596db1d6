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
  std::string part;  ///< name of the part
  double thickness;  ///< [m]
  std::string entry; ///< that gives the thickness
  double usual = 0.; ///< thickness without the user's choice [m]; 0: no layer
};

/// Whether elements leave holes in a layer: it is thinner than they are, or
/// than their diagonal and in pieces.
bool has_holes(const BodyLayer &layer,
               unsigned int n_pieces,
               double element_size);

/// Layers of the body that the entries of subsection "Body" describe; those of
/// hexahedra of one's own are as they are.
std::vector<BodyLayer> read_layers(dealii::ParameterHandler &prm);

/**
 * Remarks on layers that are thinner than an element, which have holes in the
 * mesh: a warning of those with fewer elements across than they have usually,
 * without the user's choice of thickness and element size; else no warning.
 * @param element_size [m]
 * @param usual_size that without the user's choice [m]
 * @param entry that gives the element size
 */
std::vector<std::string> thin_layer_lines(const std::vector<BodyLayer> &layers,
                                          double element_size,
                                          double usual_size,
                                          const std::string &entry);

/**
 * A warning of layers of the user's thickness that are no thinner than an
 * element, but than its diagonal, which only the mesh itself shows to be whole;
 * empty without any. Arguments as above.
 */
std::vector<std::string>
uncertain_layer_lines(const std::vector<BodyLayer> &layers,
                      double element_size,
                      const std::string &entry);

/// The line about a layer whose elements are in that many pieces, with a size
/// that closes it where elements are too large: a warning if it has no element
/// or its thickness is the user's. Empty for a layer in one piece or thinner
/// than an element, of which thin_layer_lines() tells, and for thick organs.
std::string layer_pieces_line(const BodyLayer &layer,
                              unsigned int n_pieces,
                              double element_size,
                              const std::string &entry);
} // namespace contrecoup
