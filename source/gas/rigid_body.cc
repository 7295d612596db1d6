// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/rigid_body.h>
#include <contrecoup/geometry/body_description.h>
#include <contrecoup/geometry/composed_shapes.h>
#include <contrecoup/geometry/half_space.h>

namespace contrecoup::gas
{
namespace
{
  void declare_half_space(ParameterHandler &prm)
  {
    const Section section(prm, "Half space");
    Placement::declare_parameters(prm);
  }


  ShapePointer read_half_space(ParameterHandler &prm)
  {
    const Section section(prm, "Half space");
    Placement placement;
    placement.parse_parameters(prm);
    return std::make_shared<PlacedShape>(std::make_shared<HalfSpace>(),
                                         placement);
  }


  BodyPointer read_body(ParameterHandler &prm)
  {
    const Section section(prm, "Body");
    BodyDescription description;
    description.parse_parameters(prm);
    return description.create();
  }
} // namespace


void RigidBody::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Body");
    BodyDescription::declare_parameters(prm);
  }
  const Section section(prm, "Rigid body");
  declare_selection(prm,
                    "Kind",
                    "none",
                    {"none", "body", "half space"},
                    "What stands rigidly in the gas: nothing, what section "
                    "Body describes, or everything with x > 0, turned and "
                    "moved; in 2-D what counts is the cut at z = 0.");
  declare_half_space(prm);
  declare_selection(prm,
                    "Treatment",
                    "embedded",
                    {"embedded", "staircase"},
                    "Embedded: cells are cut by the surface, with its true "
                    "normal, as plane facets in each cell; staircase: each "
                    "cell is gas or body by its centre.");
  declare_integer(prm,
                  "Levels",
                  "0",
                  0,
                  20,
                  "Times that leaves at the surface and those beside them "
                  "stay halved beyond the initial refinement; all of them "
                  "have this one size.");
}


void RigidBody::parse_parameters(ParameterHandler &prm)
{
  shape_.reset();
  std::string kind;
  {
    const Section section(prm, "Rigid body");
    kind = prm.get("Kind");
    treatment_ = prm.get("Treatment") == "embedded" ? Treatment::embedded
                                                    : Treatment::staircase;
    levels_ = read_unsigned(prm, "Levels");
    if (kind == "half space")
      shape_ = read_half_space(prm);
  }
  landmarks_.clear();
  if (kind == "body")
  {
    const BodyPointer body = read_body(prm);
    shape_ = body->surface();
    landmarks_ = body->landmarks();
  }
}
} // namespace contrecoup::gas
