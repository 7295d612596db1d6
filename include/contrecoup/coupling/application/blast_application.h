// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application/application.h>

namespace contrecoup::coupling
{
/// Application "blast": gas dynamics in 1 to 3 dimensions, with or without a
/// first stage in fewer dimensions.
io::ApplicationDescription blast_application();
} // namespace contrecoup::coupling
