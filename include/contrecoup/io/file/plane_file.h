// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// A cut through fields along two axes, on a regular grid of points.
  struct PlaneSamples
  {
    /// A quantity at the points, the first axis fastest; NaN: not known.
    struct Field
    {
      std::string name;
      std::string unit;
      std::vector<double> values;
    };

    std::size_t n_samples() const
    {
      return n_points[0] * n_points[1];
    }

    double time = 0.;                    ///< [s]
    std::array<unsigned int, 2> axes;    ///< 0, 1, 2: x, y, z; ascending
    std::array<double, 3> lower{};       ///< first point [m]
    std::array<double, 3> upper{};       ///< last point [m]
    std::array<std::size_t, 2> n_points; ///< along the axes, two or more
    std::vector<Field> fields;
  };

  /**
   * Writes a plane as VTK ImageData (.vti) of doubles with units and time, for
   * ParaView and for plots; VtkInput reads it.
   * @throws SystemError when the disk is full
   */
  void write_plane(const std::string &file, const PlaneSamples &plane);
} // namespace io
} // namespace contrecoup
