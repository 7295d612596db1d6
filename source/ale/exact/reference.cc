// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/exact/noh_flow.h>
#include <contrecoup/ale/exact/reference.h>
#include <contrecoup/ale/exact/sedov_flow.h>
#include <contrecoup/ale/exact/shock_tube_flow.h>
#include <contrecoup/ale/exact/table_flow.h>
#include <contrecoup/ale/exact/taylor_green_flow.h>
#include <contrecoup/ale/exact/water_hammer_flow.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>

namespace contrecoup::ale
{
namespace
{
  /// A flow that Reference/Kind may name.
  struct Kind
  {
    std::string name, section;
    void (*declare)(ParameterHandler &prm);
    std::unique_ptr<ExactFlow> (*create)(const ParameterHandler &prm);
  };

  const std::vector<Kind> flows{
    {"shock tube",
     "Shock tube",
     ShockTubeFlow::declare_parameters,
     ShockTubeFlow::create},
    {"noh", "Noh", NohFlow::declare_parameters, NohFlow::create},
    {"sedov", "Sedov", SedovFlow::declare_parameters, SedovFlow::create},
    {"taylor green",
     "Taylor Green",
     TaylorGreenFlow::declare_parameters,
     TaylorGreenFlow::create},
    {"water hammer",
     "Water hammer",
     WaterHammerFlow::declare_parameters,
     WaterHammerFlow::create},
    {"table", "Table", TableFlow::declare_parameters, TableFlow::create}};
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
  for (const Kind &kind : flows)
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
  for (const Kind &kind : flows)
  {
    const Section flow(prm, kind.section);
    const UsedWith used("Reference/Kind = " + std::string(kind.name));
    kind.declare(prm);
  }
}


void Reference::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Reference");
  radius_ = read_double(prm, "Largest radius");
  const std::string name = prm.get("Kind");
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


void Reference::check_probes(ParameterHandler &prm, const std::size_t n_probes)
{
  const Section section(prm, "Reference");
  const std::string kind = prm.get("Kind");
  if (kind != "rigid sphere" && kind != "fluid filled shell")
    return;
  if (n_probes == 0)
    throw InputError("Reference/Kind = " + kind +
                     " compares pressures at Probes/Points, which is empty");
  if (kind == "fluid filled shell" && n_probes % 2 != 0)
    throw InputError("Reference/Kind = fluid filled shell needs probes in "
                     "pairs, one opposite the other");
}


std::unique_ptr<ExactFlow> Reference::parse_flow(ParameterHandler &prm)
{
  const std::string name = prm.get("Kind");
  for (const Kind &kind : flows)
    if (name == kind.name)
    {
      const Section flow(prm, kind.section);
      return kind.create(prm);
    }
  return nullptr;
}


void Reference::follow(const HexSpace &space,
                       const LagrangeStep &lagrange,
                       const AleState &state,
                       const std::vector<std::uint32_t> &probes,
                       const double step)
{
  if (sphere_)
    sphere_->follow(space, lagrange, state, probes, peaks_);
  if (shell_)
    shell_->follow(space, lagrange, state, probes, step, peaks_);
}


std::vector<NamedValue> Reference::errors(const HexSpace &space,
                                          const LagrangeStep &lagrange,
                                          const AleState &state) const
{
  if (flow_ && state.time > 0.)
    return flow_errors(*flow_, space, lagrange, state, radius_);
  if (sphere_ && !peaks_.empty())
    return SpherePeaks::errors(peaks_, space.communicator());
  if (shell_ && !peaks_.empty())
    return shell_->errors(
      peaks_, lagrange.totals(state).mass, space.communicator());
  return {};
}
} // namespace contrecoup::ale
