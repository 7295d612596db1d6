// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <stdexcept>
#include <string>

namespace contrecoup
{
/// Invalid user input; exit code 1. The message is one line: what is wrong,
/// where, and which values are allowed.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Numerical failure despite step size reduction; exit code 2. The message
/// names time, place and state.
class NumericsError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// System failure, such as disk or memory; exit code 3.
class SystemError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace contrecoup
