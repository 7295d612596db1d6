// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/run/gas_core.h>

namespace contrecoup::gas
{
/**
 * The state of a run as a profile, with maps in 1-D unless they are empty, for
 * a run in more dimensions to start from; see extract_profile().
 * @throws InputError while explosive is to burn
 */
template <int dim>
ProfileData make_profile(const GasCore<dim> &core, const BlastMaps<dim> &maps);

/// The records of the blast that the maps of a profile hold, which must outlive
/// the result.
template <int dim>
KnownRecord<dim> records_of(const ProfileField<dim> &profile);
} // namespace contrecoup::gas
