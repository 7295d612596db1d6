// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/boundary.h>
#include <contrecoup/gas/state/state_parameters.h>

namespace contrecoup::gas
{
namespace
{
  const std::vector<std::string> box_sides =
    {"x low", "x high", "y low", "y high", "z low", "z high"};

  const std::vector<std::string> kind_names =
    {"wall", "symmetry", "open", "inflow", "initial", "exact"};

  template <int dim>
  typename Boundary<dim>::Kind parse_kind(const std::string &name,
                                          const std::string &where)
  {
    using Kind = typename Boundary<dim>::Kind;
    const std::map<std::string, Kind> kinds = {{"wall", Kind::wall},
                                               {"symmetry", Kind::wall},
                                               {"open", Kind::open},
                                               {"inflow", Kind::inflow},
                                               {"initial", Kind::initial},
                                               {"exact", Kind::exact}};
    const auto found = kinds.find(name);
    if (found == kinds.end())
      throw InputError(where + ": \"" + name +
                       "\" is not a boundary; use wall, symmetry, open, "
                       "inflow, initial or exact");
    return found->second;
  }

  /// Builds a mesh that is not a box.
  /// @throws InputError unless the mesh has all boundary ids of @p kinds.
  template <int dim, typename Kinds>
  void check_ids(const CoarseMesh<dim> &coarse_mesh, const Kinds &kinds)
  {
    if (coarse_mesh.is_axis_aligned() || kinds.empty())
      return;
    dealii::Triangulation<dim> triangulation;
    coarse_mesh.create(triangulation);
    const auto ids = triangulation.get_boundary_ids();
    std::string known;
    for (const auto id : ids)
      known += (known.empty() ? "" : ", ") + std::to_string(id);
    for (const auto &[id, kind] : kinds)
      if (std::find(ids.begin(), ids.end(), id) == ids.end())
        throw InputError("Boundaries/By id: the mesh has no boundary " +
                         std::to_string(id) + ", only " + known);
  }
} // namespace


template <int dim>
void Boundary<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Boundaries");
  for (const std::string &side : box_sides)
    declare_selection(
      prm,
      side,
      "wall",
      kind_names,
      used_with("Domain/Mesh = box",
                "Boundary condition at this side of a box: a rigid "
                "slip wall (also for planes of symmetry and the "
                "axis), a non-reflecting open side, an inflow of the "
                "state of subsection Inflow, or the initial state or reference "
                "solution at that position and time."));
  declare_string(
    prm,
    "By id",
    "",
    used_with(
      "Domain/Mesh not box",
      selecting("For meshes other than boxes: \"id: kind, id: kind\", with "
                "the boundary ids of the mesh and the kinds above; ids that "
                "are not listed are walls.")));
  const Section inflow(prm, "Inflow");
  const UsedWith used(join(box_sides, " or ") + " or By id = inflow");
  declare_state(prm);
}


template <int dim>
void Boundary<dim>::parse_parameters(ParameterHandler &prm,
                                     const GasMaterial &material,
                                     const CoarseMesh<dim> &coarse_mesh,
                                     const InitialState<dim> &initial_state,
                                     const ReferenceSolution<dim> &reference)
{
  const Section section(prm, "Boundaries");
  initial_state_ = &initial_state;
  reference_ = &reference;
  kinds_.clear();
  if (coarse_mesh.is_axis_aligned())
    for (unsigned int side = 0; side < 2 * dim; ++side)
      kinds_[side] = parse_kind<dim>(prm.get(box_sides[side]),
                                     "Boundaries/" + box_sides[side]);
  else
    for (const std::string &side : box_sides)
      if (prm.get(side) != "wall")
        throw InputError("Boundaries/" + side +
                         " needs Domain/Mesh = box; name the boundaries of "
                         "other meshes in Boundaries/By id");
  for (const auto &item :
       dealii::Utilities::split_string_list(prm.get("By id")))
  {
    const auto words = dealii::Utilities::split_string_list(item, ':');
    if (words.size() != 2 ||
        words[0].find_first_not_of("0123456789") != std::string::npos)
      throw InputError("Boundaries/By id = \"" + item +
                       "\": write \"id: kind\"");
    kinds_[dealii::Utilities::string_to_int(words[0])] =
      parse_kind<dim>(words[1], "Boundaries/By id");
  }
  kind_of_id_.assign(kinds_.empty() ? 0 : kinds_.rbegin()->first + 1,
                     default_kind_);
  for (const auto &[id, kind] : kinds_)
    kind_of_id_[id] = kind;
  check_ids(coarse_mesh, kinds_);
  for (const auto &[id, kind] : kinds_)
    if (kind == Kind::exact && !reference.exists())
      throw InputError("Boundaries: boundary " + std::to_string(id) +
                       " is exact, but Reference/Kind names no solution");

  const Section inflow(prm, "Inflow");
  inflow_ = read_state<dim>(prm, material, "Boundaries/Inflow");
}


template <int dim>
bool Boundary<dim>::is_closed(const CoarseMesh<dim> &coarse_mesh) const
{
  for (const auto &[id, kind] : kinds_)
    if (kind != Kind::wall &&
        !(coarse_mesh.is_axis_aligned() && coarse_mesh.is_periodic(id / 2)))
      return false;
  return true;
}


template <int dim>
GasState<dim> Boundary<dim>::outside(const unsigned int boundary_id,
                                     const GasState<dim> &inside,
                                     const dealii::Tensor<1, dim> &normal,
                                     const dealii::Point<dim> &point,
                                     const double time) const
{
  GasState<dim> state = inside;
  switch (kind(boundary_id))
  {
    case Kind::wall:
      state.velocity -= 2. * (state.velocity * normal) * normal;
      break;
    case Kind::open:
      break;
    case Kind::inflow:
      state = inflow_;
      break;
    case Kind::initial:
      state = initial_state_->value(point);
      break;
    case Kind::exact:
      state = reference_->value(point, time);
      break;
  }
  return state;
}


template class Boundary<1>;
template class Boundary<2>;
template class Boundary<3>;
} // namespace contrecoup::gas
