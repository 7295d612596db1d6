// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/injury/own_thresholds.h>
#include <contrecoup/solid/body/solid_materials.h>
#include <contrecoup/solid/boundary/slip_ties.h>
#include <contrecoup/solid/boundary/supports.h>
#include <contrecoup/solid/boundary/surface_loads.h>

namespace contrecoup::solid
{
/// Objects by which the entries of a run select parts of its mesh.
struct SolidSelectors
{
  const Supports &supports;
  const SurfaceLoads &loads;
  const SolidMaterials &materials;
  const SlipTies &slip;
  const OwnThresholds &thresholds;
  bool reports_injury; ///< of brain and chest
};

/// Requires that each support, load and tissue that an entry names is in the
/// mesh, the tissue of each measure of injury whose thresholds are given, and a
/// brain or a lung if injuries are to be reported. Collective.
/// @throws InputError on all ranks that names the first entry without any
void require_selections(const SolidMesh &mesh,
                        const SolidSelectors &selectors,
                        MPI_Comm communicator);

/// Tissues of the mesh all of whose nodes supports move in x, y and z.
/// Collective.
std::vector<Tissue> find_held_tissues(const SolidMesh &mesh,
                                      const Supports &supports,
                                      MPI_Comm communicator);

/// Warns of supports that prescribe the motion of all nodes of the body, or of
/// a tissue whose injury is reported: no load reaches what they select.
/// Collective.
void warn_of_supports(const SolidMesh &mesh,
                      const SolidSelectors &selectors,
                      MPI_Comm communicator);
} // namespace contrecoup::solid
