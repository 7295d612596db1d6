// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/scheme/riemann_flux.h>

#include "face_states.h"
#include <gtest/gtest.h>

#include <array>

using namespace contrecoup;

// Both may fuse multiplications and additions differently; where the pressure
// between strong waves is a small difference, the wave speeds amplify the
// rounding by up to 1e4 (two steps, each bounded from below by 1/100).
TEST(RiemannFlux, LanesAgreeWithPlainNumbers)
{
  using Number = Lanes<double>;
  RandomStates random;
  for (unsigned int i = 0; i < 1000; ++i)
  {
    std::array<FaceState<2, double>, Number::size()> left, right;
    FaceState<2, Number> left_lanes, right_lanes;
    for (unsigned int lane = 0; lane < Number::size(); ++lane)
    {
      left[lane] = random.state<2>(mixture());
      right[lane] = random.state<2>(mixture());
      if (lane % 3 == 0) // without a strong jump
        right[lane] = left[lane];
    }
    const auto fill = [](const auto &plain, auto &lanes) {
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
      {
        lanes.density[lane] = plain[lane].density;
        lanes.pressure[lane] = plain[lane].pressure;
        lanes.energy_density[lane] = plain[lane].energy_density;
        lanes.sound_speed[lane] = plain[lane].sound_speed;
        lanes.products[lane] = plain[lane].products;
        for (unsigned int d = 0; d < 2; ++d)
          lanes.velocity[d][lane] = plain[lane].velocity[d];
      }
    };
    fill(left, left_lanes);
    fill(right, right_lanes);
    for (const RiemannFlux kind : all_fluxes)
    {
      const auto flux =
        components(numerical_flux(kind, left_lanes, right_lanes, Number(0.9)));
      for (unsigned int lane = 0; lane < Number::size(); ++lane)
      {
        const auto plain =
          components(numerical_flux(kind, left[lane], right[lane], 0.9));
        const auto scale = scales(left[lane], right[lane]);
        for (unsigned int c = 0; c < plain.size(); ++c)
          ASSERT_NEAR(flux[c][lane], plain[c], 1e-11 * scale[c]);
      }
    }
  }
}


TEST(RiemannFlux, WorksInSinglePrecision)
{
  RandomStates random;
  for (unsigned int i = 0; i < 2000; ++i)
  {
    const auto left = random.state<3>(air()), right = random.state<3>(air());
    const auto narrow = [](const FaceState<3, double> &state, auto number) {
      using Number = decltype(number);
      FaceState<3, Number> result;
      result.density = Number(float(state.density));
      for (unsigned int d = 0; d < 3; ++d)
        result.velocity[d] = Number(float(state.velocity[d]));
      result.pressure = Number(float(state.pressure));
      result.energy_density = Number(float(state.energy_density));
      result.sound_speed = Number(float(state.sound_speed));
      result.products = Number(float(state.products));
      return result;
    };
    const auto scale = scales(left, right);
    for (const RiemannFlux kind : {RiemannFlux::hll, RiemannFlux::hllc})
    {
      const auto exact = components(numerical_flux(kind, left, right, 1.));
      const auto plain = components(
        numerical_flux(kind, narrow(left, 1.f), narrow(right, 1.f), 1.f));
      const auto lanes =
        components(numerical_flux(kind,
                                  narrow(left, Lanes<float>(1.f)),
                                  narrow(right, Lanes<float>(1.f)),
                                  Lanes<float>(1.f)));
      // The rounding of 6e-8, amplified in the wave speeds as above.
      for (unsigned int c = 0; c < exact.size(); ++c)
      {
        ASSERT_NEAR(plain[c], exact[c], 1e-3 * scale[c]);
        ASSERT_NEAR(lanes[c][1], exact[c], 1e-3 * scale[c]);
      }
    }
  }
}
