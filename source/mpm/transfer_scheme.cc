// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/names.h>
#include <contrecoup/mpm/transfer_scheme.h>

namespace contrecoup::mpm
{
const std::vector<std::string> &basis_names()
{
  static const std::vector<std::string> names{"linear", "quadratic", "cubic"};
  return names;
}


unsigned int find_basis(const std::string &name)
{
  return position_of(name, basis_names(), "basis") + 1;
}


const std::vector<std::string> &transfer_names()
{
  static const std::vector<std::string> names{"pic", "flip", "apic", "fmpm"};
  return names;
}


const std::vector<std::string> &stress_update_names()
{
  static const std::vector<std::string> names{"usf", "usl", "musl"};
  return names;
}


Transfer find_transfer(const std::string &name)
{
  return static_cast<Transfer>(position_of(name, transfer_names(), "transfer"));
}


StressUpdate find_stress_update(const std::string &name)
{
  return static_cast<StressUpdate>(
    position_of(name, stress_update_names(), "update of stresses"));
}
} // namespace contrecoup::mpm
