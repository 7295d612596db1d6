// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/shape/ply_file.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace contrecoup
{
namespace
{
  enum class Format
  {
    ascii,
    little_endian,
    big_endian
  };

  /// Storage type of a number.
  struct Type
  {
    std::size_t size;
    char kind; ///< 'i' integer, 'u' unsigned integer, 'f' floating point
  };

  struct Property
  {
    std::string name;
    Type type;
    bool is_list;
    Type count; ///< of a list's length
  };

  struct Element
  {
    std::string name;
    std::uint64_t count;
    std::vector<Property> properties;
  };

  class PlyReader
  {
  public:
    explicit PlyReader(const std::string &file);

    TriangleMesh read(double unit);

  private:
    [[noreturn]] void refuse(const std::string &why) const;

    void read_header();
    void read_format(std::istringstream &words);
    void add_element(std::istringstream &words);
    void add_property(std::istringstream &words);
    std::string next_line();
    Type type_of(const std::string &name) const;

    double next_number(const Type &type);
    double next_word();
    double next_bytes(const Type &type);
    std::uint64_t next_count(const Type &type, std::uint64_t end);
    void read_vertices(const Element &element, double unit, TriangleMesh &mesh);
    void read_faces(const Element &element, TriangleMesh &mesh);
    std::vector<double> next_list(const Property &property);

    std::string file_;
    std::string content_;
    std::size_t place_ = 0;
    Format format_ = Format::ascii;
    std::vector<Element> elements_;
  };


  PlyReader::PlyReader(const std::string &file)
    : file_(file)
  {
    require_readable("the surface", file);
    std::ifstream stream(file, std::ios::binary);
    content_.assign(std::istreambuf_iterator<char>(stream), {});
  }


  void PlyReader::refuse(const std::string &why) const
  {
    throw InputError("surface \"" + file_ + "\" cannot be read as PLY: " + why);
  }


  std::string PlyReader::next_line()
  {
    if (place_ >= content_.size())
      refuse("its header has no \"end_header\"");
    const std::size_t end =
      std::min(content_.find('\n', place_), content_.size());
    const std::string line = content_.substr(place_, end - place_);
    place_ = std::min(end + 1, content_.size());
    return trim(line);
  }


  Type PlyReader::type_of(const std::string &name) const
  {
    static const std::vector<std::pair<std::string, Type>> types{
      {"char", {1, 'i'}},
      {"int8", {1, 'i'}},
      {"uchar", {1, 'u'}},
      {"uint8", {1, 'u'}},
      {"short", {2, 'i'}},
      {"int16", {2, 'i'}},
      {"ushort", {2, 'u'}},
      {"uint16", {2, 'u'}},
      {"int", {4, 'i'}},
      {"int32", {4, 'i'}},
      {"uint", {4, 'u'}},
      {"uint32", {4, 'u'}},
      {"float", {4, 'f'}},
      {"float32", {4, 'f'}},
      {"double", {8, 'f'}},
      {"float64", {8, 'f'}}};
    for (const auto &[known, type] : types)
      if (known == name)
        return type;
    refuse("\"" + one_line(name) + "\" is no type of numbers");
  }


  void PlyReader::read_header()
  {
    if (next_line() != "ply")
      refuse("it does not begin with \"ply\"");
    for (std::string line = next_line(); line != "end_header";
         line = next_line())
    {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "format")
        read_format(words);
      else if (keyword == "element")
        add_element(words);
      else if (keyword == "property")
        add_property(words);
      else if (!keyword.empty() && keyword != "comment" &&
               keyword != "obj_info")
        refuse("its header has a line \"" + one_line(line) + "\"");
    }
  }


  void PlyReader::read_format(std::istringstream &words)
  {
    std::string name;
    words >> name;
    if (name == "ascii")
      format_ = Format::ascii;
    else if (name == "binary_little_endian")
      format_ = Format::little_endian;
    else if (name == "binary_big_endian")
      format_ = Format::big_endian;
    else
      refuse("\"" + one_line(name) + "\" is no format");
  }


  void PlyReader::add_element(std::istringstream &words)
  {
    Element element;
    std::string rest;
    // Each counted item takes at least one byte.
    if (!(words >> element.name >> element.count) || words >> rest ||
        element.count > content_.size())
      refuse("it has an element without a possible number");
    elements_.push_back(element);
  }


  void PlyReader::add_property(std::istringstream &words)
  {
    std::string type, count;
    words >> type;
    Property property{"", {}, type == "list", {}};
    if (property.is_list)
    {
      words >> count >> type;
      property.count = type_of(count);
    }
    property.type = type_of(type);
    if (!(words >> property.name) || elements_.empty())
      refuse("it has a property of nothing, or without a name");
    elements_.back().properties.push_back(property);
  }


  double PlyReader::next_word()
  {
    const char *const white = " \t\r\n";
    const std::size_t begin = content_.find_first_not_of(white, place_);
    if (begin == std::string::npos)
      refuse("it ends too early");
    place_ = std::min(content_.find_first_of(white, begin), content_.size());
    const std::string word = content_.substr(begin, place_ - begin);
    char *end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end != word.c_str() + word.size())
      refuse("\"" + one_line(word) + "\" is no number");
    return value;
  }


  template <typename Number>
  double from_bits(const std::uint64_t bits)
  {
    Number number;
    std::memcpy(&number, &bits, sizeof(number));
    return static_cast<double>(number);
  }


  double PlyReader::next_bytes(const Type &type)
  {
    if (content_.size() - place_ < type.size)
      refuse("it ends too early");
    std::uint64_t bits = 0; // the lowest byte first
    for (std::size_t i = 0; i < type.size; ++i)
    {
      const std::size_t at =
        format_ == Format::big_endian ? type.size - 1 - i : i;
      bits |= std::uint64_t(static_cast<unsigned char>(content_[place_ + at]))
              << (8 * i);
    }
    place_ += type.size;
    if (type.kind == 'f')
      return type.size == 4 ? from_bits<float>(bits) : from_bits<double>(bits);
    const bool is_signed = type.kind == 'i';
    if (type.size == 1)
      return is_signed ? from_bits<std::int8_t>(bits)
                       : from_bits<std::uint8_t>(bits);
    if (type.size == 2)
      return is_signed ? from_bits<std::int16_t>(bits)
                       : from_bits<std::uint16_t>(bits);
    return is_signed ? from_bits<std::int32_t>(bits)
                     : from_bits<std::uint32_t>(bits);
  }


  double PlyReader::next_number(const Type &type)
  {
    return format_ == Format::ascii ? next_word() : next_bytes(type);
  }


  /// An integer below @p end.
  std::uint64_t PlyReader::next_count(const Type &type, const std::uint64_t end)
  {
    const double value = next_number(type);
    if (!(value >= 0. && value < static_cast<double>(end)) ||
        value != std::floor(value))
      refuse("it counts something that it does not have");
    return static_cast<std::uint64_t>(value);
  }


  std::vector<double> PlyReader::next_list(const Property &property)
  {
    if (!property.is_list)
      return {next_number(property.type)};
    std::vector<double> list(
      next_count(property.count, content_.size() - place_ + 1));
    for (double &value : list)
      value = next_number(property.type);
    return list;
  }


  void PlyReader::read_vertices(const Element &element,
                                const double unit,
                                TriangleMesh &mesh)
  {
    for (const char *axis : {"x", "y", "z"})
      if (std::none_of(element.properties.begin(),
                       element.properties.end(),
                       [&](const Property &property) {
                         return property.name == axis && !property.is_list;
                       }))
        refuse(std::string("its vertices have no ") + axis);
    for (std::uint64_t i = 0; i < element.count; ++i)
    {
      dealii::Point<3> vertex;
      for (const Property &property : element.properties)
      {
        const std::vector<double> values = next_list(property);
        if (property.name.size() == 1 && property.name[0] >= 'x' &&
            property.name[0] <= 'z' && !property.is_list)
          vertex[property.name[0] - 'x'] = unit * values[0];
      }
      mesh.vertices.push_back(vertex);
    }
  }


  void PlyReader::read_faces(const Element &element, TriangleMesh &mesh)
  {
    const auto n_vertices = static_cast<double>(mesh.vertices.size());
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const Property &property : element.properties)
      {
        const std::vector<double> values = next_list(property);
        if (property.name != "vertex_indices" &&
            property.name != "vertex_index")
          continue;
        std::vector<std::uint32_t> corners;
        for (const double value : values)
        {
          if (!(value >= 0. && value < n_vertices))
            refuse("a face has a corner that is no vertex");
          corners.push_back(static_cast<std::uint32_t>(value));
        }
        for (std::size_t c = 2; c < corners.size(); ++c)
          mesh.triangles.push_back({{corners[0], corners[c - 1], corners[c]}});
      }
  }


  TriangleMesh PlyReader::read(const double unit)
  {
    read_header();
    TriangleMesh mesh;
    for (const Element &element : elements_)
      if (element.name == "vertex")
        read_vertices(element, unit, mesh);
      else if (element.name == "face")
        read_faces(element, mesh);
      else
        for (std::uint64_t i = 0; i < element.count; ++i)
          for (const Property &property : element.properties)
            next_list(property);
    return mesh;
  }
} // namespace


TriangleMesh read_ply(const std::string &file, const double unit)
{
  return PlyReader(file).read(unit);
}
} // namespace contrecoup
