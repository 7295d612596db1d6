// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_simulation.h>
#include <contrecoup/ale/run/ale_simulation.h>
#include <contrecoup/ale/run/head_impact_application.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/application/check_file.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Choices of the entry "Method".
  const std::string ale = "ale", mpm = "mpm";

  void declare_parameters(ParameterHandler &prm)
  {
    declare_selection(prm,
                      "Method",
                      ale,
                      {ale, mpm},
                      "ale: a moving mesh with rezoning; mpm: particles on "
                      "a background grid.");
    AleSimulation::declare_parameters(prm);
    ParticleScene::declare_parameters(prm);
    ParticleReference::declare_parameters(prm);
  }

  template <typename Method>
  std::unique_ptr<Simulation> parsed(ParameterHandler &prm,
                                     const MPI_Comm communicator)
  {
    auto simulation = std::make_unique<Method>(communicator);
    simulation->parse_parameters(prm);
    return simulation;
  }

  std::unique_ptr<Simulation> create(ParameterHandler &prm,
                                     const MPI_Comm communicator)
  {
    return prm.get("Method") == mpm
             ? parsed<ParticleSimulation>(prm, communicator)
             : parsed<AleSimulation>(prm, communicator);
  }

  /// Doubles the grid cell size of the particles.
  bool coarsen_grid(ParameterHandler &prm, const unsigned int levels)
  {
    const Section section(prm, "MPM");
    prm.set("Cell size",
            exact(read_double(prm, "Cell size") * std::pow(2., levels)));
    return true;
  }

  /// Doubles the cell size of a head along its layers. The cells across layers
  /// stay, since they limit the step.
  bool coarsen_head(ParameterHandler &prm, const unsigned int levels)
  {
    const auto axes = read_list(prm, "Semi-axes");
    const double size = std::ldexp(read_double(prm, "Cell size"), levels);
    if (levels > 0 && size > *std::min_element(axes.begin(), axes.end()))
      return false;
    prm.set("Cell size", exact(size));
    return true;
  }

  /// Halves the number of cells of a box in each direction, or of a ball.
  bool coarsen(ParameterHandler &prm, const unsigned int levels)
  {
    if (prm.get("Method") == mpm)
      return coarsen_grid(prm, levels);
    const Section section(prm, "Mesh");
    if (prm.get("Kind") == "half ball")
    {
      const unsigned int refinements = read_unsigned(prm, "Refinements");
      if (refinements < levels)
        return false;
      prm.set("Refinements", static_cast<long int>(refinements - levels));
      return true;
    }
    if (prm.get("Kind") == "layered head")
      return coarsen_head(prm, levels);
    if (prm.get("Kind") == "file")
      return levels == 0;
    const double factor = std::pow(2., levels);
    bool changed = levels == 0;
    std::vector<std::string> words;
    for (const double n : read_list(prm, "Elements"))
    {
      const double coarse = std::ceil(n / factor);
      changed = changed || coarse < std::ceil(2. * n / factor);
      words.push_back(std::to_string(static_cast<long int>(coarse)));
    }
    prm.set("Elements", join(words, ", "));
    return changed;
  }

  /// Numbers in the tables of a run.
  std::vector<std::string> tables(ParameterHandler &prm)
  {
    std::vector<std::string> columns;
    const Section section(prm, "Probes");
    const std::size_t count = read_points<3>(prm, "Points").size();
    for (std::size_t i = 1; i <= count; ++i)
      columns.push_back("*_" + std::to_string(i));
    std::vector<std::string> outputs =
      io::history_outputs("history.csv", {"*"});
    for (const std::string &output : io::history_outputs("probes.csv", columns))
      outputs.push_back(output);
    outputs.emplace_back("injury.csv:*");
    return outputs;
  }

  io::FileNames files(const ParameterHandler &)
  {
    return io::FileNames{{"injury.csv"}, {"report.html"}} +
           io::field_files("ale") + io::field_files("mpm") +
           io::picture_files({"history.png",
                              "probes.png",
                              "head_pressure.png",
                              "head_shear_strain.png",
                              "head_speed.png",
                              "contact.png",
                              "momentum.png",
                              "pressures.png",
                              "shear_strain.png",
                              "head_probes.png",
                              "energy.png"});
  }
} // namespace


io::ApplicationDescription head_impact_application()
{
  io::ApplicationDescription application = {
    "head_impact",
    "Follows solids and fluids through an impact on a mesh that goes "
    "with the matter and is smoothed (ALE), or as particles on a grid "
    "(MPM), with an energy ledger.",
    declare_parameters,
    create,
    {"Scheme/Largest number of retries"},
    coarsen,
    "head",
    files};
  application.tables = tables;
  return application;
}
} // namespace contrecoup::ale
