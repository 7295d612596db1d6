// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/// Time that processors spent on this process so far, in its own code and in
/// the system for it [s]. Unlike wall time it does not grow while others have
/// the processor.
double processor_seconds();
} // namespace contrecoup
