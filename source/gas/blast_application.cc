// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/blast_application.h>
#include <contrecoup/gas/gas_simulation.h>

namespace contrecoup::gas
{
namespace
{
  template <int dim>
  std::unique_ptr<Simulation> create(ParameterHandler &prm,
                                     const MPI_Comm communicator)
  {
    auto simulation = std::make_unique<GasSimulation<dim>>(communicator);
    simulation->parse_parameters(prm);
    return simulation;
  }

  std::unique_ptr<Simulation> create_any(ParameterHandler &prm,
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
} // namespace


io::ApplicationDescription blast_application()
{
  return {"blast",
          "Solves the Euler equations of a compressible gas, air or "
          "explosive products, on adaptive octree meshes.",
          GasSimulation<3>::declare_parameters,
          create_any};
}
} // namespace contrecoup::gas
