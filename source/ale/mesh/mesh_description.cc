// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/ale/mesh/mesh_description.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  const std::vector<std::string> kinds{"box",
                                       "half ball",
                                       "layered head",
                                       "file",
                                       "body"};

  void declare_sides(ParameterHandler &prm)
  {
    const Section section(prm, "Side *");
    declare_selection(prm,
                      "Kind",
                      "wall",
                      {"wall", "free", "clamped"},
                      "wall: matter slides without friction; free: no load; "
                      "clamped: holds the matter that touches the side, "
                      "with particles (Method = mpm) only. Unnamed sides "
                      "are walls, but the surface of a head or a file is "
                      "free.");
    declare_string(prm,
                   "Velocity",
                   "0",
                   "Velocity of the wall along its outward normal [m/s], a "
                   "muParser expression of t.");
  }

  void declare_box(ParameterHandler &prm)
  {
    const UsedWith used("Mesh/Kind = box");
    declare_list(
      prm, "Lower corner", "0, 0, 0", 3, 3, -1e6, 1e6, "m", "Box corner.");
    declare_list(
      prm, "Upper corner", "1, 1, 1", 3, 3, -1e6, 1e6, "m", "Box corner.");
    declare_list(prm,
                 "Elements",
                 "10, 10, 10",
                 3,
                 3,
                 1.,
                 1e5,
                 "-",
                 "Number of cells of the box along x, y and z.");
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
                      "A box; the half at x >= 0 of a ball around the "
                      "origin; a layered head of brain, CSF, skull and "
                      "scalp around the origin; the mesh of a file; or, "
                      "with particles (Method = mpm) only, a body of "
                      "subsection Body.");
    declare_box(prm);
    declare_double(prm,
                   "Radius",
                   "0.09",
                   1e-6,
                   1e6,
                   "m",
                   used_with("Mesh/Kind = half ball", "Half ball radius."));
    declare_integer(prm,
                    "Refinements",
                    "3",
                    0,
                    8,
                    used_with("Mesh/Kind = half ball",
                              "Global refinements of the half ball, 0 to 8."));
    for (const char *const name : {"x", "y", "z"})
      declare_string(prm,
                     std::string("Position ") + name,
                     name,
                     "Initial position of the mesh node x, y, z [m], a "
                     "muParser expression of x, y, z; turns a box into a wedge "
                     "or cone. Other entries refer to the moved nodes.");
    LayeredHead::declare_parameters(prm);
    const UsedWith used("Mesh/Kind = file");
    FileMesh::declare_parameters(prm);
  }
  {
    const Section section(prm, "Body");
    const UsedWith used("Mesh/Kind = body");
    BodyDescription::declare_parameters(prm);
  }
  declare_sides(prm);
}


void MeshDescription::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Mesh");
    kind_ = prm.get("Kind");
    lower_ = read_point<3>(prm, "Lower corner");
    upper_ = read_point<3>(prm, "Upper corner");
    for (const double n : read_list(prm, "Elements"))
      elements_.push_back(static_cast<unsigned int>(n));
    radius_ = read_double(prm, "Radius");
    refinements_ = read_unsigned(prm, "Refinements");
    const std::vector<std::string> axes{"x", "y", "z"};
    bool moves = false;
    for (const std::string &axis : axes)
    {
      const std::string name = "Position " + axis;
      position_.emplace_back("Mesh/" + name, prm.get(name));
      moves = moves || position_.back().text() != axis;
    }
    if (!moves)
      position_.clear();
    if (kind_ != "layered head" && kind_ != "file" &&
        !trim(prm.get("Symmetry planes")).empty())
      throw InputError("Mesh/Symmetry planes is for Mesh/Kind = layered head "
                       "or file; the sides of a " +
                       kind_ + " are walls unless a \"Side *\" says otherwise");
    if (kind_ == "layered head")
      head_.parse_parameters(prm);
    else if (read_wedge_axis(prm) < 3)
      throw InputError("Mesh/Wedge axis is for Mesh/Kind = layered head; a " +
                       kind_ + " is as its mesh has it");
    if (kind_ == "file")
      file_.parse_parameters(prm);
  }
  if (kind_ == "body")
  {
    const Section section(prm, "Body");
    BodyDescription description;
    description.parse_parameters(prm);
    body_ = description.create();
    for (const BodyPart &part : body_->parts())
      body_layers_.push_back({name_of(part.tissue), {}});
  }
  for (unsigned int d = 0; d < 3; ++d)
    if (kind_ == "box" && !(lower_[d] < upper_[d]))
      throw InputError("Mesh/Upper corner must be above Mesh/Lower corner in "
                       "every direction");
  parse_sides(prm);
}


const std::vector<std::string> &MeshDescription::side_names() const
{
  // Ordered by deal.II's boundary ids.
  static const std::vector<std::string> box{"x-", "x+", "y-", "y+", "z-", "z+"},
    half_ball{"sphere", "plane"},
    head{"surface", "plane x", "plane y", "plane z"};
  if (kind_ == "layered head" || kind_ == "file" || kind_ == "body")
    return head;
  return kind_ == "box" ? box : half_ball;
}


dealii::types::boundary_id
MeshDescription::find_side(const std::string &name) const
{
  const auto &names = side_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end())
    return static_cast<dealii::types::boundary_id>(found - names.begin());
  const bool is_number =
    kind_ == "file" && !name.empty() && name.size() < 10 && name[0] != '0' &&
    name.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number)
    throw InputError("Side " + name + ": a mesh of kind " + kind_ +
                     " has no such side, but " + join(names, ", ") +
                     (kind_ == "file" ? ", and numbers of faces" : ""));
  return FileMesh::boundary_id(std::stoul(name));
}


