// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/materials/solid_material.h>
#include <contrecoup/solid/record/peak_fields.h>

namespace contrecoup::solid
{
/// Item of plan and audit about kinematics that hold for small strains alone,
/// before the run.
Assumption strain_item(SolidKinematics kinematics);

/// The same with what the run measured.
/// @param tissue without a name where no peaks are recorded
Assumption strain_item(SolidKinematics kinematics,
                       const StrainedTissue &tissue);
} // namespace contrecoup::solid
