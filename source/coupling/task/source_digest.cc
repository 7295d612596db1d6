// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/task/source_digest.h>

#include <map>

namespace contrecoup::coupling
{
std::string source_digest(const std::string &application)
{
  static const std::map<std::string, std::string> digests{
#include <contrecoup/coupling/task/source_digests.inc>
  };
  return digests.at(application);
}
} // namespace contrecoup::coupling
