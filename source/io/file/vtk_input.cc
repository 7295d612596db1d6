// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/vtk_input.h>

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
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t end = content_.find(mark);
    if (content_.find("<VTKFile ") == std::string::npos ||
        end == std::string::npos)
      refuse("it is no VTK file with appended arrays");
    const std::string description = content_.substr(0, end);
    extent_ = attribute(description, "WholeExtent");
    find_arrays(description, end + mark.size());
  }


  void VtkInput::refuse(const std::string &why) const
  {
    throw InputError("\"" + file_ + "\" cannot be read: " + why);
  }


  void VtkInput::find_arrays(const std::string &description,
                             const std::size_t data)
  {
    const std::string mark = "<DataArray ";
    for (std::size_t begin = description.find(mark); begin != std::string::npos;
         begin = description.find(mark, begin + 1))
    {
      const std::string tag =
        description.substr(begin, description.find('>', begin) - begin);
      if (attribute(tag, "format") == "appended")
        arrays_.push_back(
          {attribute(tag, "type"),
           attribute(tag, "Name"),
           data +
             std::strtoull(attribute(tag, "offset").c_str(), nullptr, 10)});
    }
  }


  std::vector<std::string> VtkInput::names() const
  {
    std::vector<std::string> result;
    for (const Array &array : arrays_)
      result.push_back(array.name);
    return result;
  }


  std::uint64_t VtkInput::number_at(const std::size_t place) const
  {
    std::uint64_t number = 0;
    if (place > content_.size() || content_.size() - place < sizeof(number))
      refuse("it is cut off");
    std::memcpy(&number, content_.data() + place, sizeof(number));
    return number;
  }


  std::string VtkInput::decompress(const std::size_t place) const
  {
    const std::uint64_t word = sizeof(std::uint64_t);
    const std::uint64_t n_blocks = number_at(place);
    const std::uint64_t block_size = number_at(place + word);
    const std::uint64_t last_size = number_at(place + 2 * word);
    if (n_blocks > content_.size())
      refuse("sizes in it are damaged");
    std::string result;
    std::size_t begin = place + (3 + n_blocks) * word;
    for (std::uint64_t block = 0; block < n_blocks; ++block)
    {
      const std::uint64_t packed = number_at(place + (3 + block) * word);
      if (begin > content_.size() || packed > content_.size() - begin)
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
            reinterpret_cast<const unsigned char *>(content_.data() + begin),
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
    const std::string bytes = decompress(found->begin);
    if (bytes.size() % sizeof(double) != 0)
      refuse("an array in it is damaged");
    std::vector<double> values(bytes.size() / sizeof(double));
    if (!values.empty())
      std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
} // namespace io
} // namespace contrecoup
