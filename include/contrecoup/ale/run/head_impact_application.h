// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application/application.h>

namespace contrecoup::ale
{
/// The application "head_impact": impacts of solids and fluids, such as a
/// head, on a moving mesh with rezoned fluids, or with particles.
io::ApplicationDescription head_impact_application();
} // namespace contrecoup::ale
