// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/file/skin_file.h>

#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * HDF5 file with the blast loads on a body's surface. Datasets, in the order
   * of the facets: "centroid" and "normal" (outward) [facet][3] in m, "area"
   * in m^2 (2-D: m, per m of depth), "overpressure" [facet][time] in Pa as
   * float, chunked and compressed, "peak" in Pa, "impulse" of the positive
   * phase in Pa s, "arrival" and "duration" in s, all four not a number where
   * no blast has come; and "time" in s. Each overpressure sample is the mean
   * since the previous time, the first one since time 0, so that the integral
   * over time is exact. If the corners of the facets are known, also "vertex"
   * [vertex][3] in m and "connectivity", in the form of XDMF's mixed topology:
   * of each facet its type (3: polygon; in 2-D 2: line), the number of its
   * corners, and their vertices.
   *
   * Each dataset has attributes "units", "description" and "axes", such as
   * "facet x time", and HDF5's labels of dimensions with the same names.
   *
   * The file is open only during each call.
   */
  class LoadFile
  {
  public:
    struct Facets
    {
      std::vector<double> centroids; ///< three numbers each [m]
      std::vector<double> normals;   ///< three numbers each [-]
      std::vector<double> areas;     ///< [m^2]
      SkinMesh corners;              ///< may be empty
    };
    /// The point or vector @p i of a list in Facets.
    static dealii::Point<3> point_at(const std::vector<double> &numbers,
                                     const std::size_t i)
    {
      return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    }
    /// Number of times compressed together; appending to an incomplete chunk
    /// rewrites it at another place in the file.
    static constexpr unsigned int chunk_times = 64;
    /// Names and values of file attributes.
    using Words = std::vector<std::pair<std::string, std::string>>;
    using Numbers = std::vector<std::pair<std::string, double>>;

    /// @param path name of the file
    explicit LoadFile(const std::string &path);

    /// Creates a new file without samples. @throws SystemError
    void create(const Facets &facets, const Words &words);

    /// Appends samples, index [time][facet]. @throws SystemError
    void append(const std::vector<double> &times,
                const std::vector<float> &overpressures);

    /// Writes or overwrites a number for each facet, or all attributes.
    /// @throws SystemError
    void write(const std::string &name, const std::vector<double> &values);
    void write(const Numbers &numbers);

  private:
    std::string path_;
  };
} // namespace io
} // namespace contrecoup
