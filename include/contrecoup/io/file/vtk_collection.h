// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// A file of a collection over time.
  struct CollectionEntry
  {
    double time = 0.; ///< [s]
    std::string part; ///< name of the part of the output; may be empty
    std::string file; ///< relative to the collection
  };

  /// Writes a ParaView collection (.pvd): files by time and, of each time, by
  /// part, with the names of the parts. @throws SystemError
  void write_collection(const std::string &file,
                        const std::vector<CollectionEntry> &entries);
} // namespace io
} // namespace contrecoup
