// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_extents.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;

  /// Farthest position without particles [m].
  constexpr double none = -std::numeric_limits<double>::max();

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


unsigned int find_material(const std::vector<mpm::ParticleMaterial> &materials,
                           const std::string &entry,
                           const std::string &name)
{
  std::vector<std::string> names;
  for (const mpm::ParticleMaterial &material : materials)
    names.push_back(material.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(entry + ": there is no region \"" + name + "\"" +
                     suggestion(name, names));
  return static_cast<unsigned int>(found - names.begin());
}


void ParticleExtents::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Extent *");
  const UsedWith used("Reference/Kind = extents");
  declare_string(prm, "Region", "bar", selecting("Region of the particles."));
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
    extent.material = find_material(
      materials, "Reference/Extent " + extent.name + "/Region", extent.region);
}


std::vector<double> ParticleExtents::farthest(const mpm::Particles &particles,
                                              const MPI_Comm communicator) const
{
  std::vector<double> result(extents_.size(), none);
  particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      for (std::size_t i = 0; i < extents_.size(); ++i)
      {
        const Extent &extent = extents_[i];
        for (std::size_t p = 0; m == extent.material && p < block.size(); ++p)
          if (const double to = farthest_coordinate(block, p, extent.direction);
              to > result[i] &&
              extent.where.value({block[column::position][p],
                                  block[column::position + 1][p],
                                  block[column::position + 2][p]}) != 0.)
            result[i] = to;
      }
    });
  dealii::Utilities::MPI::max(result, communicator, result);
  return result;
}


std::vector<NamedValue>
ParticleExtents::values(const mpm::Particles &particles,
                        const MPI_Comm communicator) const
{
  std::vector<NamedValue> result;
  const auto found = farthest(particles, communicator);
  for (std::size_t i = 0; i < extents_.size(); ++i)
    result.push_back(
      {"extent_" + extents_[i].name, "m", found[i] == none ? 0. : found[i]});
  return result;
}


std::vector<NamedValue>
ParticleExtents::errors(const mpm::Particles &particles,
                        const MPI_Comm communicator) const
{
  std::vector<NamedValue> result;
  const auto found = farthest(particles, communicator);
  for (std::size_t i = 0; i < extents_.size(); ++i)
  {
    const Extent &extent = extents_[i];
    if (found[i] == none)
      log_line("WARNING: Reference/Extent " + extent.name + "/Where = \"" +
               extent.where.text() + "\" selects no particle of region " +
               extent.region + " at the end: its error is unknown");
    else
      result.push_back(
        {"extent_" + extent.name, "-", std::abs(found[i] / extent.known - 1.)});
  }
  return result;
}
} // namespace contrecoup::ale
