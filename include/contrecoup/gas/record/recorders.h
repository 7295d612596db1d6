// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/recorder_set.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/open_sides.h>
#include <contrecoup/gas/record/probe_rasters.h>
#include <contrecoup/gas/record/probe_set.h>
#include <contrecoup/gas/record/wall_loads.h>

namespace contrecoup::gas
{
/// All recorders of the gas.
template <int dim>
using Recorders = RecorderSet<Recorder<dim>,
                              ProbeSet<dim>,
                              ProbeRasters<dim>,
                              BlastMaps<dim>,
                              OpenSides<dim>,
                              WallLoads<dim>>;
} // namespace contrecoup::gas
