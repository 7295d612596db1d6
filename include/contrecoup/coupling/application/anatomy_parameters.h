// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/body/body_layer.h>
#include <contrecoup/geometry/mesh/mesh_smoothing.h>
#include <contrecoup/materials/own_tissues.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace contrecoup
{
namespace coupling
{
  /// Parameters of a run of `anatomy`.
  struct AnatomyParameters
  {
    /// Declares all entries.
    static void declare_parameters(dealii::ParameterHandler &prm);

    /// @throws InputError for entries that cannot be combined
    void parse_parameters(dealii::ParameterHandler &prm);

    BodyDescription body;
    std::vector<BodyLayer> layers;
    static constexpr double usual_element_size = 0.01; ///< [m]
    double element_size = usual_element_size;          ///< [m]
    unsigned int levels = 0;                           ///< coarsening levels
    SmoothingOptions smoothing; ///< zero iterations: no smoothing
    std::string tissue_set;
    OwnTissues own_tissues;
    bool write_gmsh = false;
    bool write_surface = true;
    double distance_spacing = 0.; ///< grid of signed distances [m], 0: none
    bool draw = true;
  };

  /// Reads the tissues of the user's own of subsection "Tissues", before names
  /// of tissues are read elsewhere. @throws InputError for bad entries and for
  /// properties that no stable solid has, also with the values of the set
  OwnTissues read_own_tissues(dealii::ParameterHandler &prm);

  /// @throws InputError for a tissue with entries of its own in subsection
  /// "Tissues" that no part of the body has, and for a new tissue of the body
  /// without entries
  void require_parts(const OwnTissues &tissues, const Body &body);
} // namespace coupling
} // namespace contrecoup
