// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/run/gas_core.h>

namespace contrecoup::gas
{
/**
 * Current state of a run as a profile, the start of a run in more dimensions;
 * see extract_profile().
 * @throws InputError while unburned explosive is left
 */
template <int dim>
ProfileData make_profile(const GasCore<dim> &core, const BlastMaps<dim> &maps);

/// Whether a profile has the maps of records_of().
bool has_records(const Profile &profile);

/// Blast records from the maps of @p profile, which must outlive the result;
/// not a number within a profile without maps.
template <int dim>
KnownRecord<dim> records_of(const ProfileField<dim> &profile);
} // namespace contrecoup::gas
