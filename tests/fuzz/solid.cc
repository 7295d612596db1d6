// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/solid/body/mesh_description.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_out.h>
#include <deal.II/grid/tria.h>

#include "fuzz.h"

#include <fstream>

using namespace contrecoup;

namespace
{
void prepare_mesh(const std::string &folder)
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::subdivided_hyper_cube(mesh, 2);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(3);
  std::ofstream stream(folder + "/mesh.msh");
  dealii::GridOut().write_msh(mesh, stream);
}

void read_mesh(const std::string &path)
{
  dealii::ParameterHandler prm;
  solid::MeshDescription::declare_parameters(prm);
  const auto assign = [](const std::string &entry, const std::string &value) {
    return Assignment{{"Mesh"}, entry, value, "fuzz"};
  };
  apply_assignments({assign("Kind", "file"),
                     assign("File", path),
                     assign("Tissues", "3: skeleton")},
                    prm);
  solid::MeshDescription mesh;
  mesh.parse_parameters(prm);
  solid::distribute(mesh.create(), MPI_COMM_SELF);
}
} // namespace


int main(int argc, char **argv)
{
  return fuzz::run(argc, argv, {{"mesh", "mesh.msh", prepare_mesh, read_mesh}});
}
