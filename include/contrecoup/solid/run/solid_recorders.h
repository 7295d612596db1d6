// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/recorder_set.h>
#include <contrecoup/solid/injury/injury_report.h>
#include <contrecoup/solid/record/cavity_record.h>
#include <contrecoup/solid/record/peak_fields.h>
#include <contrecoup/solid/record/solid_probes.h>

namespace contrecoup::solid
{
/// All recorders of a body.
template <typename Real>
using SolidRecorders = RecorderSet<SolidRecorder<Real>,
                                   SolidProbes<Real>,
                                   InjuryReport<Real>,
                                   PeakFields<Real>,
                                   CavityRecord<Real>>;
} // namespace contrecoup::solid
