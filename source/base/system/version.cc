// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/revision.h>
#include <contrecoup/base/system/version.h>

namespace contrecoup
{
std::string version()
{
  return CONTRECOUP_VERSION;
}

std::string git_revision()
{
  return CONTRECOUP_REVISION;
}
} // namespace contrecoup
