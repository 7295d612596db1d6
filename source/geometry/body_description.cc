// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters.h>
#include <contrecoup/geometry/body_description.h>

namespace contrecoup
{
void BodyDescription::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_selection(prm,
                    "Kind",
                    "phantom",
                    {"phantom", "shape"},
                    "Where the body comes from: the human phantom, or a "
                    "simple shape.");
  Placement::declare_parameters(prm);
  {
    const Section section(prm, "Phantom");
    Phantom::declare_parameters(prm);
  }
  const Section section(prm, "Shape");
  SimpleBody::declare_parameters(prm);
}

void BodyDescription::parse_parameters(dealii::ParameterHandler &prm)
{
  kind_ = prm.get("Kind");
  placement_.parse_parameters(prm);
  if (kind_ == "phantom")
  {
    const Section section(prm, "Phantom");
    phantom_.parse_parameters(prm);
  }
  else
  {
    const Section section(prm, "Shape");
    simple_.parse_parameters(prm);
  }
}

BodyPointer BodyDescription::create() const
{
  const BodyPointer body =
    kind_ == "phantom" ? phantom_.create() : simple_.create();
  return placement_.is_identity() ? body : body->placed(placement_);
}

std::vector<OrganReference> BodyDescription::references() const
{
  if (kind_ == "phantom" && placement_.scale() == 1.)
    return phantom_.references();
  return {};
}
} // namespace contrecoup
