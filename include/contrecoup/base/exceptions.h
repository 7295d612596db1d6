// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <stdexcept>
#include <string>

namespace contrecoup
{
/// The user asked for something impossible; exit code 1. The message is one
/// line: what, where, which values are allowed.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The numerics failed although the step was cut back; exit code 2. The
/// message names time, place and state.
class NumericsError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The machine failed: disk, memory; exit code 3.
class SystemError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace contrecoup
