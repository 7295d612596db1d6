// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>

#include <algorithm>

namespace contrecoup::ale
{
void declare_symmetry_planes(ParameterHandler &prm)
{
  declare_string(prm,
                 "Symmetry planes",
                 "",
                 "Axes normal to symmetry planes: x, y, z, or none. Of a "
                 "layered head, the half on the positive side of its centre "
                 "is computed; the mesh of a file must end at a flat side "
                 "at its smallest coordinate.");
  declare_selection(prm,
                    "Wedge axis",
                    "none",
                    {"none", "x", "y", "z"},
                    "Computes a wedge one cell thick of a layered head that "
                    "is axisymmetric about this axis and hits along it; "
                    "implies symmetry planes through the axis.");
}


unsigned int read_wedge_axis(ParameterHandler &prm)
{
  const std::string name = prm.get("Wedge axis");
  return name == "none" ? 3 : static_cast<unsigned int>(name[0] - 'x');
}


SymmetryPlanes read_symmetry_planes(ParameterHandler &prm)
{
  const std::vector<std::string> axes{"x", "y", "z"};
  SymmetryPlanes planes{};
  for (const std::string &name : split(prm.get("Symmetry planes"), ','))
  {
    const auto found = std::find(axes.begin(), axes.end(), name);
    if (found == axes.end())
      throw InputError("Mesh/Symmetry planes: " + quotation(name) +
                       " is none of x, y, z");
    planes[found - axes.begin()] = true;
  }
  const unsigned int axis = read_wedge_axis(prm);
  for (unsigned int d = 0; d < 3; ++d)
    if (axis < 3 && d != axis)
      planes[d] = true;
  return planes;
}


double fraction_within(const SymmetryPlanes &planes)
{
  double fraction = 1.;
  for (const bool is_halved : planes)
    fraction *= is_halved ? 0.5 : 1.;
  return fraction;
}
} // namespace contrecoup::ale
