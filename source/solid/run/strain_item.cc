// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/run/strain_item.h>

#include <cmath>
#include <limits>

namespace contrecoup::solid
{
namespace
{
  constexpr double largest_strain = 0.1; // limit of small-strain theory
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::string strain_of(const std::string &tissue)
  {
    return "strain that 95 % of " + tissue + " does not exceed";
  }

  std::string decision(const SolidKinematics kinematics)
  {
    switch (kinematics)
    {
      case SolidKinematics::small_strain:
        return "small rotations and strains";
      case SolidKinematics::finite_rotation:
        return "any rotation, small strains";
      default:
        return "any rotation and strain";
    }
  }
} // namespace


Assumption strain_item(const SolidKinematics kinematics)
{
  return {"strain",
          decision(kinematics),
          strain_of("a tissue"),
          "-",
          unknown,
          kinematics == SolidKinematics::neo_hookean ? unknown : largest_strain,
          false,
          "Elements/Kinematics"};
}


Assumption strain_item(const SolidKinematics kinematics,
                       const StrainedTissue &tissue)
{
  Assumption item = strain_item(kinematics);
  item.value = tissue.strain;
  item.quantity =
    tissue.name.empty()
      ? item.quantity + ", measured by Peaks/Active = true alone"
      : strain_of("the most strained tissue, " + tissue.name + ",") +
          (tissue.grows ? " and that still grows at the end" : "");
  // A strain that grows may exceed its limit later.
  if (tissue.grows && !item.fails() && !std::isnan(item.limit))
  {
    item.quantity +=
      ", so that its limit of " + brief(item.limit) + " is not judged";
    item.limit = unknown;
  }
  return item;
}
} // namespace contrecoup::solid
