// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/heat_source.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/numerics/element/hex8_moments.h>

namespace contrecoup::ale
{
void HeatSource::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Heat source");
  declare_string(prm,
                 "Power",
                 "0",
                 "Power density [W/m^3], a muParser expression of x, y, z, "
                 "t; counts as external work.");
}


void HeatSource::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Heat source");
  power_ = Expression("Heat source/Power", prm.get("Power"));
}


double HeatSource::add(const HexSpace &space,
                       AleState &state,
                       const double begin,
                       const double duration) const
{
  if (!is_active())
    return 0.;
  double sum = 0.;
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
  {
    const auto corners = corners_of(space.cell(c), state.position);
    const auto moments = hex_moments(corners);
    const dealii::Point<3> centre(moments.first[0] / moments.volume,
                                  moments.first[1] / moments.volume,
                                  moments.first[2] / moments.volume);
    const double heat =
      duration * moments.volume * power_.value(centre, begin + 0.5 * duration);
    state.energy[c] += heat;
    sum += heat;
  }
  return sum;
}
} // namespace contrecoup::ale
