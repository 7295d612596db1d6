// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/file/skin_file.h>
#include <contrecoup/io/file/vtk_file.h>

#include <array>
#include <map>
#include <stdexcept>

namespace contrecoup
{
namespace io
{
  SkinMesh make_skin_mesh(const std::vector<std::vector<float>> &outlines,
                          const bool are_lines)
  {
    SkinMesh skin;
    skin.are_lines = are_lines;
    std::map<std::array<float, 3>, std::uint32_t> numbers;
    for (const std::vector<float> &outline : outlines)
    {
      for (std::size_t i = 0; i + 2 < outline.size(); i += 3)
      {
        const std::array<float, 3> place{
          {outline[i], outline[i + 1], outline[i + 2]}};
        const auto [known, is_new] =
          numbers.insert({place, static_cast<std::uint32_t>(numbers.size())});
        skin.corners.push_back(known->second);
        if (is_new)
          skin.vertices.insert(skin.vertices.end(), place.begin(), place.end());
      }
      skin.ends.push_back(static_cast<std::int64_t>(skin.corners.size()));
    }
    return skin;
  }


  void write_skin(const std::string &file,
                  const SkinMesh &skin,
                  const std::vector<SkinField> &fields,
                  const double time)
  {
    const std::string n_facets = std::to_string(skin.ends.size());
    VtkFile output("PolyData",
                   "",
                   "NumberOfPoints=\"" +
                     std::to_string(skin.vertices.size() / 3) +
                     "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
                     (skin.are_lines ? n_facets : "0") +
                     "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
                     (skin.are_lines ? "0" : n_facets) + "\"");
    output.set_time(time);
    output.add("Points", "points", skin.vertices, 3, "m");
    const std::string section = skin.are_lines ? "Lines" : "Polys";
    output.add(section, "connectivity", skin.corners);
    output.add(section, "offsets", skin.ends);
    for (const SkinField &field : fields)
    {
      if (field.values.size() != skin.ends.size())
        throw std::invalid_argument("write_skin: " + field.name +
                                    " is of other facets");
      output.add("CellData", field.name, field.values, 1, field.unit);
    }
    output.write(file);
  }
} // namespace io
} // namespace contrecoup
