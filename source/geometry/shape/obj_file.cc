// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/geometry/shape/obj_file.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace contrecoup
{
namespace
{
  class ObjReader
  {
  public:
    ObjReader(const std::string &file, const double unit)
      : file_(file)
      , unit_(unit)
    {}

    TriangleMesh read();

  private:
    [[noreturn]] void refuse(const std::string &why) const
    {
      throw InputError("surface \"" + file_ +
                       "\" cannot be read as OBJ: line " +
                       std::to_string(line_) + ": " + why);
    }

    bool next_line(std::istream &stream, std::string &text);
    void read_vertex(std::istringstream &words);
    void read_face(std::istringstream &words);

    std::string file_;
    double unit_; ///< [m]
    std::size_t line_ = 0;
    TriangleMesh mesh_;
  };


  /// A line with those that a backslash joins to it.
  bool ObjReader::next_line(std::istream &stream, std::string &text)
  {
    text.clear();
    std::string part;
    while (std::getline(stream, part))
    {
      ++line_;
      if (!part.empty() && part.back() == '\r')
        part.pop_back();
      if (part.empty() || part.back() != '\\')
      {
        text += part;
        return true;
      }
      part.back() = ' ';
      text += part;
    }
    return !text.empty();
  }


  void ObjReader::read_vertex(std::istringstream &words)
  {
    dealii::Point<3> vertex;
    std::string word;
    for (unsigned int d = 0; d < 3; ++d)
    {
      if (!(words >> word))
        refuse("a vertex has fewer than three numbers");
      char *end = nullptr;
      vertex[d] = unit_ * std::strtod(word.c_str(), &end);
      if (end != word.c_str() + word.size())
        refuse(quotation(word) + " is no number");
    }
    mesh_.vertices.push_back(vertex);
  }


  void ObjReader::read_face(std::istringstream &words)
  {
    const auto n_vertices = static_cast<long long>(mesh_.vertices.size());
    std::vector<std::uint32_t> corners;
    for (std::string word; words >> word;)
    {
      // "vertex/texture/normal"; negative numbers count from the last vertex.
      char *end = nullptr;
      const long long number = std::strtoll(word.c_str(), &end, 10);
      const long long index = number < 0 ? n_vertices + number : number - 1;
      if (end == word.c_str() || (*end != '\0' && *end != '/') || index < 0 ||
          index >= n_vertices)
        refuse("a face has the corner " + quotation(word) +
               ", known are the vertices 1 to " + std::to_string(n_vertices));
      corners.push_back(static_cast<std::uint32_t>(index));
    }
    for (std::size_t c = 2; c < corners.size(); ++c)
      mesh_.triangles.push_back({{corners[0], corners[c - 1], corners[c]}});
  }


  TriangleMesh ObjReader::read()
  {
    std::ifstream stream(file_);
    std::string text, keyword;
    while (next_line(stream, text))
    {
      std::istringstream words(text);
      if (!(words >> keyword))
        continue;
      if (keyword == "v")
        read_vertex(words);
      else if (keyword == "f")
        read_face(words);
    }
    return mesh_;
  }
} // namespace


TriangleMesh read_obj(const std::string &file, const double unit)
{
  require_readable("the surface", file);
  return ObjReader(file, unit).read();
}
} // namespace contrecoup
