// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/hdf5_handle.h>

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * Reads numbers and words of an HDF5 file that may be damaged: whatever its
   * parts claim, nothing is made larger than what the file can hold.
   */
  class Hdf5Input
  {
  public:
    /// @throws InputError for a file that is no HDF5
    explicit Hdf5Input(const std::string &path);

    /// Whether there is an attribute of the whole file with this name.
    bool has_attribute(const std::string &name) const;

    /// Whether there is a dataset with this name.
    bool has_dataset(const std::string &name) const;

    /// A whole dataset. @throws InputError when it is missing or damaged
    std::vector<double> numbers(const std::string &name) const;

    /// An attribute of the file that is a number. @throws InputError
    double number(const std::string &name) const;

    /// An attribute of the file that is a text of fixed length.
    /// @throws InputError
    std::string text(const std::string &name) const;

  private:
    [[noreturn]] void refuse(const std::string &why) const;

    std::string path_;
    Hdf5Handle file_;
  };
} // namespace io
} // namespace contrecoup
