// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_extents.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;

  const std::vector<std::string> extent_axes{"x", "y", "z"};

  /// Position of the far face of a particle's deformed cube domain.
  double farthest_coordinate(const mpm::ParticleBlock &block,
                             const std::size_t p,
                             const unsigned int direction)
  {
    double square = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      square += std::pow(block[column::gradient + 3 * direction + d][p] +
                           (d == direction ? 1. : 0.),
                         2);
    return block[column::position + direction][p] +
           0.5 * std::cbrt(block[column::volume][p]) * std::sqrt(square);
  }
} // namespace


void ParticleExtents::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Extent *");
  declare_string(prm, "Region", "bar", "Region of the particles.");
  declare_selection(prm,
                    "Direction",
                    "x",
                    extent_axes,
                    "Direction in which the farthest particle face is "
                    "sought.");
  declare_string(prm,
                 "Where",
                 "1",
                 "muParser expression of x, y, z that is true at the "
                 "present positions of the particles that count.");
  declare_double(prm,
                 "Known",
                 "1",
                 1e-9,
                 1e6,
                 "m",
                 "Known position of the farthest face at the end of the run.");
}


void ParticleExtents::parse_parameters(ParameterHandler &prm)
{
  for (const std::string &name : item_names(prm, "Reference/Extent"))
  {
    const Section section(prm, "Extent " + name);
    const std::string direction = prm.get("Direction");
    extents_.push_back(
      {name,
       trim(prm.get("Region")),
       0,
       static_cast<unsigned int>(
         std::find(extent_axes.begin(), extent_axes.end(), direction) -
         extent_axes.begin()),
       Expression("Reference/Extent " + name + "/Where", prm.get("Where")),
       read_double(prm, "Known")});
  }
  if (extents_.empty())
    throw InputError("Reference/Kind = extents: there is none; add "
                     "\"subsection Extent NAME\" with what is known");
}


void ParticleExtents::reinit(
  const std::vector<mpm::ParticleMaterial> &materials)
{
  for (Extent &extent : extents_)
  {
    const auto found = std::find_if(
      materials.begin(), materials.end(), [&](const auto &material) {
        return material.name == extent.region;
      });
    if (found == materials.end())
      throw InputError("Reference/Extent " + extent.name +
                       "/Region: there is no region " + extent.region);
    extent.material = static_cast<unsigned int>(found - materials.begin());
  }
}


std::vector<NamedValue>
ParticleExtents::values(const mpm::Particles &particles,
                        const MPI_Comm communicator) const
{
  constexpr double none = -std::numeric_limits<double>::max();
  std::vector<double> farthest(extents_.size(), none);
  particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      for (std::size_t i = 0; i < extents_.size(); ++i)
      {
        const Extent &extent = extents_[i];
        for (std::size_t p = 0; m == extent.material && p < block.size(); ++p)
          if (const double to = farthest_coordinate(block, p, extent.direction);
              to > farthest[i] &&
              extent.where.value({block[column::position][p],
                                  block[column::position + 1][p],
                                  block[column::position + 2][p]}) != 0.)
            farthest[i] = to;
      }
    });
  dealii::Utilities::MPI::max(farthest, communicator, farthest);
  std::vector<NamedValue> result;
  for (std::size_t i = 0; i < extents_.size(); ++i)
    result.push_back({"extent_" + extents_[i].name,
                      "m",
                      farthest[i] == none ? 0. : farthest[i]});
  return result;
}


std::vector<NamedValue>
ParticleExtents::errors(const mpm::Particles &particles,
                        const MPI_Comm communicator) const
{
  auto result = values(particles, communicator);
  for (std::size_t i = 0; i < extents_.size(); ++i)
    result[i] = {
      result[i].name, "-", std::abs(result[i].value / extents_[i].known - 1.)};
  return result;
}
} // namespace contrecoup::ale
