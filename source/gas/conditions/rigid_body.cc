// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/half_space.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
namespace
{
  void declare_half_space(ParameterHandler &prm)
  {
    const Section section(prm, "Half space");
    const UsedWith used("Rigid body/Kind = half space");
    Placement::declare_parameters(prm);
  }


  void declare_levels(ParameterHandler &prm)
  {
    declare_integer(prm,
                    "Levels",
                    "0",
                    0,
                    20,
                    "Refinement level of leaves at the surface and of their "
                    "neighbours, above the initial refinement; adaptation "
                    "does not change it.");
    const Section section(prm, "Finer region *");
    declare_integer(prm,
                    "Levels",
                    "0",
                    0,
                    20,
                    "Levels within this region, if larger than elsewhere.");
    Region::declare_parameters(
      prm,
      selecting(
        "Shape of the region: the whole domain, within Radius of a Center, "
        "farther from all Centers, or between two corners. Leaves that "
        "intersect the region belong to it."));
  }


  ShapePointer read_half_space(ParameterHandler &prm)
  {
    const Section section(prm, "Half space");
    Placement placement;
    placement.parse_parameters(prm);
    return std::make_shared<PlacedShape>(std::make_shared<HalfSpace>(),
                                         placement);
  }


  BodyPointer read_body(ParameterHandler &prm, double &phantom_mass)
  {
    const Section section(prm, "Body");
    BodyDescription description;
    description.parse_parameters(prm);
    phantom_mass = description.phantom_mass();
    return description.create();
  }
} // namespace


void RigidBody::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Body");
    const UsedWith used("Rigid body/Kind = body");
    BodyDescription::declare_parameters(prm);
  }
  const Section section(prm, "Rigid body");
  declare_selection(prm,
                    "Kind",
                    "none",
                    {"none", "body", "half space"},
                    "Rigid body in the gas: none, the body of section Body, or "
                    "the half space x > 0, rotated and translated; in 2-D the "
                    "cross-section at z = 0, in axisymmetric geometry revolved "
                    "about the axis.");
  declare_half_space(prm);
  const UsedWith used("Rigid body/Kind not none");
  declare_selection(
    prm,
    "Treatment",
    "embedded",
    {"embedded", "staircase"},
    "Embedded: the surface cuts subcells, with its true normal, "
    "as plane facets in each subcell; staircase: each subcell "
    "is gas or body, by its centre.");
  declare_levels(prm);
  declare_bool(prm,
               "Required",
               "true",
               "Whether a run is refused if the body covers no subcell, "
               "because it lies elsewhere or is too thin; trial runs on "
               "coarser meshes for cost estimates continue without the body.");
}


void RigidBody::parse_parameters(ParameterHandler &prm)
{
  shape_.reset();
  finer_regions_.clear();
  known_values_.clear();
  std::string kind;
  {
    const Section section(prm, "Rigid body");
    kind = prm.get("Kind");
    treatment_ = prm.get("Treatment") == "embedded" ? Treatment::embedded
                                                    : Treatment::staircase;
    levels_ = read_unsigned(prm, "Levels");
    is_required_ = prm.get_bool("Required");
    for (const std::string &name : item_names(prm, "Rigid body/Finer region"))
    {
      const Section region(prm, "Finer region " + name);
      FinerRegion finer;
      finer.name = name;
      finer.region.parse_parameters(prm);
      finer.levels = read_unsigned(prm, "Levels");
      finer_regions_.push_back(finer);
    }
    if (kind == "half space")
      shape_ = read_half_space(prm);
  }
  landmarks_.clear();
  phantom_mass_ = std::numeric_limits<double>::quiet_NaN();
  if (kind == "body")
  {
    const BodyPointer body = read_body(prm, phantom_mass_);
    log_warnings(*body);
    shape_ = body->surface();
    landmarks_ = body->landmarks();
  }
}


void RigidBody::check(const unsigned int dim) const
{
  for (const FinerRegion &finer : finer_regions_)
    finer.region.check("Rigid body/Finer region " + finer.name, dim);
}


unsigned int RigidBody::most_levels() const
{
  unsigned int result = levels_;
  for (const FinerRegion &finer : finer_regions_)
    result = std::max(result, finer.levels);
  return result;
}


template <int dim>
double RigidBody::value_in_leaf(const dealii::Point<dim> &middle) const
{
  const std::size_t most = 1U << 22;
  if (known_values_.size() > most)
    known_values_.clear();
  Place place = {{0., 0., 0.}};
  for (unsigned int d = 0; d < dim; ++d)
    place[d] = middle[d];
  const auto [known, is_new] = known_values_.try_emplace(place, 0.);
  if (is_new)
    known->second = value(middle);
  return known->second;
}


template <int dim>
double RigidBody::leaf_diagonals_to(const dealii::Point<dim> &lower,
                                    const dealii::Point<dim> &upper,
                                    const int level_above_initial) const
{
  const dealii::Tensor<1, dim> edges = upper - lower;
  const double diagonal = edges.norm();
  const double wanted =
    std::ldexp(diagonal, level_above_initial - int(levels(lower, upper)));
  const double distance =
    value_in_leaf(dealii::Point<dim>(lower + edges * 0.5));
  // Inside there is no gas: only leaves at the surface are refined.
  const double none_beside = distance < 0. ? max_diagonals_at_body : 0.;
  return (std::abs(distance) - 0.5 * diagonal) / wanted + none_beside;
}


#define CONTRECOUP_INSTANTIATE(dim)                                           \
  template double RigidBody::value_in_leaf(const dealii::Point<dim> &) const; \
  template double RigidBody::leaf_diagonals_to(                               \
    const dealii::Point<dim> &, const dealii::Point<dim> &, const int) const

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
