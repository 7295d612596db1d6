// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup::study
{
/// The order p at which the error falls like (mesh width)^p between a coarse
/// and a fine mesh; not a number unless errors and widths are above zero and
/// the widths differ.
double observed_order(double coarse_error,
                      double fine_error,
                      double coarse_width,
                      double fine_width);

/// What a quantity tends to as the mesh is refined.
struct Extrapolation
{
  double limit = 0.;
  double order = 0.; ///< of the convergence to it; NaN if not known

  /// Whether the quantity came closer monotonously, so that the formula
  /// holds. If not, the limit is the value on the finest mesh.
  bool is_asymptotic = false;
};

/**
 * Richardson's extrapolation from the three finest meshes: the quantity is
 * taken as limit + constant * (mesh width)^order (L. F. Richardson, Phil.
 * Trans. R. Soc. A 210 (1911) 307-357; for unequal ratios of the widths as in
 * I. Celik et al., J. Fluids Eng. 130 (2008) 078001).
 * @param widths falling
 * @param values the quantity on each mesh
 * @throws InputError for fewer than three meshes
 */
Extrapolation extrapolate(const std::vector<double> &widths,
                          const std::vector<double> &values);
} // namespace contrecoup::study
