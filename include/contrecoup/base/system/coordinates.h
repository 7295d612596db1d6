// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/text.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <string>
#include <vector>

namespace contrecoup
{
/// A place or vector for readers, "0.1, 0, 1.7", with @p digits significant
/// digits; components below 1e-9 of the length are round-off, and 0.
template <int dim>
std::string coordinates(const dealii::Tensor<1, dim> &place,
                        const int digits = 4)
{
  std::vector<std::string> words;
  for (unsigned int d = 0; d < dim; ++d)
    words.push_back(
      std::abs(place[d]) < 1e-9 * place.norm() ? "0" : brief(place[d], digits));
  return join(words, ", ");
}
} // namespace contrecoup
