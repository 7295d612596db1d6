#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Steady supersonic flow past a cone that points into it.

    taylor_maccoll.py MACH HALF_ANGLE

The exact pressure on cones, for the tests of bodies of revolution: behind the
conical shock the flow depends on the angle from the axis alone and obeys the
ordinary equation of G. I. Taylor and J. W. Maccoll (Proc. R. Soc. A 139 (1933)
278-311), here integrated by Runge and Kutta's method from the shock to where
nothing flows across the rays, which must be the cone. Ratio of heats 1.4.

Prints the angle of the shock [degrees], the Mach number on the cone and the
pressure on it over that of the flow ahead. For Mach 2 and 20 degrees J. L. Sims
(NASA SP-3004, 1964) has 37.8 degrees and 1.57.
"""

import math
import sys

HEATS = 1.4


def half_heats(along, across):
    """Half of (HEATS - 1) times what is left of the energy for heat; speeds are
    over the largest that the gas can reach."""
    return 0.5 * (HEATS - 1.) * (1. - along**2 - across**2)


def slopes(angle, along, across):
    """Of the speeds along and across rays, by the angle from the axis."""
    heat = half_heats(along, across)
    return across, (across**2 * along - heat * (
        2. * along + across / math.tan(angle))) / (heat - across**2)


def step(angle, along, across, width):
    """One step of Runge and Kutta's method of fourth order."""
    one = slopes(angle, along, across)
    two = slopes(angle + width / 2., along + width / 2. * one[0],
                 across + width / 2. * one[1])
    three = slopes(angle + width / 2., along + width / 2. * two[0],
                   across + width / 2. * two[1])
    four = slopes(angle + width, along + width * three[0],
                  across + width * three[1])
    return tuple(value + width / 6. * (a + 2. * b + 2. * c + d)
                 for value, a, b, c, d in
                 zip((along, across), one, two, three, four))


def behind_shock(mach, shock):
    """Speeds along and across the ray just behind an oblique shock, and the
    pressure there over that ahead."""
    normal = (mach * math.sin(shock))**2
    ahead = 1. / math.sqrt(1. + 2. / ((HEATS - 1.) * mach**2))
    ratio = (HEATS + 1.) * normal / ((HEATS - 1.) * normal + 2.)
    pressure = 1. + 2. * HEATS / (HEATS + 1.) * (normal - 1.)
    return (ahead * math.cos(shock), -ahead * math.sin(shock) / ratio,
            pressure)


def isentropic(along, across):
    """Pressure over that of the gas at rest."""
    return (1. - along**2 - across**2)**(HEATS / (HEATS - 1.))


def cone_behind(mach, shock, n_steps=4000):
    """Angle of the cone that makes this shock, the Mach number on it, and the
    pressure on it over that ahead."""
    along, across, pressure = behind_shock(mach, shock)
    rest = pressure / isentropic(along, across)
    angle, width = shock, -shock / n_steps
    while angle + 2. * width > 0.:
        last = angle, along, across
        along, across = step(angle, along, across, width)
        angle += width
        if across >= 0.:
            part = last[2] / (last[2] - across)
            along, across = step(*last, part * width)
            heat = half_heats(along, across)
            return (last[0] + part * width, along / math.sqrt(heat),
                    rest * isentropic(along, across))
    return 0., mach, 1.


def flow(mach, cone):
    """Angle of the shock before a cone, the weaker of two, the Mach number on
    the cone and the pressure there over that ahead; angles in radians."""
    low, high = math.asin(1. / mach) + 1e-9, math.radians(60.)
    for _ in range(50):
        shock = 0.5 * (low + high)
        if cone_behind(mach, shock)[0] < cone:
            low = shock
        else:
            high = shock
    return (low, *cone_behind(mach, low)[1:])


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 1
    mach, cone = map(float, arguments)
    shock, surface, pressure = flow(mach, math.radians(cone))
    print(f"shock {math.degrees(shock):.4f} degrees, on the cone Mach "
          f"{surface:.5f}, pressure {pressure:.6f}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
