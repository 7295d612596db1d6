// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/geometry/shape/stl_file.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

namespace contrecoup
{
namespace
{
  constexpr std::size_t header_size = 84;
  constexpr std::size_t triangle_size = 50;
  const char *const white = " \t\r\n\v\f";

  [[noreturn]] void refuse(const std::string &file, const std::string &why)
  {
    throw InputError("surface \"" + file + "\" cannot be read as STL: " + why);
  }

  std::string lower_case(std::string word)
  {
    std::transform(word.begin(), word.end(), word.begin(), [](const char one) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(one)));
    });
    return word;
  }

  void add_triangle(const std::array<dealii::Point<3>, 3> &corners,
                    TriangleMesh &mesh)
  {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({{first, first + 1, first + 2}});
  }


  /// Number of triangles that the header of a binary file counts.
  std::size_t counted_triangles(const std::string &content)
  {
    std::uint32_t count = 0;
    std::memcpy(&count, &content[header_size - sizeof(count)], sizeof(count));
    return count;
  }

  TriangleMesh read_binary(const std::string &content,
                           const std::size_t count,
                           const double unit)
  {
    TriangleMesh mesh;
    for (std::size_t i = 0; i < count; ++i)
    {
      // After the normal.
      std::array<float, 9> numbers;
      std::memcpy(numbers.data(),
                  &content[header_size + i * triangle_size + 12],
                  sizeof(numbers));
      std::array<dealii::Point<3>, 3> corners;
      for (unsigned int v = 0; v < 3; ++v)
        for (unsigned int d = 0; d < 3; ++d)
          corners[v][d] = unit * static_cast<double>(numbers[3 * v + d]);
      add_triangle(corners, mesh);
    }
    return mesh;
  }


  /// Words of a text with their line numbers.
  class AsciiReader
  {
  public:
    AsciiReader(const std::string &file, const std::string &content)
      : file_(file)
      , content_(content)
    {}

    TriangleMesh read(double unit, std::vector<std::string> &remarks);

  private:
    /// The next word in lower case; empty at the end.
    std::string next_word();
    void skip_line();
    double next_number();
    void end_facet(std::vector<dealii::Point<3>> &corners, TriangleMesh &mesh);

    std::string line() const
    {
      return "line " + std::to_string(1 + std::count(content_.begin(),
                                                     content_.begin() + place_,
                                                     '\n'));
    }

    const std::string &file_;
    const std::string &content_;
    std::size_t place_ = 0;
  };

  std::string AsciiReader::next_word()
  {
    const std::size_t begin =
      std::min(content_.find_first_not_of(white, place_), content_.size());
    place_ = std::min(content_.find_first_of(white, begin), content_.size());
    return lower_case(content_.substr(begin, place_ - begin));
  }

  void AsciiReader::skip_line()
  {
    place_ = std::min(content_.find_first_of("\r\n", place_), content_.size());
  }

  double AsciiReader::next_number()
  {
    const std::string word = next_word();
    char *end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (word.empty())
      refuse(file_, "it is cut: it ends within a triangle");
    if (end != word.c_str() + word.size())
      refuse(file_, line() + ": " + quotation(word) + " is no number");
    return number;
  }

  void AsciiReader::end_facet(std::vector<dealii::Point<3>> &corners,
                              TriangleMesh &mesh)
  {
    if (corners.size() != 3)
      refuse(file_,
             line() + ": a triangle has " + std::to_string(corners.size()) +
               " vertices");
    add_triangle({{corners[0], corners[1], corners[2]}}, mesh);
    corners.clear();
  }

  TriangleMesh AsciiReader::read(const double unit,
                                 std::vector<std::string> &remarks)
  {
    TriangleMesh mesh;
    std::vector<dealii::Point<3>> corners;
    bool has_end = false;
    for (std::string word = next_word(); !word.empty(); word = next_word())
    {
      if (word == "solid" || word == "endsolid")
      {
        has_end = word == "endsolid";
        // The name may hold any word.
        skip_line();
      }
      else if (word == "vertex")
      {
        dealii::Point<3> corner;
        for (unsigned int d = 0; d < 3; ++d)
          corner[d] = unit * next_number();
        corners.push_back(corner);
      }
      else if (word == "endloop")
        end_facet(corners, mesh);
      else if (word == "facet")
        skip_line();
      else if (word != "outer" && word != "loop" && word != "endfacet")
        refuse(file_, line() + ": unknown word " + quotation(word));
    }
    if (!corners.empty())
      refuse(file_, "it is cut: it ends within a triangle");
    if (!has_end)
      remarks.push_back("WARNING: surface \"" + file_ +
                        "\" may be cut: it has no \"endsolid\" after its " +
                        std::to_string(mesh.triangles.size()) + " triangles");
    return mesh;
  }

  bool is_text(const std::string &content)
  {
    return content.find('\0') == std::string::npos;
  }

  bool begins_as_ascii(const std::string &content)
  {
    const std::size_t begin =
      std::min(content.find_first_not_of(white), content.size());
    return lower_case(content.substr(begin, 5)) == "solid";
  }
} // namespace


TriangleMesh read_stl(const std::string &file,
                      const double unit,
                      std::vector<std::string> &remarks)
{
  require_readable("the surface", file);
  std::ifstream stream(file, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(stream), {});
  const std::size_t room = content.size() < header_size
                             ? 0
                             : (content.size() - header_size) / triangle_size;
  const std::size_t count =
    content.size() < header_size ? 0 : counted_triangles(content);
  // Binary files may begin with "solid" as well.
  const bool fits = content.size() == header_size + count * triangle_size;
  if (!fits && begins_as_ascii(content) && is_text(content))
    return AsciiReader(file, content).read(unit, remarks);
  if (content.size() < header_size || (count > room && is_text(content)))
    refuse(file,
           "it is neither binary nor does it begin with \"solid\", as ASCII "
           "does");
  const std::size_t wanted = header_size + count * triangle_size;
  if (count > room)
    refuse(file,
           "it is cut: its header counts " + std::to_string(count) +
             " triangles, it has " + std::to_string(room) + " of them, and " +
             std::to_string(wanted - content.size()) + " bytes are missing");
  if (!fits)
    remarks.push_back("the file has " +
                      std::to_string(content.size() - wanted) +
                      " bytes after the " + std::to_string(count) +
                      " triangles that its header counts; they are not read");
  const TriangleMesh mesh = read_binary(content, count, unit);
  check_single_precision(mesh, file, remarks);
  return mesh;
}
} // namespace contrecoup
