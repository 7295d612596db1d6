// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/tensor.h>

namespace contrecoup::gas
{
/**
 * State of the gas at one point in primitive variables. In curvilinear
 * geometries velocity component 0 is radial.
 */
template <int dim>
struct GasState
{
  double density = 1.;             ///< mass per volume [kg/m^3]
  dealii::Tensor<1, dim> velocity; ///< velocity [m/s]
  double pressure = 1.;            ///< absolute pressure [Pa]
  double products = 0.;            ///< mass fraction of products [-]
};
} // namespace contrecoup::gas
