// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/stress_invariants.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace contrecoup::solid
{
double largest_principal(const Symmetric3<double> &m)
{
  dealii::SymmetricTensor<2, 3> tensor;
  for (unsigned int d = 0; d < 3; ++d)
    tensor[d][d] = m[d];
  tensor[0][1] = m[3];
  tensor[1][2] = m[4];
  tensor[2][0] = m[5];
  return dealii::eigenvalues(tensor)[0];
}


double pressure_of(const Symmetric3<double> &s)
{
  return -(s[0] + s[1] + s[2]) / 3.;
}


double von_mises(const Symmetric3<double> &s)
{
  Symmetric3<double> deviator = s;
  for (unsigned int d = 0; d < 3; ++d)
    deviator[d] += pressure_of(s);
  return std::sqrt(1.5 * contract(deviator, deviator));
}
} // namespace contrecoup::solid
