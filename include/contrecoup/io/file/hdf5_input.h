// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/file/hdf5_handle.h>

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Reads numbers and texts from an HDF5 file that may be damaged: no
  /// allocation exceeds what the size of the file justifies.
  class Hdf5Input
  {
  public:
    /// @throws InputError unless the file is HDF5
    explicit Hdf5Input(const std::string &path);

    /// Whether the file has a global attribute with this name.
    bool has_attribute(const std::string &name) const;

    /// Whether the file has a dataset with this name.
    bool has_dataset(const std::string &name) const;

    /// Reads a dataset. @throws InputError when it is missing or damaged
    std::vector<double> numbers(const std::string &name) const;

    /// Reads a numeric global attribute. @throws InputError
    double number(const std::string &name) const;

    /// Reads a global attribute that is a text of fixed length.
    /// @throws InputError
    std::string text(const std::string &name) const;

  private:
    [[noreturn]] void refuse(const std::string &why) const;

    std::string path_;
    Hdf5Handle file_;
  };
} // namespace io
} // namespace contrecoup
