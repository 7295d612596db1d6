// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/mesh/mesh_file.h>
#include <contrecoup/geometry/mesh/mesh_format.h>
#include <contrecoup/solid/body/mesh_description.h>

namespace contrecoup::solid
{
namespace
{
  const std::vector<std::string> kinds{"box",
                                       "ball octant",
                                       "shell octant",
                                       "patch",
                                       "file",
                                       "body"};

  void declare_box(ParameterHandler &prm)
  {
    const UsedWith used("Mesh/Kind = box");
    declare_list(prm,
                 "Lower corner",
                 "0, 0, 0",
                 3,
                 3,
                 -1e6,
                 1e6,
                 "m",
                 "Lower corner of the box.");
    declare_list(prm,
                 "Upper corner",
                 "1, 1, 1",
                 3,
                 3,
                 -1e6,
                 1e6,
                 "m",
                 "Upper corner of the box.");
    declare_list(prm,
                 "Elements",
                 "4, 4, 4",
                 3,
                 3,
                 1.,
                 1e5,
                 "-",
                 "Number of elements of the box along x, y and z.");
    declare_string(
      prm,
      "Refined where",
      "",
      selecting("muParser expression of x, y, z: elements of the box "
                "with a true value at their centre are refined once. "
                "Several expressions, separated by ';', apply one after "
                "the other. Hanging nodes arise where sizes differ."));
    declare_double(prm,
                   "Distortion",
                   "0",
                   0.,
                   0.45,
                   "-",
                   "Inner nodes of the box are moved randomly by this "
                   "fraction of the shortest edge.");
  }

  void declare_others(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Inner radius",
                   "0.01",
                   1e-9,
                   1e6,
                   "m",
                   used_with("Mesh/Kind = shell octant",
                             "Inner radius of the shell octant."));
    declare_double(
      prm,
      "Outer radius",
      "0.1",
      1e-9,
      1e6,
      "m",
      used_with("Mesh/Kind = ball octant, shell octant",
                "Outer radius of the ball or shell octant, x, y, z >= 0."));
    declare_integer(
      prm,
      "Refinements",
      "0",
      0,
      10,
      used_with(
        "Mesh/Kind = ball octant, shell octant, file",
        "Number of global refinements of ball, shell or file, 0 to 10."));
    {
      const UsedWith used("Mesh/Kind = file");
      declare_file(prm,
                   "File",
                   "",
                   "Mesh of 8-node hexahedra with lengths in m: " +
                     accepted_mesh_formats() + ".");
      MeshGroups::declare_parameters(prm);
    }
  }

  void declare_elements_of_body(ParameterHandler &prm)
  {
    const UsedWith used("Mesh/Kind = body");
    const UsedWith also("Body/Kind not mesh");
    declare_double(prm,
                   "Element size",
                   "0.01",
                   1e-6,
                   1e3,
                   "m",
                   "Edge length of the elements of a body; with coarsening, "
                   "of those at surfaces and interfaces.");
    declare_integer(prm,
                    "Coarsening levels",
                    "0",
                    0,
                    6,
                    "How often the elements of a body may double in size "
                    "away from surfaces and interfaces, 0 to 6.");
    declare_integer(prm,
                    "Smoothing iterations",
                    "0",
                    0,
                    1000,
                    "Steps of Taubin smoothing of the surfaces and "
                    "interfaces of a body, 0 (voxel stairs) to 1000.");
    declare_double(
      prm,
      "Smallest scaled Jacobian",
      "0.2",
      0.01,
      0.9,
      "-",
      used_with("Mesh/Smoothing iterations not 0",
                "Smoothing is undone where it would reduce the scaled "
                "Jacobian of an element below this value."));
  }

  void declare_tissues(ParameterHandler &prm)
  {
    const std::string known =
      join({tissue_names().begin() + 1, tissue_names().end()}, ", ");
    declare_string(
      prm,
      "Tissue",
      "soft tissue",
      used_with("Mesh/Kind = box, ball octant, shell octant, patch",
                "Tissue of box, octants and patch: one of " + known +
                  ", or of the user's own (Materials/Tissue NAME)."));
    const Section section(prm, "Region *");
    declare_string(prm,
                   "Tissue",
                   "soft tissue",
                   "Tissue of the elements of this region, as Mesh/Tissue.");
    declare_string(
      prm,
      "Where",
      "1",
      selecting("muParser expression of x, y, z that is true at the "
                "centres of the region's elements; later regions win."));
  }
} // namespace


void MeshDescription::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Mesh");
    declare_selection(prm,
                      "Kind",
                      "box",
                      kinds,
                      "patch is the unit cube of 7 elements of MacNeal and "
                      "Harder; body is the shape of section Body.");
    declare_box(prm);
    declare_others(prm);
    declare_elements_of_body(prm);
    declare_tissues(prm);
  }
  const Section section(prm, "Body");
  const UsedWith used("Mesh/Kind = body");
  BodyDescription::declare_parameters(prm);
}
} // namespace contrecoup::solid
