// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/// Processor time of this process so far, user and system [s]. Unlike wall
/// time it does not grow while other processes use the processor.
double processor_seconds();
} // namespace contrecoup
