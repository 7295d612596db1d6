// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup::study
{
/// Observed order of convergence p, error ~ (mesh width)^p, between a coarse
/// and a fine mesh; NaN unless errors and widths are positive and the widths
/// differ.
double observed_order(double coarse_error,
                      double fine_error,
                      double coarse_width,
                      double fine_width);

/// Extrapolated limit of a quantity under mesh refinement.
struct Extrapolation
{
  double limit = 0.;
  double order = 0.; ///< of convergence to the limit; NaN if unknown

  /// Whether convergence is monotone, so that the formula applies. Otherwise
  /// the limit is the value on the finest mesh.
  bool is_asymptotic = false;
};

/**
 * Richardson extrapolation from the three finest meshes, with the model limit
 * + constant * (mesh width)^order (L. F. Richardson, Phil. Trans. R. Soc. A
 * 210 (1911) 307-357; for unequal ratios of widths as in I. Celik et al., J.
 * Fluids Eng. 130 (2008) 078001).
 * @param widths decreasing
 * @param values the quantity on each mesh
 * @throws InputError for fewer than three meshes
 */
Extrapolation extrapolate(const std::vector<double> &widths,
                          const std::vector<double> &values);
} // namespace contrecoup::study
