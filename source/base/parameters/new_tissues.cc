// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/new_tissues.h>
#include <contrecoup/base/system/exceptions.h>

#include <algorithm>

namespace contrecoup
{
namespace
{
  /// Numbers of tissues are bytes; "none" is one of them.
  constexpr std::size_t most_tissues = 256;

  /// All names by number; new ones follow those of the library.
  std::vector<std::string> &all_names()
  {
    static std::vector<std::string> names = []() {
      std::vector<std::string> list{"none",
                                    "soft tissue",
                                    "skin",
                                    "skeleton",
                                    "brain",
                                    "spinal cord",
                                    "cerebrospinal fluid",
                                    "lung",
                                    "heart",
                                    "liver",
                                    "water",
                                    "gelatin",
                                    "polycarbonate"};
      list.reserve(most_tissues); // references stay valid
      return list;
    }();
    return names;
  }

  constexpr auto last_of_library = Tissue::polycarbonate;
} // namespace


const std::vector<std::string> &tissue_names()
{
  return all_names();
}


bool is_new(const Tissue tissue)
{
  return tissue > last_of_library;
}


Tissue add_tissue(const std::string &name)
{
  std::vector<std::string> &names = all_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    if (name.empty() || name.find_first_of(",;:=/|\"") != std::string::npos)
      throw InputError(
        "\"" + name +
        "\" cannot name a tissue: a name has none of , ; : = / | "
        "and no quotation mark");
    if (names.size() == most_tissues)
      throw InputError("\"" + name + "\": there can be " +
                       std::to_string(most_tissues - 1) + " tissues at most");
    names.push_back(name);
    return static_cast<Tissue>(names.size() - 1);
  }
  return static_cast<Tissue>(found - names.begin());
}
} // namespace contrecoup
