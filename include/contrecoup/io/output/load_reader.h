// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/output/load_file.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * Reads a LoadFile, as recorded or averaged over longer intervals. The file
   * is open only during each call.
   *
   * Averaging merges whole samples, weighted with their duration, so that
   * impulses and means of ramps stay exact. Merged intervals end at multiples
   * of the interval after the first sample, each moved to the nearest end of a
   * sample. The first sample, which lasts until the blast arrives, is split
   * one interval before its end; otherwise linear interpolation between
   * midpoints of samples would begin at time 0.
   */
  class LoadReader
  {
  public:
    /// Reads facets and times.
    /// @param interval for averaging [s]; no effect if not longer than the
    /// samples
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

    /// Directions normal to the planes of symmetry on one side of which loads
    /// were recorded; nothing where the file does not say.
    const std::optional<std::array<bool, 3>> &symmetry() const
    {
      return symmetry_;
    }

    /// End times of the samples, which are means over intervals [s].
    const std::vector<double> &times() const
    {
      return times_;
    }

    /// Samples of all facets, index [facet][time], for @p count times from
    /// index @p first [Pa]. @throws SystemError
    std::vector<float> read(std::size_t first, std::size_t count) const;

  private:
    /// Recorded samples begin to end - 1, merged into one sample.
    struct Group
    {
      std::size_t begin, end;
    };

    void merge(const double interval);
    /// Adds the contributions of @p n recorded samples from index @p begin to
    /// the means of a group; the means of the facets are @p stride apart.
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
    std::optional<std::array<bool, 3>> symmetry_;
    std::vector<double> times_;
    std::vector<Group> groups_;     ///< empty: samples as recorded
    std::vector<double> durations_; ///< of recorded samples [s]
  };
} // namespace io
} // namespace contrecoup
