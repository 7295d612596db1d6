// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/state/open_fractions.h>

namespace contrecoup::gas
{
void OpenFractions::reinit(const unsigned int n_leaves,
                           const unsigned int n_points)
{
  n_points_ = n_points;
  place_.assign(n_leaves, open);
  fractions_.clear();
}


void OpenFractions::set(const unsigned int leaf,
                        const std::vector<double> &fractions)
{
  place_[leaf] = static_cast<int>(fractions_.size() / n_points_);
  fractions_.insert(fractions_.end(), fractions.begin(), fractions.end());
}
} // namespace contrecoup::gas
