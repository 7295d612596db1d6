// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/mpm/transfer_scheme.h>

#include <algorithm>

namespace contrecoup::mpm
{
namespace
{
  /// @param what kind of the names, for the message
  unsigned int position(const std::vector<std::string> &names,
                        const std::string &name,
                        const std::string &what)
  {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError("\"" + name + "\" is no " + what +
                       suggestion(name, names));
    return found - names.begin();
  }
} // namespace


const std::vector<std::string> &basis_names()
{
  static const std::vector<std::string> names{"linear", "quadratic", "cubic"};
  return names;
}


unsigned int find_basis(const std::string &name)
{
  return position(basis_names(), name, "basis") + 1;
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
  return static_cast<Transfer>(position(transfer_names(), name, "transfer"));
}


StressUpdate find_stress_update(const std::string &name)
{
  return static_cast<StressUpdate>(
    position(stress_update_names(), name, "update of stresses"));
}
} // namespace contrecoup::mpm
