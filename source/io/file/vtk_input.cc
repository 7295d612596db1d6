// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/vtk_input.h>

#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Value of an attribute of an XML tag; empty without it.
    std::string attribute(const std::string &tag, const std::string &name)
    {
      const std::string mark = " " + name + "=\"";
      const std::size_t begin = tag.find(mark);
      const std::size_t end = tag.find('"', begin + mark.size());
      return begin == std::string::npos || end == std::string::npos
               ? ""
               : tag.substr(begin + mark.size(), end - begin - mark.size());
    }
  } // namespace


  VtkInput::VtkInput(const std::string &file)
    : file_(file)
  {
    require_readable("the fields", file);
    content_ = read_file(file);
    if (content_.find("<VTKFile ") == std::string::npos ||
        attribute(content_, "compressor") != "vtkZLibDataCompressor" ||
        attribute(content_, "header_type") != "UInt64")
      refuse("it is no VTK file of arrays compressed by zlib, with headers of "
             "type UInt64");
    if (content_.rfind("</VTKFile>") == std::string::npos)
      refuse("it is cut off");
    extent_ = attribute(content_, "WholeExtent");
    find_arrays();
  }


  void VtkInput::refuse(const std::string &why) const
  {
    throw InputError("\"" + file_ + "\" cannot be read: " + why);
  }


  void VtkInput::find_arrays()
  {
    const std::string data = "<AppendedData encoding=\"raw\">\n_";
    const std::string mark = "<DataArray ";
    const std::size_t raw = content_.find(data);
    for (std::size_t begin = content_.find(mark); begin < raw;
         begin = content_.find(mark, begin + 1))
    {
      const std::size_t end = content_.find('>', begin);
      const std::size_t next = content_.find('<', end);
      if (next == std::string::npos)
        refuse("it is cut off");
      const std::string tag = content_.substr(begin, end - begin);
      const std::string format = attribute(tag, "format");
      Array array{attribute(tag, "type"),
                  attribute(tag, "Name"),
                  end + 1,
                  next - end - 1,
                  format == "appended" && raw != std::string::npos};
      if (array.is_raw)
        array.begin =
          raw + data.size() +
          std::strtoull(attribute(tag, "offset").c_str(), nullptr, 10);
      if (array.is_raw || format == "binary")
        arrays_.push_back(array);
    }
  }


  std::vector<std::string> VtkInput::names() const
  {
    std::vector<std::string> result;
    for (const Array &array : arrays_)
      result.push_back(array.name);
    return result;
  }


  std::uint64_t VtkInput::number_at(const std::string &bytes,
                                    const std::size_t place) const
  {
    std::uint64_t number = 0;
    if (place > bytes.size() || bytes.size() - place < sizeof(number))
      refuse("it is cut off");
    std::memcpy(&number, bytes.data() + place, sizeof(number));
    return number;
  }


  std::string VtkInput::decode(const std::string &text) const
  {
    const auto part = [&](const std::size_t begin, const std::size_t size) {
      const std::string letters = text.substr(begin, size);
      try
      {
        if (letters.size() % 4 == 0)
        {
          const auto bytes = dealii::Utilities::decode_base64(letters);
          return std::string(bytes.begin(), bytes.end());
        }
      }
      catch (const std::exception &)
      {}
      refuse("an array in it is damaged");
    };
    // The header is text of its own, as long as its first number tells.
    const std::uint64_t n_blocks = number_at(part(0, 12), 0);
    if (n_blocks > text.size())
      refuse("sizes in it are damaged");
    const std::size_t size =
      4 * (((3 + n_blocks) * sizeof(std::uint64_t) + 2) / 3);
    if (size > text.size())
      refuse("it is cut off");
    return part(0, size) + part(size, std::string::npos);
  }


  std::string VtkInput::decompress(const std::string &bytes,
                                   const std::size_t place) const
  {
    const std::uint64_t word = sizeof(std::uint64_t);
    const std::uint64_t n_blocks = number_at(bytes, place);
    const std::uint64_t block_size = number_at(bytes, place + word);
    const std::uint64_t last_size = number_at(bytes, place + 2 * word);
    if (n_blocks > bytes.size())
      refuse("sizes in it are damaged");
    std::string result;
    std::size_t begin = place + (3 + n_blocks) * word;
    for (std::uint64_t block = 0; block < n_blocks; ++block)
    {
      const std::uint64_t packed = number_at(bytes, place + (3 + block) * word);
      if (begin > bytes.size() || packed > bytes.size() - begin)
        refuse("it is cut off");
      const bool is_short = block + 1 == n_blocks && last_size > 0;
      uLongf size = is_short ? last_size : block_size;
      if (size / largest_zlib_ratio > packed)
        refuse("sizes in it are damaged");
      const std::size_t before = result.size();
      const uLongf wanted = size;
      result.resize(before + size);
      if (uncompress(
            reinterpret_cast<unsigned char *>(&result[before]),
            &size,
            reinterpret_cast<const unsigned char *>(bytes.data() + begin),
            packed) != Z_OK ||
          size != wanted)
        refuse("an array in it is damaged");
      begin += packed;
    }
    return result;
  }


  std::vector<double> VtkInput::numbers(const std::string &name) const
  {
    const auto found =
      std::find_if(arrays_.begin(), arrays_.end(), [&](const Array &array) {
        return array.name == name;
      });
    if (found == arrays_.end() || found->type != "Float64")
      refuse("it has no array \"" + name + "\" of doubles");
    const std::string bytes =
      found->is_raw ? decompress(content_, found->begin)
                    : decompress(decode(dealii::Utilities::trim(
                                   content_.substr(found->begin, found->size))),
                                 0);
    if (bytes.size() % sizeof(double) != 0)
      refuse("an array in it is damaged");
    std::vector<double> values(bytes.size() / sizeof(double));
    if (!values.empty())
      std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
} // namespace io
} // namespace contrecoup
