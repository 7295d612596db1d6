// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/ale/mesh/boundary_areas.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/system/exceptions.h>

#include <algorithm>

namespace contrecoup::ale
{
void ContactPlanes::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Plane *");
  declare_list(prm,
               "Point",
               "0, 0, 0",
               3,
               3,
               -1e6,
               1e6,
               "m",
               selecting("A point on the rigid plane."));
  declare_list(
    prm,
    "Normal",
    "0, 0, 1",
    3,
    3,
    -1e6,
    1e6,
    "-",
    selecting("Normal of the plane towards the matter, of any length."));
  declare_double(
    prm,
    "Friction",
    "0",
    0.,
    10.,
    "-",
    "Coulomb friction coefficient between the plane and free surfaces.");
}


void ContactPlanes::parse_parameters(ParameterHandler &prm)
{
  for (const std::string &name : item_names(prm, "Plane"))
  {
    const Section section(prm, "Plane " + name);
    ContactPlane plane;
    plane.name = name;
    plane.point = read_point<3>(prm, "Point");
    plane.normal = read_point<3>(prm, "Normal");
    if (!(plane.normal.norm() > 0.))
      throw InputError("Plane " + name + "/Normal must not be 0, 0, 0");
    plane.normal /= plane.normal.norm();
    plane.friction = read_double(prm, "Friction");
    planes_.push_back(plane);
  }
}


void ContactPlanes::reinit(
  const HexSpace &space,
  const dealii::AlignedVector<double> &position,
  const std::function<bool(dealii::types::boundary_id)> &is_free)
{
  space_ = &space;
  surface_.clear();
  corrections_.clear();
  if (planes_.empty())
    return;
  const auto areas = boundary_areas(space, position, is_free);
  for (std::uint32_t node = 0; node < areas.size(); ++node)
    if (areas[node].norm() > 0.)
      surface_.push_back({node, areas[node].norm()});
}


void ContactPlanes::apply(dealii::AlignedVector<double> &velocity,
                          const dealii::AlignedVector<double> &position)
{
  corrections_.clear();
  for (const ContactPlane &plane : planes_)
    for (const SurfaceNode &at : surface_)
    {
      const auto way = vector_at(position, at.node) -
                       static_cast<const dealii::Tensor<1, 3> &>(plane.point);
      const auto v = vector_at(velocity, at.node);
      const double inwards = -(v * plane.normal);
      if (way * plane.normal > 0. || inwards <= 0.)
        continue;
      const auto along = v + inwards * plane.normal;
      const double speed = along.norm();
      dealii::Tensor<1, 3> slowed;
      if (speed > 0.)
        slowed = -std::min(1., plane.friction * inwards / speed) * along;
      const auto change = inwards * plane.normal + slowed;
      for (unsigned int d = 0; d < 3; ++d)
        velocity[node_width * at.node + d] += change[d];
      corrections_.push_back({at, inwards, plane.normal, slowed});
    }
}


ContactMeasures
ContactPlanes::measures(const dealii::AlignedVector<double> &mean,
                        const dealii::AlignedVector<double> &velocity,
                        const double step) const
{
  ContactMeasures result;
  for (const VelocityCorrection &correction : corrections_)
  {
    const std::uint32_t node = correction.at.node;
    if (node >= space_->n_locally_owned_nodes())
      continue;
    const double mass = 1. / velocity[node_width * node + 3];
    const auto v = vector_at(mean, node);
    result.force += mass * correction.normal / step;
    result.area += correction.at.area;
    result.work += mass * correction.normal * (v * correction.direction);
    result.friction_work += mass * (v * correction.tangential);
    const auto along = v - (v * correction.direction) * correction.direction;
    result.sliding_work += mass * correction.normal * along.norm();
  }
  return result;
}
} // namespace contrecoup::ale
