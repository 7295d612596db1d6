// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_probes.h>
#include <contrecoup/ale/particles/particle_reference.h>
#include <contrecoup/ale/record/reference.h>
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
  namespace mpi = dealii::Utilities::MPI;

  const std::vector<std::string> axes{"x", "y", "z"};

  /// Distance of a vector from its exact value; 0 without expressions.
  double distance(const std::vector<Expression> &exact,
                  dealii::Tensor<1, 3> value,
                  const dealii::Point<3> &place,
                  const double time)
  {
    if (exact.empty())
      return 0.;
    for (unsigned int d = 0; d < 3; ++d)
      value[d] -= exact[d].value(place, time);
    return value.norm();
  }

  /// Parses the entries @p names; empty if all entries are empty.
  std::vector<Expression> parse_expressions(ParameterHandler &prm,
                                            const std::string &section,
                                            std::vector<std::string> names)
  {
    std::vector<Expression> result;
    const bool given =
      std::any_of(names.begin(), names.end(), [&](const std::string &name) {
        return !trim(prm.get(name)).empty();
      });
    for (const std::string &name : names)
      if (given)
      {
        const std::string text = trim(prm.get(name));
        result.emplace_back(section + "/" + name, text.empty() ? "0" : text);
      }
    return result;
  }

  std::vector<std::string> with_axes(const std::string &name)
  {
    return {name + " x", name + " y", name + " z"};
  }
} // namespace


void ParticleReference::declare_parameters(ParameterHandler &prm)
{
  const Section reference(prm, "Reference");
  {
    const Section section(prm, "Expressions");
    const UsedWith used("Reference/Kind = expressions");
    const auto declare = [&](const std::string &name, const std::string &what) {
      declare_string(prm,
                     name,
                     "",
                     what +
                       ", a muParser expression of t and of the initial x, y, "
                       "z of the particle; empty: not compared.");
    };
    for (const std::string &name : with_axes("Displacement"))
      declare(name, "Particle displacement [m]");
    for (const std::string &name : with_axes("Velocity"))
      declare(name, "Particle velocity [m/s]");
    declare("Pressure", "Particle pressure [Pa]");
  }
  ParticleExtents::declare_parameters(prm);
  {
    const Section section(prm, "Probe displacements");
    const UsedWith used("Reference/Kind = probe displacements");
    ProbeDisplacements::declare_parameters(prm);
  }
  const Section section(prm, "Front");
  const UsedWith used("Reference/Kind = front");
  declare_string(prm, "Region", "water", selecting("Region of the front."));
  declare_selection(prm,
                    "Direction",
                    "x",
                    axes,
                    "Direction in which the front is the farthest face.");
  declare_list(prm,
               "Times",
               "0",
               1,
               1000,
               0.,
               1e6,
               "s",
               "Times of known positions, in ascending order.");
  declare_list(prm,
               "Positions",
               "0",
               1,
               1000,
               -1e6,
               1e6,
               "m",
               "Known positions of the front at these times.");
}


void ParticleReference::parse_front(ParameterHandler &prm)
{
  const Section section(prm, "Front");
  Front front;
  front.region = trim(prm.get("Region"));
  front.direction = static_cast<unsigned int>(
    std::find(axes.begin(), axes.end(), prm.get("Direction")) - axes.begin());
  front.times = read_list(prm, "Times");
  front.positions = read_list(prm, "Positions");
  if (front.times.size() != front.positions.size())
    throw InputError("Reference/Front/Positions has " +
                     std::to_string(front.positions.size()) +
                     " numbers, and Times has " +
                     std::to_string(front.times.size()));
  if (std::adjacent_find(front.times.begin(),
                         front.times.end(),
                         std::greater_equal<>()) != front.times.end())
    throw InputError("Reference/Front/Times must go up");
  front_ = front;
}


void ParticleReference::parse_parameters(ParameterHandler &prm,
                                         const ImpactScene &impact)
{
  const Section section(prm, "Reference");
  radius_ = read_double(prm, "Largest radius");
  const std::string name = prm.get("Kind");
  Reference::check_probes(name, impact.probes.size());
  if (name == "fluid filled shell")
    throw InputError("Reference/Kind = " + name + " needs Method = ale");
  if (name == "front")
    parse_front(prm);
  check_times(impact.end_time);
  if (name == "extents")
    extents_.parse_parameters(prm);
  if (name == "rigid sphere")
  {
    const Section inner(prm, "Rigid sphere");
    sphere_ = SpherePeaks::create(prm);
  }
  if (name == "probe displacements")
  {
    const Section inner(prm, "Probe displacements");
    displacements_ = ProbeDisplacements::create(prm);
  }
  if (name == "expressions")
  {
    const Section inner(prm, "Expressions");
    const std::string path = "Reference/Expressions";
    expressions_ = {parse_expressions(prm, path, with_axes("Displacement")),
                    parse_expressions(prm, path, with_axes("Velocity")),
                    parse_expressions(prm, path, {"Pressure"})};
    if (expressions_->displacement.empty() && expressions_->velocity.empty() &&
        expressions_->pressure.empty())
      throw InputError("Reference/Kind = expressions: " + path +
                       " has none; give one of its entries");
  }
  flow_ = Reference::parse_flow(prm);
}


