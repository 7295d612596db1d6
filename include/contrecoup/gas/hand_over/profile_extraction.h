// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/materials/gas_material.h>

namespace contrecoup::gas
{
/**
 * Bounding box of all subcells that differ from the ambient state by more than
 * a relative 1e-10 (single precision: 1e-6) in density or energy, or as much
 * in momentum; the differences beyond the box are below round-off of the
 * totals. Empty (lower above upper) if nothing differs. Collective.
 */
template <int dim>
std::pair<dealii::Point<dim>, dealii::Point<dim>>
disturbed_box(const LeafMesh<dim> &mesh,
              const LeafPoints<dim> &points,
              const GasField &field,
              const std::vector<double> &ambient);

/// Names in ProfileData::maps of the numbers of a BlastRecord, in their order
/// there.
extern const std::array<std::string, 5> record_names;

/**
 * Extracts the profile of a field in spherical, cylindrical or axisymmetric
 * geometry: its disturbed_box() on a raster of subcells of the finest
 * refinement level there; coarser leaves are refined as in adaptation. All
 * ranks get the whole profile. The caller adds time, material and version.
 *
 * @param ambient the ambient state, at rest
 * @param maps become those of the profile; may be empty
 * @throws InputError in plane geometry and when nothing is disturbed
 */
template <int dim>
ProfileData extract_profile(const LeafMesh<dim> &mesh,
                            const LeafPoints<dim> &points,
                            const GasField &field,
                            const GasMaterial &material,
                            const GasState<dim> &ambient,
                            const BlastMaps<dim> &maps);
} // namespace contrecoup::gas
