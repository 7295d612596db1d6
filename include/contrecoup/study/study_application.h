// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/application/tool.h>

namespace contrecoup::study
{
/// The application "study".
io::ToolDescription study_application();
} // namespace contrecoup::study