void ParticleReference::check_times(const double end_time) const
{
  if (!front_ || front_->times.back() <= end_time)
    return;
  const auto &times = front_->times;
  const auto n =
    std::upper_bound(times.begin(), times.end(), end_time) - times.begin();
  log_line("WARNING: Reference/Front/Times goes on to " + brief(times.back()) +
           " s, after Time/End time = " + brief(end_time) +
           " s: " + std::to_string(n) + " of " + std::to_string(times.size()) +
           " positions are compared");
}


void ParticleReference::reinit(const ParticleSnapshot &now)
{
  const std::vector<mpm::ParticleMaterial> &materials = now.scene.materials();
  extents_.reinit(materials);
  if (displacements_)
    displacements_->reinit(now.impact.probes);
  if (!front_)
    return;
  front_->material =
    find_material(materials, "Reference/Front/Region", front_->region);
  front_->half_spacing = now.scene.half_spacing();
}


std::vector<NamedValue> ParticleReference::history(const ParticleSnapshot &now)
{
  if (front_)
    return {{"front", "m", record_.position}};
  if (displacements_)
    return displacements_->values(now.particles, now.communicator);
  return extents_.values(now.particles, now.communicator);
}


double ParticleReference::front_position(const ParticleSnapshot &now) const
{
  double farthest = -std::numeric_limits<double>::max();
  now.particles.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &block) {
      for (std::size_t p = 0; m == front_->material && p < block.size(); ++p)
        farthest =
          std::max(farthest, block[column::position + front_->direction][p]);
    });
  return mpi::max(farthest, now.communicator) + front_->half_spacing;
}


void ParticleReference::record(const ParticleSnapshot &now)
{
  if (front_)
    follow_front(now);
  if (!sphere_)
    return;
  peaks_.resize(now.impact.probes.size(), {{0., 0.}});
  for_each_probe(
    now.particles,
    [&](
      const unsigned int m, const auto &block, const auto p, const auto probe) {
      sphere_->take(
        dealii::Point<3>(mpm::vector_of(block, column::position, p)),
        mpm::particle_values(now.scene.materials()[m], block, p).pressure,
        now.time,
        peaks_[probe]);
    });
}


void ParticleReference::follow_front(const ParticleSnapshot &now)
{
  const double time = now.time;
  const double position = front_position(now);
  const bool is_first = record_.time == 0.;
  const auto &times = front_->times;
  for (; record_.n_known < times.size() && times[record_.n_known] <= time;
       ++record_.n_known)
  {
    const double fraction = is_first ? 1.
                                     : (times[record_.n_known] - record_.time) /
                                         (time - record_.time);
    const double then =
      is_first ? position
               : (1. - fraction) * record_.position + fraction * position;
    const double error = std::abs(then - front_->positions[record_.n_known]);
    record_.error += error;
    record_.largest = std::max(record_.largest, error);
  }
  record_.time = time;
  record_.position = position;
}


std::vector<NamedValue>
ParticleReference::errors(const ParticleSnapshot &now) const
{
  const double time = now.time;
  if (sphere_)
    return SpherePeaks::errors(peaks_, now.communicator);
  if (front_ && record_.n_known > 0)
    return {{"front_mean", "m", record_.error / record_.n_known},
            {"front_largest", "m", record_.largest}};
  if (!extents_.empty())
    return extents_.errors(now.particles, now.communicator);
  if (displacements_)
    return displacements_->errors(now.particles, now.communicator);
  if (!(time > 0.) || (!flow_ && !expressions_))
    return {};
  // Errors of displacement or density, velocity, pressure; volume.
  std::vector<double> sums(4, 0.);
  now.particles.for_each_block([&](const unsigned int m,
                                   const mpm::ParticleBlock &block) {
    for (std::size_t p = 0; p < block.size(); ++p)
    {
      const double volume = block[column::volume][p];
      const auto velocity = mpm::vector_of(block, column::velocity, p);
      const auto values =
        mpm::particle_values(now.scene.materials()[m], block, p);
      const dealii::Point<3> place(mpm::vector_of(block, column::position, p)),
        start(mpm::vector_of(block, column::initial_position, p));
      if ((flow_ ? place : start).norm() > radius_)
        continue;
      sums[3] += volume;
      if (flow_)
      {
        const FlowState exact = flow_->value(place, time);
        sums[0] += volume * std::abs(values.density - exact.density);
        sums[1] += volume * (velocity - exact.velocity).norm();
        sums[2] += volume * std::abs(values.pressure - exact.pressure);
        continue;
      }
      const auto &exact = *expressions_;
      sums[0] +=
        volume * distance(exact.displacement, place - start, start, time);
      sums[1] += volume * distance(exact.velocity, velocity, start, time);
      if (!exact.pressure.empty())
        sums[2] += volume * std::abs(values.pressure -
                                     exact.pressure[0].value(start, time));
    }
  });
  mpi::sum(sums, now.communicator, sums);
  std::vector<NamedValue> result;
  if (flow_)
    result.push_back({"density_L1", "kg/m^3", sums[0] / sums[3]});
  else if (!expressions_->displacement.empty())
    result.push_back({"displacement_L1", "m", sums[0] / sums[3]});
  if (flow_ || !expressions_->velocity.empty())
    result.push_back({"velocity_L1", "m/s", sums[1] / sums[3]});
  if (flow_ || !expressions_->pressure.empty())
    result.push_back({"pressure_L1", "Pa", sums[2] / sums[3]});
  return result;
}
} // namespace contrecoup::ale
