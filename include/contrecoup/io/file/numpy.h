// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * Writes an array of doubles as NumPy file (format 1.0), last index fastest;
   * `numpy.load(file)` reads it.
   * @throws SystemError when the disk is full
   */
  void write_npy(const std::string &file,
                 const std::vector<std::size_t> &shape,
                 const std::vector<double> &data);

  /// An array of doubles from a NumPy file.
  struct NumpyArray
  {
    std::vector<std::size_t> shape;
    std::vector<double> data; ///< last index fastest
  };

  /// Reads a file of write_npy(). @throws InputError for other files
  NumpyArray read_npy(const std::string &file);

  /// A planar cut through a field on a regular grid, for pictures.
  struct PlaneSamples
  {
    std::string quantity; ///< e.g. "pressure"
    std::string unit;
    double time = 0.;    ///< [s]
    std::string axes[2]; ///< e.g. "x", "z"
    double lower[2]{};   ///< first corner [m]
    double upper[2]{};   ///< last corner [m]
    std::size_t n_points[2]{};
    std::vector<double> values; ///< first axis fastest
  };

  /// Writes `stem.npy` with shape (n_points[1], n_points[0]) and the other
  /// members to `stem.json`. @throws SystemError when the disk is full
  void write_plane(const std::string &stem, const PlaneSamples &plane);
} // namespace io
} // namespace contrecoup
