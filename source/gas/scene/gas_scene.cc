// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/gas/scene/gas_scene.h>
#include <contrecoup/gas/scene/scene_bursts.h>
#include <contrecoup/gas/scene/scene_places.h>

namespace contrecoup::gas
{
template <int dim>
void GasScene<dim>::declare_parameters(ParameterHandler &prm)
{
  CoarseMesh<dim>::declare_parameters(prm);
  GasMaterial::declare_parameters(prm);
  Scheme::declare_parameters(prm);
  InitialState<dim>::declare_parameters(prm);
  ChargeSet<dim>::declare_parameters(prm);
  ReferenceSolution<dim>::declare_parameters(prm);
  Boundary<dim>::declare_parameters(prm);
  RigidBody::declare_parameters(prm);
}


template <int dim>
void GasScene<dim>::parse_parameters(ParameterHandler &prm)
{
  coarse_mesh.parse_parameters(prm);
  material.parse_parameters(prm);
  scheme.parse_parameters(prm, dim);
  scheme.check_mesh(coarse_mesh.is_axis_aligned());
  initial_state.parse_parameters(prm, material);
  charges.parse_parameters(prm, material, coarse_mesh);
  charges.check(scheme, initial_state);
  reference.parse_parameters(prm, material);
  if (reference.has_arrivals() && !reference.exists() &&
      has_several_explosions(read_bursts(prm, material, coarse_mesh)))
    reference = {};
  boundary.parse_parameters(
    prm, material, coarse_mesh, initial_state, reference);
  body.parse_parameters(prm);
  if (!body.empty())
    check_body();
  check_places(prm, material, coarse_mesh, body);
  if (!body.empty() && body.is_required())
    for (const std::string &line : remarks_on_cuts(prm, coarse_mesh, body))
      log_line(line);
  layout = LeafLayout(dim,
                      scheme.n_points,
                      dim + 2 + (material.is_ideal() ? 0 : 1),
                      scheme.precision);
  points = LeafPoints<dim>(scheme, coarse_mesh.geometry());
  {
    const Section section(prm, "Material");
    material_words = prm.get("Equation of state");
    if (material.has_products())
      material_words += ", " + prm.get("Explosive");
  }
  {
    const Section section(prm, "Time");
    end_time = read_double(prm, "End time");
    if (end_time <= initial_state.time())
      throw InputError("Time/End time = " + brief(end_time) +
                       " s: the run begins with the profile of " +
                       brief(initial_state.time()) +
                       " s in Initial state/Profile/File");
  }
  if (!body.is_required())
    return;
  std::vector<std::string> remarks = charges.late_burns(end_time);
  for (const std::string &line : remarks_on_bursts(prm, material, coarse_mesh))
    remarks.push_back(line);
  for (const std::string &line : remarks)
    log_line(line);
}


template <int dim>
void GasScene<dim>::check_body() const
{
  body.check(dim);
  if (dim == 1 || !coarse_mesh.is_axis_aligned())
    throw InputError("Rigid body/Kind: bodies need Domain/Mesh = box and "
                     "Domain/Dimension = 2 or 3");
  if (scheme.kind != Scheme::Kind::finite_volume)
    throw InputError(
      "Rigid body/Kind: bodies need Method/Scheme = finite volume");
}


template <int dim>
void GasScene<dim>::check_subcells() const
{
  const unsigned int least = 4;
  if (body.empty())
    return;
  if (scheme.n_points % 2 == 1 && body.most_levels() > 0)
    throw InputError("Rigid body/Levels above 0 need an even number of "
                     "Method/Subcells, not " +
                     std::to_string(scheme.n_points));
  if (scheme.n_points < least)
    throw InputError(
      "Rigid body/Kind: bodies need Method/Subcells of 4 or more, "
      "not " +
      std::to_string(scheme.n_points));
}


template <int dim>
void GasScene<dim>::require_inside(const dealii::Point<dim> &place,
                                   const std::string &what) const
{
  const auto &lower = coarse_mesh.lower_corner();
  const auto &upper = coarse_mesh.upper_corner();
  const auto is_inside = [&](const dealii::Point<dim> &point) {
    for (unsigned int d = 0; d < dim; ++d)
      if (point[d] < lower[d] || point[d] > upper[d])
        return false;
    return true;
  };
  if (!coarse_mesh.is_axis_aligned() || is_inside(place))
    return;
  std::string message = what + ' ' + coordinates(place) +
                        " m is outside of the domain, " + coordinates(lower) +
                        " m to " + coordinates(upper) + " m";
  for (unsigned int d = 0; d < dim; ++d)
  {
    dealii::Point<dim> image = place;
    image[d] = 2. * (place[d] < lower[d] ? lower[d] : upper[d]) - place[d];
    if (is_inside(image) &&
        boundary.kind(2 * d + (place[d] < lower[d] ? 0 : 1)) ==
          Boundary<dim>::Kind::wall)
      message += "; if that wall is a plane of symmetry, " +
                 coordinates(image) + " m has the same values";
  }
  throw InputError(message);
}


template <int dim>
dealii::Point<dim> GasScene<dim>::place(const LeafBox<dim> &leaf,
                                        const unsigned int q) const
{
  const auto index = points.indices(q);
  dealii::Point<dim> x;
  for (unsigned int d = 0; d < dim; ++d)
    x[d] = points.position(index[d]);
  return leaf.place(x);
}


template struct GasScene<1>;
template struct GasScene<2>;
template struct GasScene<3>;
} // namespace contrecoup::gas
