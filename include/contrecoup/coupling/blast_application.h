// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application.h>

namespace contrecoup::coupling
{
/// The application "blast": gas dynamics in 1 to 3 dimensions, in one stage
/// or two.
io::ApplicationDescription blast_application();
} // namespace contrecoup::coupling
