// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application.h>

namespace contrecoup::ale
{
/// The application "head_impact": solids and fluids, such as a head,
/// on a mesh that goes with the matter and whose fluids are smoothed.
io::ApplicationDescription head_impact_application();
} // namespace contrecoup::ale
