// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application/application.h>

namespace contrecoup::coupling
{
/// Application "biomechanics": stress waves in a body under a blast load.
io::ApplicationDescription biomechanics_application();
} // namespace contrecoup::coupling
