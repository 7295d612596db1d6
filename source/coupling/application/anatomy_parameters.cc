// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/new_tissues.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/anatomy_parameters.h>
#include <contrecoup/materials/tissue_library.h>

#include <algorithm>

namespace contrecoup
{
namespace coupling
{
  namespace
  {
    void declare_mesh(dealii::ParameterHandler &prm)
    {
      const Section section(prm, "Mesh");
      const UsedWith used("Body/Kind not mesh");
      declare_double(prm,
                     "Element size",
                     "0.01",
                     1e-6,
                     1e3,
                     "m",
                     "Edge of the hexahedra; with coarsening, of those at "
                     "surfaces and interfaces.");
      declare_integer(prm,
                      "Coarsening levels",
                      "0",
                      0,
                      6,
                      "Number of times that the element size doubles away from "
                      "surfaces and interfaces, 0 to 6; neighbours differ by "
                      "one level, and hanging nodes are listed in "
                      "hanging_nodes.csv.");
      declare_integer(prm,
                      "Smoothing iterations",
                      "0",
                      0,
                      1000,
                      "Iterations of Taubin's filter on surfaces and "
                      "interfaces, 0 (staircase) to 1000; 20 are usual.");
      declare_double(
        prm,
        "Smallest scaled Jacobian",
        "0.2",
        0.01,
        0.9,
        "-",
        used_with("Mesh/Smoothing iterations not 0",
                  "Lower bound of the scaled Jacobian, 0.01 to 0.9: "
                  "smoothing is undone where an element would fall below."));
    }

    void declare_output(dealii::ParameterHandler &prm)
    {
      const Section section(prm, "Output");
      declare_bool(prm,
                   "Surface",
                   "true",
                   "Whether the outer surface is written: surface.vtu of "
                   "quadrilaterals, surface.stl of triangles.");
      declare_bool(prm,
                   "Gmsh",
                   "false",
                   "Whether mesh.msh is written, which Gmsh and deal.II read: "
                   "some 100 bytes an element.");
      declare_double(prm,
                     "Distance spacing",
                     "0",
                     0.,
                     1e3,
                     "m",
                     "Spacing of a grid of signed distances, distance.vti; 0: "
                     "none is written.");
      declare_bool(prm,
                   "Pictures",
                   "true",
                   "Whether pictures of the body and its quality are drawn.");
    }
  } // namespace

  void AnatomyParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    {
      const Section section(prm, "Body");
      BodyDescription::declare_parameters(prm);
    }
    declare_mesh(prm);
    {
      const Section section(prm, "Tissues");
      declare_selection(prm,
                        "Set",
                        "physiological",
                        tissue_set_names(),
                        "Densities and moduli for masses and time steps: "
                        "those of the paper's table 1, or wave speeds as "
                        "measured on tissue.");
      OwnTissues::declare_parameters(prm);
    }
    declare_output(prm);
  }

  void AnatomyParameters::parse_parameters(dealii::ParameterHandler &prm)
  {
    own_tissues = read_own_tissues(prm);
    layers = read_layers(prm);
    {
      const Section section(prm, "Body");
      body.parse_parameters(prm);
    }
    {
      const Section section(prm, "Mesh");
      element_size = read_double(prm, "Element size");
      levels = read_unsigned(prm, "Coarsening levels");
      smoothing.iterations = read_unsigned(prm, "Smoothing iterations");
      smoothing.smallest_scaled_jacobian =
        read_double(prm, "Smallest scaled Jacobian");
    }
    {
      const Section section(prm, "Tissues");
      tissue_set = prm.get("Set");
    }
    const Section section(prm, "Output");
    write_surface = prm.get_bool("Surface");
    write_gmsh = prm.get_bool("Gmsh");
    distance_spacing = read_double(prm, "Distance spacing");
    draw = prm.get_bool("Pictures");
  }


  OwnTissues read_own_tissues(dealii::ParameterHandler &prm)
  {
    OwnTissues own;
    own.parse_parameters(prm, "Tissues");
    const Section section(prm, "Tissues");
    for (const Tissue tissue : own.tissues())
      find_solid_material(prm.get("Set"), tissue, own);
    return own;
  }


  void require_parts(const OwnTissues &tissues, const Body &body)
  {
    std::vector<std::string> names;
    for (const BodyPart &part : body.parts())
    {
      if (is_new(part.tissue))
        tissues.apply(part.tissue, {});
      if (std::find(names.begin(), names.end(), name_of(part.tissue)) ==
          names.end())
        names.push_back(name_of(part.tissue));
    }
    Selections selections;
    for (const Tissue tissue : tissues.tissues())
    {
      const std::string &name = name_of(tissue);
      selections.add("Tissues/Tissue " + name,
                     name,
                     "part of the body",
                     std::count(names.begin(), names.end(), name));
    }
    selections.require_some(MPI_COMM_SELF,
                            "the tissues of the body are " + join(names, ", "));
  }
} // namespace coupling
} // namespace contrecoup
