// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace contrecoup::solid
{
namespace
{
  /// Tolerance of the bisection, relative to the largest magnitude.
  constexpr double tolerance = 1e-12;
} // namespace


const std::vector<std::string> &peak_pressure_names()
{
  static const std::vector<std::string> names{"averaged", "of elements"};
  return names;
}


std::string tissue_column(const std::string &quantity, const Tissue tissue)
{
  std::string name = quantity + "_" + name_of(tissue);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}


double percentile(const std::vector<double> &values,
                  const std::vector<double> &weights,
                  const double fraction,
                  const MPI_Comm communicator)
{
  using dealii::Utilities::MPI::sum;
  const double whole =
    sum(std::accumulate(weights.begin(), weights.end(), 0.), communicator);
  if (!(whole > 0.))
    return 0.;
  const auto reaches = [&](const double limit) {
    double weight = 0.;
    for (std::size_t i = 0; i < values.size(); ++i)
      weight += values[i] <= limit ? weights[i] : 0.;
    return sum(weight, communicator) >= fraction * whole * (1. - 1e-12);
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = -infinity;
  for (const double value : values)
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  low = dealii::Utilities::MPI::min(low, communicator);
  high = dealii::Utilities::MPI::max(high, communicator);
  if (reaches(low))
    return low;
  const double close = tolerance * std::max(std::abs(low), std::abs(high));
  while (high - low > close)
  {
    const double middle = 0.5 * (low + high);
    (reaches(middle) ? high : low) = middle;
  }
  // Bisection stops slightly above the wanted sample value.
  double value = -infinity;
  for (const double one : values)
    value = one <= high ? std::max(value, one) : value;
  return dealii::Utilities::MPI::max(value, communicator);
}


double raised_to_principal(const double value, const Symmetric3<double> &matrix)
{
  const double mean = (matrix[0] + matrix[1] + matrix[2]) / 3.;
  Symmetric3<double> deviator = matrix;
  for (unsigned int d = 0; d < 3; ++d)
    deviator[d] -= mean;
  // No principal value of a deviator exceeds sqrt(2 / 3) of its norm.
  const double room = value - mean;
  if (room > 0. &&
      1.5 * room * room > (1. + 1e-12) * contract(deviator, deviator))
    return value;
  return std::max(value, largest_principal(matrix));
}
} // namespace contrecoup::solid
