// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/factor.h>

namespace contrecoup::study
{
/// Parameters of a design: which combinations of factor values are run.
struct DesignParameters
{
  std::string kind = "full grid";
  unsigned int samples = 16; ///< of a Latin hypercube
  unsigned int seed = 1;     ///< of the random numbers
};

/// One combination of values.
struct Variant
{
  Settings settings;
  std::vector<std::string> labels; ///< by factor
  std::vector<double> numbers;     ///< Factor::number(), by factor
};

/**
 * Variants of a design:
 *   full grid: all combinations, the last factor fastest;
 *   one at a time: the first value of every factor, and all variants that
 *     differ from it in one factor;
 *   latin hypercube: random samples whose coordinates in each factor fall into
 *     different ones of as many equal parts of its values or range
 *     (M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21 (1979)
 *     239-245). The same seed gives the same samples on every machine.
 * @throws InputError for a range in a design other than a Latin hypercube, and
 * for more than 100000 variants
 */
std::vector<Variant> make_design(const std::vector<Factor> &factors,
                                 const DesignParameters &parameters);
} // namespace contrecoup::study
