// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <mpi.h>

#include <cstdint>
#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Counts what the entries of a parameter file select (nodes of a support,
 * facets of a load, cells of a region, ...), so that an entry that selects
 * nothing is refused instead of ignored. Each rank counts what it owns.
 */
class Selections
{
public:
  /**
   * Adds @p count to what the entry has selected on this rank. All ranks name
   * the same entries in the same order.
   * @param entry path of the entry, such as "Supports/Support left/Where"
   * @param value its value
   * @param object what it selects, in the singular: "node of the body"
   */
  void add(const std::string &entry,
           const std::string &value,
           const std::string &object,
           std::uint64_t count);

  /**
   * Requires that each entry has selected something on some rank. Collective.
   * @param remark where such objects are or which names there are, such as
   * "the body lies from ..."; may be empty
   * @throws InputError on all ranks that names the first entry without any
   */
  void require_some(MPI_Comm communicator, const std::string &remark) const;

private:
  struct Entry
  {
    std::string path;
    std::string value;
    std::string object;
    std::uint64_t count;
  };
  std::vector<Entry> entries_;
};
} // namespace contrecoup
