// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/mesh/mesh_smoothing.h>

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
    double element_size = 0.01; ///< [m]
    unsigned int levels = 0;    ///< coarsening levels
    SmoothingOptions smoothing; ///< zero iterations: no smoothing
    std::string tissue_set;
    bool write_gmsh = false;
    bool write_surface = true;
    double distance_spacing = 0.; ///< grid of signed distances [m], 0: none
    bool draw = true;
  };
} // namespace coupling
} // namespace contrecoup
