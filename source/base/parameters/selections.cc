// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/exceptions.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace contrecoup
{
void Selections::add(const std::string &entry,
                     const std::string &value,
                     const std::string &object,
                     const std::uint64_t count)
{
  const auto known =
    std::find_if(entries_.begin(), entries_.end(), [&](const Entry &one) {
      return one.path == entry && one.value == value;
    });
  if (known == entries_.end())
    entries_.push_back({entry, value, object, count});
  else
    known->count += count;
}


void Selections::require_some(const MPI_Comm communicator,
                              const std::string &remark) const
{
  for (const Entry &entry : entries_)
    if (dealii::Utilities::MPI::sum(entry.count, communicator) == 0)
      throw InputError(entry.path + " = \"" + entry.value + "\" selects no " +
                       entry.object + (remark.empty() ? "" : ": " + remark));
}
} // namespace contrecoup
