// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/geometry/mesh/cell_shapes.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/geometry/mesh/mesh_file.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <sstream>

namespace contrecoup
{
namespace
{
  using dealii::ParameterHandler;
  namespace numbers = dealii::numbers;
  namespace Patterns = dealii::Patterns;

  const std::string direction_names = "xyz";

  template <int dim>
  dealii::Point<dim> parse_point(const std::string &text,
                                 const std::string &entry)
  {
    const auto words = dealii::Utilities::split_string_list(text);
    if (words.size() < dim)
      throw InputError("Domain/" + entry + " = \"" + text + "\": needs " +
                       std::to_string(dim) +
                       " numbers, one for each direction");
    dealii::Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = dealii::Utilities::string_to_double(words[d]);
    return point;
  }

  Geometry parse_geometry(const std::string &name, const int dim)
  {
    if (name == "plane")
      return Geometry::plane;
    if (name == "axisymmetric" && dim == 2)
      return Geometry::axisymmetric;
    if (name == "cylindrical" && dim == 1)
      return Geometry::cylindrical;
    if (name == "spherical" && dim == 1)
      return Geometry::spherical;
    throw InputError("Domain/Geometry = " + name + " does not go with " +
                     std::to_string(dim) +
                     " dimension(s): cylindrical and spherical are for 1, "
                     "axisymmetric is for 2, plane is for all");
  }

  void declare_shapes(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Cone angle",
      "1.134",
      Patterns::Double(1e-3, 120.),
      used_with("Domain/Mesh = cone",
                "Angle between opposite sides of the cone [degrees], "
                "with square cross-section in 3-D, a wedge in 2-D; "
                "the tip is the origin, and x ranges from that of "
                "Lower corner, which must be positive, to that of "
                "Upper corner."));
    prm.declare_entry(
      "Generator",
      "hyper_ball",
      Patterns::Anything(),
      used_with("Domain/Mesh = generator",
                "Name of the deal.II GridGenerator function. Where it has "
                "curved manifolds, refined cells follow these, and cells "
                "of the Galerkin scheme are curved (Method/Cell degree)."));
    prm.declare_entry(
      "Generator arguments",
      "",
      Patterns::Anything(),
      used_with("Domain/Mesh = generator",
                "All arguments after the triangulation, including "
                "those with defaults, separated by colons, lengths in "
                "m; a hyper_ball in 2-D has \"0, 0 : 1 : true\"."));
    prm.declare_entry(
      "Mesh file",
      "",
      Patterns::FileName(),
      used_with("Domain/Mesh = file",
                "Path of a mesh of hexahedra or quadrilaterals in a "
                "format that deal.II recognises by extension (.msh, "
                ".inp, .vtk, .ucd, .unv), lengths in m; relative "
                "paths are first resolved beside the parameter file."));
  }
} // namespace


unsigned int radial_exponent(const Geometry geometry)
{
  switch (geometry)
  {
    case Geometry::plane:
      return 0;
    case Geometry::cylindrical:
    case Geometry::axisymmetric:
      return 1;
    case Geometry::spherical:
      return 2;
  }
  return 0;
}


