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
  /**
   * Reads what LoadFile wrote, as it is or merged to means over longer times.
   * The file is open only within each call.
   *
   * Whole samples are merged, each weighted with its length, so that impulses
   * and the means of ramps stay exact: from one multiple of the interval after
   * the first sample to the next, each moved to the nearest end of a sample.
   * The first sample, which lasts until something arrives, gets an end one
   * interval earlier, so that lines between middles of samples do not begin at
   * time 0.
   */
  class LoadReader
  {
  public:
    /// Reads facets and times.
    /// @param interval that samples are merged over [s]; one that is no longer
    ///   than the samples changes nothing
    /// @throws InputError when the file is no load file
    explicit LoadReader(const std::string &path, const double interval = 0.);

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
    /// Recorded samples that are merged to one: from number begin on, to the
    /// one before end.
    struct Group
    {
      std::size_t begin, end;
    };

    void merge(const double interval);
    /// Adds what @p n samples from number @p begin on give to a group's means,
    /// of each facet, that are @p stride apart.
    void add_part(const Group &group,
                  const std::size_t begin,
                  const std::size_t n,
                  const std::vector<float> &samples,
                  double *means,
                  const std::size_t stride) const;
    std::vector<float> read_recorded(std::size_t first,
                                     std::size_t count) const;

    std::string path_;
    LoadFile::Facets facets_;
    std::vector<double> times_;
    std::vector<Group> groups_;     ///< empty: each sample as it is
    std::vector<double> durations_; ///< of recorded samples [s]
  };
} // namespace io
} // namespace contrecoup
