// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/solid/body/element_options.h>

#include <cmath>

namespace contrecoup::solid
{
namespace
{
  /// Names of the values of Integration, in the same order.
  const std::vector<std::string> integration_names{"one-point", "full"};

  void declare_hourglass(ParameterHandler &prm)
  {
    const UsedWith used("Elements/Integration = one-point");
    declare_selection(prm,
                      "Hourglass control",
                      "stiffness",
                      names_of(hourglass_controls),
                      "Resistance to the hourglass modes of one-point "
                      "integration: " +
                        help_of(hourglass_controls) + ".");
    declare_double(
      prm,
      "Hourglass coefficient",
      "1",
      0.,
      10.,
      "-",
      used_with("Elements/Hourglass control not none",
                "Factor on the hourglass stiffness from the shear modulus; "
                "1 gives bricks their correct bending stiffness, less is "
                "softer."));
    declare_double(prm,
                   "Hourglass damping",
                   "0",
                   0.,
                   0.2,
                   "-",
                   "Fraction of rho c h^2 that damps hourglass modes where "
                   "the bulk modulus exceeds 100 times the shear modulus, as "
                   "in the brain. It removes motion with pressures that "
                   "alternate from element to element, and damps shear waves "
                   "of few elements.");
  }

  void declare_smoothing(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Pressure smoothing",
                   "0.95",
                   0.,
                   1.,
                   "-",
                   "Part of an element's pressure that is replaced by the "
                   "average over its corners, where the bulk modulus exceeds "
                   "100 times the shear modulus, so that pressures do not "
                   "alternate from element to element; not in matter with gas "
                   "or cavities; 0: none.");
  }

  void declare_viscosity(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Linear bulk viscosity",
                   "0.06",
                   0.,
                   2.,
                   "-",
                   "Fraction of the critical damping of compression in an "
                   "element; reduces the stable step by the same fraction. "
                   "It also resists the collapse of cavities; tissues that "
                   "cavitate have at least 0.02.");
    declare_double(prm,
                   "Quadratic bulk viscosity",
                   "1.2",
                   0.,
                   10.,
                   "-",
                   "Spreads shocks over a few elements; no effect on waves "
                   "of small strain.");
  }
} // namespace


void ElementOptions::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Elements");
  declare_selection(prm,
                    "Kinematics",
                    "finite rotation",
                    names_of(solid_kinematics),
                    "Strain measure: " + help_of(solid_kinematics) + ".");
  declare_selection(prm,
                    "Integration",
                    "one-point",
                    integration_names,
                    "full: 2 x 2 x 2 Gauss points for shear, one dilatation "
                    "and no hourglass modes; takes 2.5 times as long and is "
                    "too stiff in bending.");
  declare_hourglass(prm);
  declare_smoothing(prm);
  declare_bool(prm,
               "Skip quiet",
               "true",
               "Whether elements are skipped until one of their nodes, or "
               "of the nodes in the same block of 64, has moved; results "
               "are the same.");
  declare_integer(prm,
                  "Largest number of retries",
                  "10",
                  0,
                  50,
                  "How often a step may be halved when an element inverts "
                  "or a value is not finite, before the run fails.");
  declare_viscosity(prm);
}


void ElementOptions::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Elements");
  kinematics = find_choice(
    solid_kinematics, prm.get("Kinematics"), "kinematics of solids");
  integration = prm.get("Integration") == integration_names[1]
                  ? Integration::full
                  : Integration::one_point;
  hourglass = find_choice(
    hourglass_controls, prm.get("Hourglass control"), "hourglass control");
  hourglass_coefficient = read_double(prm, "Hourglass coefficient");
  hourglass_damping = read_double(prm, "Hourglass damping");
  pressure_smoothing = read_double(prm, "Pressure smoothing");
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
