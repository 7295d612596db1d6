// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/whole_body.h>

#include <algorithm>

namespace contrecoup::ale
{
void set_to_whole(std::vector<NamedValue> &values,
                  const double computed_fraction,
                  const SymmetryPlanes &planes)
{
  static const std::vector<std::string> summed{
    "kg", "J", "N", "N s", "m^2", "m^3"};
  for (NamedValue &value : values)
  {
    if (std::find(summed.begin(), summed.end(), value.unit) != summed.end())
      value.value /= computed_fraction;
    for (unsigned int d = 0; d < 3; ++d)
      for (const char *const name : {"momentum_", "velocity_"})
        if (planes[d] &&
            value.name.rfind(name + std::string(1, "xyz"[d]), 0) == 0)
          value.value = 0.;
  }
}
} // namespace contrecoup::ale
