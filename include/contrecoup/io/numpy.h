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
   * Writes doubles as a NumPy array file (format 1.0), last index fastest:
   * `numpy.load(file)` gives an array of this shape.
   * @throws SystemError when the disk is full
   */
  void write_npy(const std::string &file,
                 const std::vector<std::size_t> &shape,
                 const std::vector<double> &data);

  /// An array of doubles as write_npy() writes it.
  struct NumpyArray
  {
    std::vector<std::size_t> shape;
    std::vector<double> data; ///< last index fastest
  };

  /// Reads what write_npy() wrote. @throws InputError for other files
  NumpyArray read_npy(const std::string &file);

  /// A plane cut through a field on a regular grid, for pictures.
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

  /// Writes `stem.npy` of shape (n_points[1], n_points[0]) and `stem.json`
  /// with the rest. @throws SystemError when the disk is full
  void write_plane(const std::string &stem, const PlaneSamples &plane);
} // namespace io
} // namespace contrecoup