void MeshDescription::check_numbered_sides() const
{
  for (const unsigned int number : numbered_sides_)
    if (file_.boundaries().count(number) == 0)
    {
      std::vector<std::string> known;
      for (const unsigned int one : file_.boundaries())
        known.push_back(std::to_string(one));
      throw InputError(
        "Side " + std::to_string(number) +
        ": no face of the surface has this number in the file; " +
        (known.empty() ? "none has any" : "there are " + join(known, ", ")));
    }
}


void MeshDescription::check_symmetry_plane(const ParameterHandler &prm,
                                           const std::string &name) const
{
  if (name.rfind("plane ", 0) != 0)
    return;
  if (kind_ == "body" || !symmetry_planes()[name.back() - 'x'])
    throw InputError("Side " + name +
                     " selects no side: Mesh/Symmetry planes does not name " +
                     name.back());
  if (prm.get("Kind") == "free" || prm.get("Velocity") != "0")
    throw InputError("Side " + name +
                     ": Mesh/Symmetry planes makes it a wall at rest; leave "
                     "Kind and Velocity as they are, or take " +
                     name.back() + " from Mesh/Symmetry planes");
}


void MeshDescription::parse_sides(ParameterHandler &prm)
{
  const auto &names = side_names();
  for (unsigned int i = 0; i < names.size(); ++i)
    if (names[i] != "surface")
      walls_[i] = [](double) { return 0.; };
  for (const std::string &name : item_names(prm, "Side"))
  {
    const auto id = find_side(name);
    if (id >= names.size())
      numbered_sides_.insert(std::stoul(name));
    const Section section(prm, "Side " + name);
    check_symmetry_plane(prm, name);
    if (prm.get("Kind") == "free")
    {
      walls_.erase(id);
      continue;
    }
    const Expression velocity("Side " + name + "/Velocity",
                              prm.get("Velocity"));
    if (velocity.depends_on_place())
      throw InputError("Side " + name +
                       "/Velocity: a wall is rigid; its velocity must not "
                       "depend on x, y or z");
    walls_[id] = [velocity](const double time) {
      return velocity.value(dealii::Point<3>(), time);
    };
    if (prm.get("Kind") == "clamped")
      clamp(id, name);
  }
}


void MeshDescription::clamp(const dealii::types::boundary_id side,
                            const std::string &name)
{
  const bool is_plane = kind_ == "box" || (kind_ == "half ball" && side == 1) ||
                        (kind_ == "layered head" && side > 0);
  if (!is_plane)
    throw InputError("Side " + name +
                     "/Kind = clamped is for plane sides: those of a box, the "
                     "plane of a half ball and the planes of a layered head");
  clamped_.insert(side);
}


double MeshDescription::n_cells() const
{
  if (kind_ == "box")
    return double(elements_[0]) * elements_[1] * elements_[2];
  if (kind_ == "layered head")
    return head_.n_cells();
  if (kind_ == "file")
    return file_.n_cells();
  return 6. * std::pow(8., refinements_);
}


double MeshDescription::largest_wall_speed(const double end_time) const
{
  constexpr unsigned int n_times = 16;
  double largest = 0.;
  for (const auto &wall : walls_)
    for (unsigned int i = 0; i <= n_times; ++i)
      largest =
        std::max(largest, std::abs(wall.second(end_time * i / n_times)));
  return largest;
}


double MeshDescription::cell_size() const
{
  if (!position_.empty())
  {
    dealii::Triangulation<3> mesh;
    create(mesh);
    double shortest = std::numeric_limits<double>::max();
    for (const auto &cell : mesh.active_cell_iterators())
      shortest = std::min(shortest, cell->minimum_vertex_distance());
    return shortest;
  }
  if (kind_ == "layered head")
    return head_.cell_size();
  if (kind_ == "file")
    return file_.cell_size();
  if (kind_ != "box")
    return 0.3 * radius_ * std::pow(0.5, refinements_);
  double size = std::numeric_limits<double>::max();
  for (unsigned int d = 0; d < 3; ++d)
    size = std::min(size, (upper_[d] - lower_[d]) / elements_[d]);
  return size;
}


void MeshDescription::move_nodes(dealii::Triangulation<3> &mesh) const
{
  if (position_.empty())
    return;
  dealii::GridTools::transform(
    [this](const dealii::Point<3> &place) {
      return dealii::Point<3>(position_[0].value(place),
                              position_[1].value(place),
                              position_[2].value(place));
    },
    mesh);
  require_valid_cells(mesh);
}


void MeshDescription::create(dealii::Triangulation<3> &mesh) const
{
  if (!clamped_.empty())
    throw InputError("Side " + side_names()[*clamped_.begin()] +
                     "/Kind = clamped is for particles only, Method = mpm; "
                     "with Method = ale use wall or free");
  if (kind_ == "body")
    throw InputError("Mesh/Kind = body is for particles only, Method = mpm; "
                     "with Method = ale use Mesh/Kind = file with a mesh made "
                     "by anatomy");
  if (kind_ == "layered head")
  {
    head_.create(mesh);
    return move_nodes(mesh);
  }
  if (kind_ == "file")
  {
    file_.create(mesh);
    check_numbered_sides();
    return move_nodes(mesh);
  }
  if (kind_ == "box")
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, elements_, lower_, upper_, true);
  else
  {
    dealii::Triangulation<3> coarse;
    dealii::GridGenerator::half_hyper_ball(coarse, dealii::Point<3>(), radius_);
    coarse.refine_global(refinements_);
    dealii::GridGenerator::flatten_triangulation(coarse, mesh);
  }
  move_nodes(mesh);
  // Expressions set the regions, not deal.II's octant ids.
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(0);
}
} // namespace contrecoup::ale
