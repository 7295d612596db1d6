// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * The HDF5 file of the loads on a body's surface. Datasets, in the order of
   * the facets: "centroid", "normal" (out of the body) [facet][3] in m, "area"
   * in m^2 (2-D: m, per m of depth), "overpressure" [facet][time] in Pa as
   * float, chunked and compressed, "peak" in Pa, "impulse" of the positive
   * phase in Pa s, "arrival" and "duration" in s; and "time" in s. A sample of
   * overpressure is the mean since the last time, the first one since time 0,
   * so that its integral over time is exact.
   *
   * The file is open only within each call.
   */
  class LoadFile
  {
  public:
    struct Facets
    {
      std::vector<double> centroids; ///< three numbers each [m]
      std::vector<double> normals;   ///< three numbers each [-]
      std::vector<double> areas;     ///< [m^2]
    };
    /// Times that are compressed together: a part of them that is appended to
    /// later is written again, in another place of the file.
    static constexpr unsigned int chunk_times = 64;
    /// Names and values of attributes of the file.
    using Words = std::vector<std::pair<std::string, std::string>>;
    using Numbers = std::vector<std::pair<std::string, double>>;

    /// @param path name of the file
    explicit LoadFile(const std::string &path);

    /// Makes a new file without times. @throws SystemError
    void create(const Facets &facets, const Words &words);

    /// Appends samples, [time][facet]. @throws SystemError
    void append(const std::vector<double> &times,
                const std::vector<float> &overpressures);

    /// Writes, or writes again, a number for each facet, and attributes.
    /// @throws SystemError
    void write(const std::string &name, const std::vector<double> &values);
    void write(const Numbers &numbers);

  private:
    std::string path_;
  };
} // namespace io
} // namespace contrecoup
