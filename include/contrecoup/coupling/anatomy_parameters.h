// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body_description.h>
#include <contrecoup/geometry/mesh_smoothing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace contrecoup
{
namespace coupling
{
  /// What a run of `anatomy` is to do.
  struct AnatomyParameters
  {
    /// Declares every entry.
    static void declare_parameters(dealii::ParameterHandler &prm);

    /// @throws InputError when entries do not go together
    void parse_parameters(dealii::ParameterHandler &prm);

    BodyDescription body;
    double element_size = 0.01; ///< [m]
    unsigned int levels = 0;    ///< of larger elements
    SmoothingOptions smoothing; ///< no iterations: none
    std::string tissue_set;
    bool write_gmsh = false;
    bool write_surface = true;
    double distance_spacing = 0.; ///< [m], 0: no grid of distances
    bool draw = true;
  };
} // namespace coupling
} // namespace contrecoup