template <int dim>
void CoarseMesh<dim>::declare_parameters(ParameterHandler &prm)
{
  prm.enter_subsection("Domain");
  prm.declare_entry("Dimension",
                    "3",
                    Patterns::Integer(1, 3),
                    "Space dimensions of the mesh [-], 1 to 3.");
  prm.declare_entry(
    "Geometry",
    "plane",
    Patterns::Selection("plane|cylindrical|spherical|axisymmetric"),
    "Coordinate system: plane (1 to 3 dimensions), cylindrical or spherical "
    "(1), axisymmetric (2); x is the radius in the last three.");
  prm.declare_entry("Mesh",
                    "box",
                    Patterns::Selection("box|cone|generator|file"),
                    "Coarse mesh: a box of equal cells, a cone around the x "
                    "axis, a deal.II GridGenerator function, or a file.");
  const Patterns::Double coordinate(-bounds::length, bounds::length);
  prm.declare_entry(
    "Lower corner",
    "0, 0, 0",
    Patterns::List(coordinate, 1, 3),
    used_with("Domain/Mesh = box, cone",
              "Corner of the box with the smallest coordinates [m]."));
  prm.declare_entry(
    "Upper corner",
    "1, 1, 1",
    Patterns::List(coordinate, 1, 3),
    used_with("Domain/Mesh = box, cone",
              "Corner of the box with the largest coordinates [m]."));
  prm.declare_entry("Size",
                    "given",
                    Patterns::Selection("given|by time"),
                    "given: the box of the corners; by time: the box grows "
                    "beyond its open sides by whole coarse leaves until no "
                    "wave from these sides can reach a point of Probes or "
                    "the rigid body before the end time.");
  prm.declare_entry(
    "Coarse leaves",
    "1, 1, 1",
    Patterns::List(Patterns::Integer(1), 1, 3),
    used_with("Domain/Mesh = box, cone",
              "Leaves of the unrefined box in each direction [-], at "
              "least 1; each is the root of an octree."));
  prm.declare_entry("Initial refinement",
                    "0",
                    Patterns::Integer(0, 20),
                    "Number of uniform refinements at the start [-], 0 to "
                    "20.");
  prm.declare_entry("Periodic directions",
                    "",
                    Patterns::List(Patterns::Selection("x|y|z"), 0, 3),
                    "Directions with periodic boundary conditions.");
  declare_shapes(prm);
  prm.leave_subsection();
}


template <int dim>
void CoarseMesh<dim>::parse_parameters(ParameterHandler &prm)
{
  prm.enter_subsection("Domain");
  kind_ = prm.get("Mesh");
  geometry_ = parse_geometry(prm.get("Geometry"), dim);
  lower_ = parse_point<dim>(prm.get("Lower corner"), "Lower corner");
  upper_ = parse_point<dim>(prm.get("Upper corner"), "Upper corner");
  initial_refinement_ = prm.get_integer("Initial refinement");
  generator_ = prm.get("Generator");
  generator_arguments_ = prm.get("Generator arguments");
  file_ = prm.get("Mesh file");
  cone_angle_ = prm.get_double("Cone angle") * numbers::PI / 180.;

  const auto leaves =
    dealii::Utilities::split_string_list(prm.get("Coarse leaves"));
  if (leaves.size() < dim)
    throw InputError("Domain/Coarse leaves needs " + std::to_string(dim) +
                     " numbers, one for each direction");
  subdivisions_.clear();
  for (unsigned int d = 0; d < dim; ++d)
    subdivisions_.push_back(dealii::Utilities::string_to_int(leaves[d]));

  periodic_.fill(false);
  for (const auto &name :
       dealii::Utilities::split_string_list(prm.get("Periodic directions")))
  {
    const auto d = direction_names.find(name);
    if (d >= dim)
      throw InputError("Domain/Periodic directions = " + name +
                       ": the mesh has only " + std::to_string(dim) +
                       " dimension(s)");
    periodic_[d] = true;
  }
  prm.leave_subsection();
  check_box();
}


template <int dim>
void CoarseMesh<dim>::check_box() const
{
  const bool any_periodic =
    std::any_of(periodic_.begin(), periodic_.end(), [](bool p) { return p; });
  if (kind_ != "box")
  {
    if (any_periodic)
      throw InputError("Domain/Periodic directions: only a box can be "
                       "periodic, Domain/Mesh is " +
                       kind_);
    if (geometry_ != Geometry::plane)
      throw InputError("Domain/Geometry: Domain/Mesh = " + kind_ +
                       " goes with plane geometry only");
    if (dim == 1)
      throw InputError("Domain/Mesh = " + kind_ +
                       ": in 1 dimension only box is available");
    if (kind_ == "cone" && !(lower_[0] > 0. && lower_[0] < upper_[0]))
      throw InputError("Domain/Mesh = cone: the x of Lower corner must be "
                       "above 0 and below that of Upper corner");
    return;
  }
  for (unsigned int d = 0; d < dim; ++d)
    if (!(lower_[d] < upper_[d]))
    {
      std::ostringstream message;
      message << "Domain/Upper corner = " << upper_[d] << " m in direction "
              << direction_names[d] << " must be larger than the lower corner, "
              << lower_[d] << " m";
      throw InputError(message.str());
    }
  if (geometry_ != Geometry::plane && lower_[0] < 0.)
    throw InputError("Domain/Lower corner: the radius must not be negative "
                     "in this geometry");
  if (geometry_ != Geometry::plane && periodic_[0])
    throw InputError("Domain/Periodic directions: the radius, x, cannot be "
                     "periodic in this geometry");
}


