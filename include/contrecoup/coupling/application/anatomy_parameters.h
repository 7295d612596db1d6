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

  /// Reads the user's tissues of subsection "Tissues". Call it first: it makes
  /// new names known. @throws InputError for bad entries, and for a tissue that
  /// is no stable solid, with the set's values where it has no entry
  OwnTissues read_own_tissues(dealii::ParameterHandler &prm);

  /// Requires that each of the user's tissues belongs to a part of the body,
  /// and that each new tissue of the body has entries. @throws InputError
  void require_parts(const OwnTissues &tissues, const Body &body);
} // namespace coupling
} // namespace contrecoup
