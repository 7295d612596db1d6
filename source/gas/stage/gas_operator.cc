// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/stage/gas_operator.h>

namespace contrecoup::gas
{
template <int dim, typename Real>
std::vector<unsigned int> GasOperator<dim, Real>::driven_leaves() const
{
  using Kind = typename Boundary<dim>::Kind;
  std::vector<unsigned int> result;
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
    for (auto s = mesh_.special_begin(batch); s != mesh_.special_end(batch);
         ++s)
      if (s->kind == SpecialFace::Kind::boundary &&
          boundary_.kind(s->index) != Kind::wall &&
          boundary_.kind(s->index) != Kind::open)
        result.push_back(batch * mesh_.width() + s->lane);
  return result;
}


template class GasOperator<1, double>;
template class GasOperator<2, double>;
template class GasOperator<3, double>;
template class GasOperator<3, float>;
} // namespace contrecoup::gas