template <int dim>
void CoarseMesh<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  if (kind_ == "box")
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, subdivisions_, lower_, upper_, true);
    match_periodic_faces(triangulation);
    return;
  }
  if (kind_ == "cone")
    create_cone(triangulation);
  else if (kind_ == "file")
    for (const std::string &line :
         read_mesh_file(file_, "Domain/Mesh file", triangulation))
      log_line(line);
  else
  {
    try
    {
      dealii::GridGenerator::generate_from_name_and_arguments(
        triangulation, generator_, generator_arguments_);
    }
    catch (const std::exception &)
    {
      throw InputError(
        "Domain/Generator = " + generator_ + "(" + generator_arguments_ +
        "): deal.II has no such generator in " + std::to_string(dim) +
        " dimensions or does not take these arguments (all of them must be "
        "given, separated by colons)");
    }
  }
  check_cells(triangulation);
}


template <int dim>
void CoarseMesh<dim>::create_cone(
  dealii::Triangulation<dim> &triangulation) const
{
  dealii::Point<dim> lower, upper;
  lower[0] = lower_[0];
  upper[0] = upper_[0];
  for (unsigned int d = 1; d < dim; ++d)
  {
    lower[d] = -1.;
    upper[d] = 1.;
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(
    triangulation, subdivisions_, lower, upper, true);
  const double slope = std::tan(0.5 * cone_angle_);
  dealii::GridTools::transform(
    [slope](const dealii::Point<dim> &point) {
      dealii::Point<dim> result = point;
      for (unsigned int d = 1; d < dim; ++d)
        result[d] *= slope * point[0];
      return result;
    },
    triangulation);
}


template <int dim>
void CoarseMesh<dim>::check_cells(
  const dealii::Triangulation<dim> &triangulation) const
{
  if (!triangulation.all_reference_cells_are_hyper_cube())
    throw InputError("Domain/Mesh " + kind_ + ": some cells are no " +
                     (dim == 3 ? "hexahedra" : "quadrilaterals"));
  check_cell_shapes(triangulation, "Domain/Mesh " + kind_);
}


template <int dim>
void CoarseMesh<dim>::match_periodic_faces(
  dealii::Triangulation<dim> &triangulation) const
{
  if constexpr (dim > 1)
  {
    std::vector<dealii::GridTools::PeriodicFacePair<
      typename dealii::Triangulation<dim>::cell_iterator>>
      pairs;
    for (unsigned int d = 0; d < dim; ++d)
      if (periodic_[d])
        dealii::GridTools::collect_periodic_faces(
          triangulation, 2 * d, 2 * d + 1, d, pairs);
    if (!pairs.empty())
      triangulation.add_periodicity(pairs);
  }
}


template <int dim>
double CoarseMesh<dim>::n_coarse_cells() const
{
  if (kind_ != "box")
    return 0.;
  double n = 1.;
  for (const unsigned int s : subdivisions_)
    n *= s;
  return n;
}


template <int dim>
unsigned int
CoarseMesh<dim>::coarse_cell_at(const dealii::Point<dim> &point) const
{
  unsigned int result = 0, factor = 1;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double place = (point[d] - lower_[d]) / (upper_[d] - lower_[d]);
    const double index = std::floor(place * subdivisions_[d]);
    const double last = subdivisions_[d] - 1.;
    result +=
      factor * static_cast<unsigned int>(std::min(std::max(index, 0.), last));
    factor *= subdivisions_[d];
  }
  return result;
}


template class CoarseMesh<1>;
template class CoarseMesh<2>;
template class CoarseMesh<3>;
} // namespace contrecoup
