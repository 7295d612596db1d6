// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/transfer_scheme.h>

namespace contrecoup::mpm
{
/// All combinations that are allowed. @param flip_terms,fmpm_terms of the mass
/// series
inline std::vector<TransferScheme> all_schemes(const unsigned int flip_terms,
                                               const unsigned int fmpm_terms)
{
  std::vector<TransferScheme> result;
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const auto transfer :
         {Transfer::pic, Transfer::flip, Transfer::affine, Transfer::fmpm})
      for (const auto update : {StressUpdate::first,
                                StressUpdate::last,
                                StressUpdate::modified_last})
        if (degree > 1 || transfer != Transfer::affine)
          result.push_back({degree,
                            transfer,
                            update,
                            transfer == Transfer::flip   ? flip_terms
                            : transfer == Transfer::fmpm ? fmpm_terms
                                                         : 1});
  return result;
}

inline std::string scheme_name(const TransferScheme &scheme)
{
  return std::string(bases[scheme.degree - 1].name) + " " +
         transfers[static_cast<int>(scheme.transfer)].name + " " +
         stress_updates[static_cast<int>(scheme.update)].name;
}
} // namespace contrecoup::mpm
