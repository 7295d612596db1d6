// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/plane_file.h>
#include <contrecoup/io/file/vtk_file.h>

#include <stdexcept>

namespace contrecoup
{
namespace io
{
  void write_plane(const std::string &file, const PlaneSamples &plane)
  {
    std::array<std::size_t, 3> n_points{{1, 1, 1}};
    for (unsigned int i = 0; i < 2; ++i)
      n_points[plane.axes[i]] = plane.n_points[i];
    std::string extent, origin, spacing;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const std::string space = d < 2 ? " " : "";
      const double length = plane.upper[d] - plane.lower[d];
      extent += "0 " + std::to_string(n_points[d] - 1) + space;
      origin += exact(plane.lower[d]) + space;
      // Across the plane, VTK needs any number above 0.
      spacing +=
        exact(n_points[d] > 1 ? length / double(n_points[d] - 1) : 1.) + space;
    }
    VtkFile output("ImageData",
                   "WholeExtent=\"" + extent + "\" Origin=\"" + origin +
                     "\" Spacing=\"" + spacing + "\"",
                   "Extent=\"" + extent + "\"");
    output.set_time(plane.time);
    for (const PlaneSamples::Field &field : plane.fields)
    {
      if (field.values.size() != plane.n_samples())
        throw std::invalid_argument("write_plane: " + field.name +
                                    " has another number of points");
      output.add("PointData", field.name, field.values, 1, field.unit);
    }
    output.write(file);
  }
} // namespace io
} // namespace contrecoup
