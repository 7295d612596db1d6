// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup::mpm
{
/// When a number changes its sign, on straight lines between its values.
class SignChanges
{
public:
  explicit SignChanges(const double start)
    : last_(start)
  {}

  void add(const double time, const double value)
  {
    if (value * last_ < 0.)
      times.push_back(before_ + (time - before_) * last_ / (last_ - value));
    last_ = value;
    before_ = time;
  }

  std::vector<double> times;

private:
  double last_, before_ = 0.;
};
} // namespace contrecoup::mpm
