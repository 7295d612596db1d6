// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/run/ale_output.h>
#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/io/output/field_output.h>

namespace contrecoup::ale
{
std::string write_ale(const HexSpace &space,
                      const LagrangeStep &lagrange,
                      const AleState &state,
                      const std::string &folder,
                      const unsigned int index)
{
  io::FieldOutput<3> output({{"velocity", "m/s", true},
                             {"density", "kg/m^3"},
                             {"pressure", "Pa"},
                             {"specific_internal_energy", "J/kg"},
                             {"products", "-"},
                             {"void_fraction", "-"},
                             {"shear_strain", "-"},
                             {"region", "-"}});
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
  {
    const auto element = lagrange.values(state, c);
    auto patch = output.make_patch(1);
    for (unsigned int i = 0; i < 8; ++i)
    {
      const std::uint32_t node = space.cell(c)[i];
      const unsigned int v = vertex_of_corner[i];
      for (unsigned int d = 0; d < 3; ++d)
      {
        patch.vertices[v][d] = state.position[node_width * node + d];
        patch.data(d, v) =
          static_cast<float>(state.velocity[node_width * node + d]);
      }
      patch.data(3, v) = static_cast<float>(element.mass / element.volume);
      patch.data(4, v) = static_cast<float>(element.pressure);
      patch.data(5, v) = static_cast<float>(element.energy / element.mass);
      patch.data(6, v) = static_cast<float>(state.products[c]);
      patch.data(7, v) = static_cast<float>(element.void_fraction);
      patch.data(8, v) = static_cast<float>(element.shear_strain);
      patch.data(9, v) = static_cast<float>(space.region(c));
    }
    output.add_patch(std::move(patch));
  }
  return output.write_vtu(folder, "ale", index, space.communicator());
}
} // namespace contrecoup::ale
