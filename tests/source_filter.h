// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

/// GoogleTest's filter for the tests of the source files in @p list, whose
/// names have commas between them; nothing where these files have no test.
std::string filter_of_sources(const std::string &list);
