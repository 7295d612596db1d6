// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/principal_axes.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

namespace contrecoup
{
std::array<std::pair<double, dealii::Tensor<1, 3>>, 3>
principal_axes(const dealii::SymmetricTensor<2, 3> &tensor)
{
  dealii::LAPACKFullMatrix<double> matrix(3);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      matrix(i, j) = tensor[i][j];
  // The Frobenius norm bounds all eigenvalues; a tensor of zeros has some, too.
  const double bound = 2. * tensor.norm() + 1.;
  dealii::Vector<double> values;
  dealii::FullMatrix<double> vectors;
  matrix.compute_eigenvalues_symmetric(-bound, bound, 0., values, vectors);
  std::array<std::pair<double, dealii::Tensor<1, 3>>, 3> axes;
  for (unsigned int k = 0; k < 3; ++k)
  {
    auto &[value, axis] = axes[2 - k];
    value = values[k];
    for (unsigned int d = 0; d < 3; ++d)
      axis[d] = vectors(d, k);
  }
  return axes;
}
} // namespace contrecoup
