// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Reads a VTK XML file as VtkFile writes it, or with its arrays appended as
  /// raw bytes. The file may be damaged: no allocation exceeds what its size
  /// justifies.
  class VtkInput
  {
  public:
    /// @throws InputError unless the file can be read and is such a one
    explicit VtkInput(const std::string &file);

    /// Names of the arrays, in the order of the file.
    std::vector<std::string> names() const;

    /// "0 255 0 0 0 127" of ImageData: first and last point along x, y and z;
    /// empty for other types.
    const std::string &extent() const
    {
      return extent_;
    }

    /// Reads an array of doubles, all components of a point or cell together.
    /// @throws InputError when it is missing, damaged, or of another type
    std::vector<double> numbers(const std::string &name) const;

  private:
    struct Array
    {
      std::string type;
      std::string name;
      std::size_t begin; ///< in the content
      std::size_t size;  ///< of the text; raw bytes tell theirs themselves
      bool is_raw;
    };

    [[noreturn]] void refuse(const std::string &why) const;
    void find_arrays();
    std::string decode(const std::string &text) const;
    std::uint64_t number_at(const std::string &bytes, std::size_t place) const;
    std::string decompress(const std::string &bytes, std::size_t place) const;

    std::string file_;
    std::string content_;
    std::string extent_;
    std::vector<Array> arrays_;
  };
} // namespace io
} // namespace contrecoup
