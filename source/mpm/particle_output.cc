// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/output/field_output.h>
#include <contrecoup/mpm/particle_output.h>

namespace contrecoup::mpm
{
std::string write_particles(const std::vector<ParticleMaterial> &materials,
                            const Particles &particles,
                            const std::string &folder,
                            const unsigned int index,
                            const MPI_Comm communicator)
{
  const bool has_metal =
    std::any_of(materials.begin(), materials.end(), [](const auto &material) {
      return material.plasticity.has_value();
    });
  std::vector<io::FieldName> fields{{"velocity", "m/s", true},
                                    {"density", "kg/m^3"},
                                    {"pressure", "Pa"},
                                    {"shear_strain", "-"},
                                    {"volume", "m^3"},
                                    {"region", "-"}};
  if (has_metal)
    fields.push_back({"plastic_strain", "-"});
  io::FieldOutput<0, 3> output(fields);
  particles.for_each_block([&](const unsigned int m,
                               const ParticleBlock &block) {
    for (std::size_t p = 0; p < block.size(); ++p)
    {
      const ParticleValues values = particle_values(materials[m], block, p);
      auto patch = output.make_patch(1);
      for (unsigned int d = 0; d < 3; ++d)
      {
        patch.vertices[0][d] = block[column::position + d][p];
        patch.data(d, 0) = static_cast<float>(block[column::velocity + d][p]);
      }
      patch.data(3, 0) = static_cast<float>(values.density);
      patch.data(4, 0) = static_cast<float>(values.pressure);
      patch.data(5, 0) = static_cast<float>(values.shear_strain);
      patch.data(6, 0) = static_cast<float>(
        block[column::volume][p] * (1. + block[column::dilatation][p]));
      patch.data(7, 0) = static_cast<float>(m);
      if (has_metal)
        patch.data(8, 0) = static_cast<float>(block[column::plastic_strain][p]);
      output.add_patch(std::move(patch));
    }
  });
  return output.write_vtu(folder, "mpm", index, communicator);
}
} // namespace contrecoup::mpm
