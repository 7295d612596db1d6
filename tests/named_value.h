// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// The value of the item with this name; a failure of the test without one.
template <typename Item>
double value_of(const std::vector<Item> &items, const std::string &name)
{
  for (const Item &item : items)
    if (item.name == name)
      return item.value;
  ADD_FAILURE() << "no item " << name;
  return 0.;
}
} // namespace contrecoup
