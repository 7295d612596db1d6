// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/load_file.h>

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Reads what LoadFile wrote. The file is open only within each call.
  class LoadReader
  {
  public:
    /// Reads facets and times.
    /// @throws InputError when the file is no load file
    explicit LoadReader(const std::string &path);

    const LoadFile::Facets &facets() const
    {
      return facets_;
    }
    std::size_t n_facets() const
    {
      return facets_.areas.size();
    }

    /// Ends of the times that samples are means over [s].
    const std::vector<double> &times() const
    {
      return times_;
    }

    /// Samples of all facets, [facet][time], at @p count times from number
    /// @p first on [Pa]. @throws SystemError
    std::vector<float> read(std::size_t first, std::size_t count) const;

  private:
    std::string path_;
    LoadFile::Facets facets_;
    std::vector<double> times_;
  };
} // namespace io
} // namespace contrecoup
