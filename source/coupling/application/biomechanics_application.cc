// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/remark_line.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/anatomy_parameters.h>
#include <contrecoup/coupling/application/biomechanics_application.h>
#include <contrecoup/io/application/check_file.h>
#include <contrecoup/solid/run/solid_simulation.h>

#include <algorithm>

namespace contrecoup::coupling
{
namespace
{
  template <typename Real>
  std::unique_ptr<Simulation> create_solid(ParameterHandler &prm,
                                           const MPI_Comm communicator)
  {
    auto simulation =
      std::make_unique<solid::SolidSimulation<Real>>(communicator);
    simulation->parse_parameters(prm);
    return simulation;
  }

  std::unique_ptr<Simulation> create_biomechanics(ParameterHandler &prm,
                                                  const MPI_Comm communicator)
  {
    bool single = false;
    {
      const Section section(prm, "Elements");
      single = prm.get("Precision") == "single";
    }
    return single ? create_solid<float>(prm, communicator)
                  : create_solid<double>(prm, communicator);
  }

  /// Whether the body consists of hexahedra of one's own.
  bool own_mesh_in(ParameterHandler &prm)
  {
    const Section section(prm, "Body");
    return prm.get("Kind") == "mesh";
  }

  /// Halves the number of elements of a box per direction, or doubles the
  /// element size of a body, @p levels times.
  bool coarsen(ParameterHandler &prm, const unsigned int levels)
  {
    const bool has_own_mesh = own_mesh_in(prm);
    const Section section(prm, "Mesh");
    const std::string kind = prm.get("Kind");
    const double factor = std::pow(2., levels);
    if (kind == "body" && !has_own_mesh)
    {
      prm.set("Element size", exact(factor * read_double(prm, "Element size")));
      return true;
    }
    if (kind == "ball octant" || kind == "shell octant")
    {
      const unsigned int refinements = read_unsigned(prm, "Refinements");
      if (refinements < levels)
        return false;
      prm.set("Refinements", static_cast<long int>(refinements - levels));
      return true;
    }
    if (kind != "box")
      return levels == 0;
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

  bool strikes_ground(const ParameterHandler &prm)
  {
    const auto moves = [&](const std::string &direction) {
      return prm.get({"Initial state"}, "Velocity " + direction) != "0";
    };
    return prm.get_bool({"Ground"}, "Active") &&
           (moves("x") || moves("y") || moves("z"));
  }

  /// Layers of a body that are thinner than its elements.
  std::vector<std::string> find_thin_layers(ParameterHandler &prm)
  {
    if (prm.get({"Mesh"}, "Kind") != "body")
      return {};
    const double usual = AnatomyParameters::usual_element_size;
    const double size = prm.get_double({"Mesh"}, "Element size");
    const std::string entry = "Mesh/Element size";
    const std::vector<BodyLayer> layers = read_layers(prm);
    std::vector<std::string> lines =
      thin_layer_lines(layers, size, usual, entry);
    for (const std::string &line : uncertain_layer_lines(layers, size, entry))
      lines.push_back(line);
    std::transform(lines.begin(), lines.end(), lines.begin(), remark_line);
    return lines;
  }

  /// Numbers in the tables of a run.
  std::vector<std::string> tables(ParameterHandler &prm)
  {
    std::vector<std::string> columns;
    {
      const Section section(prm, "Probes");
      const std::size_t count = read_points<3>(prm, "Points").size();
      for (std::size_t i = 1; i <= count; ++i)
        for (const solid::ProbeQuantity &quantity : solid::probe_quantities())
          columns.push_back("probe_" + std::to_string(i) + "_" + quantity.name);
    }
    std::vector<std::string> outputs =
      io::history_outputs("history.csv", {"*"});
    for (const std::string &output : io::history_outputs("probes.csv", columns))
      outputs.push_back(output);
    if (prm.get_bool({"Injury"}, "Active"))
      outputs.emplace_back("injury.csv:*");
    return outputs;
  }

  io::FileNames files(const ParameterHandler &)
  {
    return io::FileNames{{"injury.csv"}, {}} + io::field_files("solid") +
           io::picture_files({"history.png",
                              "probes.png",
                              "sagittal.png",
                              "sagittal_head.png",
                              "energies.png",
                              "coup.png",
                              "pressures.png"});
  }
} // namespace


io::ApplicationDescription biomechanics_application()
{
  io::ApplicationDescription application = {
    "biomechanics",
    "Follows stress waves through a deformable body, with an energy "
    "audit that can fail.",
    solid::SolidSimulation<double>::declare_parameters,
    create_biomechanics,
    {"Energy audit/",
     "Elements/Step safety",
     "Elements/Largest number of retries"},
    coarsen,
    {},
    files};
  application.keeps_first_step = true;
  application.strikes = strikes_ground;
  application.oversights = find_thin_layers;
  application.tables = tables;
  return application;
}
} // namespace contrecoup::coupling
