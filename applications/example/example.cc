// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/contrecoup.h>

#include <iostream>
using namespace contrecoup;
const dealii::Point<1> place(1.); // m from the charge
struct Impulse : gas::Recorder<1> // sees each step
{
  void parse_parameters(ParameterHandler &, const gas::GasScene<1> &) override
  {}
  void mesh_changed(const gas::GasSnapshot<1> &gas) override
  {
    sampler.reinit({place}, gas.mesh, gas.scene.points);
  }
  void add_step(const gas::GasSnapshot<1> &gas) override
  {
    const double p = sampler.sample(gas.field, gas.scene.material)[0].pressure;
    value += std::max(0., p - gas.scene.ambient().pressure) * gas.step;
  }
  gas::PointSampler<1> sampler;
  double value = 0.; // Pa s
};

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  gas::GasSimulation<1> blast(MPI_COMM_WORLD);
  const auto impulse = std::make_shared<Impulse>();
  blast.add_recorder(impulse);
  set_entries(blast, argc > 1 ? argv[1] : "");
  blast.setup();
  for (double time = 3e-4; time < 2.5e-3; time += 3e-4)
  {
    advance_to(blast, time);
    std::cout << time << ' ' << blast.states_at({place})[0].pressure << '\n';
  }
  std::cout << "impulse " << impulse->value << " Pa s\n";
}
