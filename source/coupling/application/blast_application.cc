// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/coupling/application/blast_application.h>
#include <contrecoup/coupling/application/blast_tables.h>
#include <contrecoup/coupling/application/coarse_scene.h>
#include <contrecoup/coupling/application/domain_size.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/first_stage/staged_simulation.h>

namespace contrecoup::coupling
{
namespace
{
  template <int dim>
  std::unique_ptr<Simulation> create(ParameterHandler &prm,
                                     const MPI_Comm communicator)
  {
    bool by_time = false;
    {
      const Section section(prm, "Domain");
      by_time = prm.get("Size") == "by time";
    }
    if (by_time)
      fit_domain<dim>(prm, communicator);
    FirstStageParameters stages;
    stages.parse_parameters(prm);
    if constexpr (dim > 1)
      if (stages.kind != "none")
      {
        auto simulation = std::make_unique<StagedSimulation<dim>>(communicator);
        simulation->parse_parameters(prm);
        return simulation;
      }
    if (stages.kind != "none")
      throw InputError("First stage/Kind: a scene of 1 dimension has none");
    auto simulation = std::make_unique<gas::GasSimulation<dim>>(communicator);
    simulation->parse_parameters(prm);
    return simulation;
  }

  std::unique_ptr<Simulation> create_blast(ParameterHandler &prm,
                                           const MPI_Comm communicator)
  {
    int dimension = 0;
    {
      const Section section(prm, "Domain");
      dimension = read_integer(prm, "Dimension");
    }
    switch (dimension)
    {
      case 1:
        return create<1>(prm, communicator);
      case 2:
        return create<2>(prm, communicator);
      default:
        return create<3>(prm, communicator);
    }
  }

  io::FileNames files_of_blast(const ParameterHandler &prm)
  {
    io::FileNames names = {{"fields/plane_*.vti",
                            "fields/skin_#.vtp",
                            "fields/gauges_line_#.csv",
                            "fields/gauges_plane_#.vti",
                            "loads.h5",
                            "loads.xdmf",
                            "load_gauges.csv",
                            "gauge_measures.csv",
                            "gauge_injury.csv",
                            "probe_injury.csv"},
                           {}};
    const std::string profile = prm.get({"Output"}, "Profile file");
    if (!profile.empty())
      names.results.push_back(profile);
    return names + io::field_files("fields") +
           io::picture_files({"history.png",
                              "probes.png",
                              "*_maps.png",
                              "*_injury.png",
                              "plane*.png",
                              "profiles.png",
                              "body_pressure.png",
                              "body_maps.png",
                              "body_gauges.png",
                              "triple_point.png"});
  }
} // namespace


io::ApplicationDescription blast_application()
{
  io::ApplicationDescription application = {
    "blast",
    "Solves the Euler equations of a compressible gas, air or "
    "explosive products, on adaptive octree meshes.",
    StagedSimulation<3>::declare_parameters,
    create_blast,
    {},
    coarsen_scene,
    "run",
    files_of_blast};
  application.adapts = [](const ParameterHandler &prm) {
    return prm.get_bool({"Adaptation"}, "Active");
  };
  application.oversights = warn_of_bias;
  application.tables = blast_tables;
  return application;
}
} // namespace contrecoup::coupling
