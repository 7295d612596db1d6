// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/record/reference.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>

namespace contrecoup::ale
{
namespace
{
  const std::vector<FlowKind> flows{shock_tube_flow(),
                                    noh_flow(),
                                    sedov_flow(),
                                    taylor_green_flow(),
                                    water_hammer_flow(),
                                    table_flow()};
} // namespace


void Reference::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Reference");
  std::vector<std::string> names{"none",
                                 "rigid sphere",
                                 "fluid filled shell",
                                 "expressions",
                                 "front",
                                 "extents",
                                 "probe displacements"};
  for (const FlowKind &kind : flows)
    names.push_back(kind.name);
  declare_selection(prm,
                    "Kind",
                    "none",
                    names,
                    "Solution that the run is compared with. At the probes: "
                    "a liquid in a rigid sphere that is decelerated, or in "
                    "an elastic shell that hits a wall. In all cells: shock "
                    "tube, implosion, point explosion, vortices, a liquid "
                    "stopped by a wall, or a table. For particles also "
                    "expressions, the front of a region over time, final "
                    "extents of regions, and displacements at probes.");
  declare_double(prm,
                 "Largest radius",
                 "1e6",
                 1e-9,
                 1e6,
                 "m",
                 "A flow is compared within this distance from the origin.");
  {
    const Section sphere(prm, "Rigid sphere");
    const UsedWith used("Reference/Kind = rigid sphere");
    SpherePeaks::declare_parameters(prm);
  }
  {
    const Section shell(prm, "Fluid filled shell");
    const UsedWith used("Reference/Kind = fluid filled shell");
    ShellPressures::declare_parameters(prm);
  }
  for (const FlowKind &kind : flows)
  {
    const Section flow(prm, kind.section);
    const UsedWith used("Reference/Kind = " + kind.name);
    kind.declare(prm);
  }
}


void Reference::parse_parameters(ParameterHandler &prm,
                                 const ImpactScene &impact)
{
  const Section section(prm, "Reference");
  radius_ = read_double(prm, "Largest radius");
  const std::string name = prm.get("Kind");
  check_probes(name, impact.probes.size());
  if (name == "rigid sphere")
  {
    const Section sphere(prm, "Rigid sphere");
    sphere_ = SpherePeaks::create(prm);
  }
  if (name == "fluid filled shell")
  {
    const Section shell(prm, "Fluid filled shell");
    shell_ = ShellPressures::create(prm);
  }
  if (name == "expressions" || name == "front" || name == "extents" ||
      name == "probe displacements")
    throw InputError("Reference/Kind = " + name + " needs Method = mpm");
  flow_ = parse_flow(prm);
}


void Reference::check_probes(const std::string &kind,
                             const std::size_t n_probes)
{
  if (kind != "rigid sphere" && kind != "fluid filled shell")
    return;
  if (n_probes == 0)
    throw InputError("Reference/Kind = " + kind +
                     " compares pressures at Probes/Points, which is empty");
  if (kind == "fluid filled shell" && n_probes % 2 != 0)
    throw InputError("Reference/Kind = fluid filled shell needs probes in "
                     "pairs, one opposite the other");
}


std::optional<ExactFlow> Reference::parse_flow(ParameterHandler &prm)
{
  const std::string name = prm.get("Kind");
  for (const FlowKind &kind : flows)
    if (name == kind.name)
    {
      const Section flow(prm, kind.section);
      return kind.read(prm);
    }
  return {};
}


void Reference::record(const AleSnapshot &now)
{
  if (sphere_)
    sphere_->follow(
      now.space, now.lagrange, now.state, now.probe_cells, peaks_);
  if (shell_)
    shell_->follow(
      now.space, now.lagrange, now.state, now.probe_cells, now.step, peaks_);
}


std::vector<NamedValue> Reference::errors(const AleSnapshot &now) const
{
  if (flow_ && now.time > 0.)
    return flow_errors(*flow_, now.space, now.lagrange, now.state, radius_);
  if (sphere_ && !peaks_.empty())
    return SpherePeaks::errors(peaks_, now.communicator);
  if (shell_ && !peaks_.empty())
    return shell_->errors(
      peaks_, now.lagrange.totals(now.state).mass, now.communicator);
  return {};
}
} // namespace contrecoup::ale
