// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters.h>
#include <contrecoup/solid/body/element_options.h>

#include <cmath>

namespace contrecoup::solid
{
namespace
{
  /// In the order of Integration.
  const std::vector<std::string> integration_names{"one-point", "full"};

  /// Of bulk.
  void declare_viscosity(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Linear bulk viscosity",
                   "0.06",
                   0.,
                   2.,
                   "-",
                   "Part of the critical damping of compression in an element; "
                   "takes that part off the stable step.");
    declare_double(prm,
                   "Quadratic bulk viscosity",
                   "1.2",
                   0.,
                   10.,
                   "-",
                   "Spreads shocks over some elements; nothing for waves of "
                   "small strain.");
  }
} // namespace


void ElementOptions::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Elements");
  declare_selection(prm,
                    "Kinematics",
                    "small strain",
                    solid_kinematics_names(),
                    "small strain has no rotations; finite rotation is exact "
                    "for turns of any size with small strains; neo-hookean "
                    "also for large strains.");
  declare_selection(prm,
                    "Integration",
                    "one-point",
                    integration_names,
                    "full has 2 x 2 x 2 Gauss points for shear, one dilatation "
                    "and no hourglass modes; it takes 2.5 times as long and is "
                    "too stiff in bending.");
  declare_selection(prm,
                    "Hourglass control",
                    "stiffness",
                    hourglass_names(),
                    "What resists the modes that one integration point does "
                    "not see; none leaves them to grow.");
  declare_double(prm,
                 "Hourglass coefficient",
                 "1",
                 0.,
                 10.,
                 "-",
                 "Times the resistance that comes from the shear modulus; "
                 "1 makes bricks bend as they should, less is softer.");
  declare_double(prm,
                 "Hourglass damping",
                 "0",
                 0.,
                 0.2,
                 "-",
                 "Part of rho c h^2 that damps hourglass modes where the bulk "
                 "modulus is above 100 times the shear modulus, as in the "
                 "brain: takes the motion away whose pressures alternate from "
                 "element to element, and some of shear waves of few "
                 "elements.");
  declare_bool(prm,
               "Skip quiet",
               "true",
               "Whether elements are passed over until one of their nodes, or "
               "of those numbered beside it, has moved; the results are the "
               "same.");
  declare_integer(prm,
                  "Largest number of retries",
                  "10",
                  0,
                  50,
                  "Times that a step after which an element has no volume, or "
                  "numbers are not finite, is halved before the run gives up.");
  declare_viscosity(prm);
}


void ElementOptions::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Elements");
  kinematics = find_solid_kinematics(prm.get("Kinematics"));
  integration = prm.get("Integration") == integration_names[1]
                  ? Integration::full
                  : Integration::one_point;
  hourglass = find_hourglass(prm.get("Hourglass control"));
  hourglass_coefficient = read_double(prm, "Hourglass coefficient");
  hourglass_damping = read_double(prm, "Hourglass damping");
  skip_quiet = prm.get_bool("Skip quiet");
  largest_retries = read_unsigned(prm, "Largest number of retries");
  linear_viscosity = read_double(prm, "Linear bulk viscosity");
  quadratic_viscosity = read_double(prm, "Quadratic bulk viscosity");
}


double ElementOptions::step_factor() const
{
  return std::sqrt(1. + linear_viscosity * linear_viscosity) - linear_viscosity;
}
} // namespace contrecoup::solid
