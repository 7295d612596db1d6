// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/mesh/abaqus_deck.h>
#include <contrecoup/geometry/mesh/coincident_nodes.h>
#include <contrecoup/geometry/mesh/mesh_file.h>
#include <contrecoup/geometry/mesh/mesh_format.h>
#include <contrecoup/geometry/mesh/mesh_pieces.h>

#include <deal.II/grid/grid_in.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace contrecoup
{
namespace
{
  /// Whether a line of a VTK file announces a number of entries.
  bool counts_for_vtk(const std::string &line)
  {
    for (const char *const word : {"POINTS ", "CELLS ", "CELL_TYPES "})
      if (line.rfind(word, 0) == 0)
        return true;
    return false;
  }


  /// Largest number of nodes, cells or blocks that a text claims: deal.II
  /// allocates memory for the claim before it reads.
  std::uint64_t largest_claim(std::istream &text, const std::string &ending)
  {
    std::uint64_t largest = 0;
    bool is_next = ending == "inp" || ending == "ucd";
    for (std::string line; std::getline(text, line);)
    {
      if (line.rfind('#', 0) == 0)
        continue;
      std::istringstream words(line);
      if (ending == "vtk" && counts_for_vtk(line))
      {
        std::string keyword;
        words >> keyword;
        is_next = true;
      }
      std::uint64_t claim = 0;
      for (unsigned int i = 0; is_next && i < 2 && words >> claim; ++i)
        largest = std::max(largest, claim);
      is_next = ending == "msh" && line.rfind('$', 0) == 0;
    }
    return largest;
  }


  template <int dim>
  void read_cells(const std::string &path,
                  const std::string &entry,
                  dealii::Triangulation<dim> &mesh)
  {
    const std::string where = entry + " = " + path + ": ";
    const std::string why = why_unreadable(path);
    if (!why.empty())
      throw InputError(where + why);
    std::ifstream stream(path);
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (!stream || error)
      throw InputError(where + "the file cannot be opened");
    std::string ending = std::filesystem::path(path).extension();
    ending.erase(0, 1);
    const std::vector<std::string> known = {
      "msh", "vtk", "vtu", "inp", "ucd", "unv", "xda", "dbmesh", "dat"};
    if (std::find(known.begin(), known.end(), ending) == known.end())
      throw InputError(where + "its name must end as that of a mesh: ." +
                       join(known, ", ."));
    const std::uint64_t claim = largest_claim(stream, ending);
    if (claim > size)
      throw InputError(where + "it has " + std::to_string(size) +
                       " bytes and claims " + std::to_string(claim) +
                       " nodes or cells");
    stream.clear();
    stream.seekg(0);
    const std::string unusable = why_unusable_mesh(stream, ending, dim);
    if (!unusable.empty())
      throw InputError(where + unusable);
    const std::string cells = dim == 3 ? "hexahedra" : "quadrilaterals";
    try
    {
      dealii::GridIn<dim> reader(mesh);
      if (ending == "inp" && is_abaqus_deck(stream))
      {
        std::istringstream ucd(read_abaqus_deck(stream, dim, where).ucd);
        reader.read_ucd(ucd);
      }
      else
        reader.read(stream, dealii::GridIn<dim>::parse_format(ending));
    }
    catch (const InputError &)
    {
      throw;
    }
    catch (const std::exception &problem)
    {
      // Accept distorted cells; later checks name their position.
      if (dynamic_cast<
            const typename dealii::Triangulation<dim>::DistortedCellList *>(
            &problem) == nullptr)
        throw InputError(where + "deal.II cannot read it as a mesh of " +
                         cells + "; accepted are " + accepted_mesh_formats());
    }
    if (!mesh.all_reference_cells_are_hyper_cube())
      throw InputError(where + "it has cells that are no " + cells);
  }
} // namespace


template <int dim>
std::vector<std::string> read_mesh_file(const std::string &path,
                                        const std::string &entry,
                                        dealii::Triangulation<dim> &mesh)
{
  dealii::Triangulation<dim> own;
  read_cells(path, entry, own);
  const std::string where = entry + " = " + path;
  std::vector<std::string> lines{merge_coincident_nodes(own, where)};
  const std::vector<unsigned int> piece = find_pieces(own);
  const unsigned int n_pieces =
    piece.empty() ? 0 : 1 + *std::max_element(piece.begin(), piece.end());
  lines.push_back(pieces_warning(where + ": the mesh", n_pieces));
  lines.erase(std::remove(lines.begin(), lines.end(), ""), lines.end());
  mesh.copy_triangulation(own);
  return lines;
}


std::map<unsigned int, std::string>
read_group_names(const std::string &path, const unsigned int dimension)
{
  std::map<unsigned int, std::string> names;
  std::ifstream stream(path);
  if (!stream)
    throw InputError(path + ": the file cannot be opened");
  const std::string ending = std::filesystem::path(path).extension();
  if (ending == ".inp" && is_abaqus_deck(stream))
    return read_abaqus_deck(stream, dimension, path + ": ").groups;
  if (ending != ".msh")
    return names;
  bool is_inside = false;
  for (std::string line; std::getline(stream, line);)
  {
    line = trim(line);
    if (line == "$PhysicalNames")
      is_inside = true;
    else if (line == "$EndPhysicalNames" || line == "$Nodes")
      break;
    else if (is_inside)
    {
      std::istringstream words(line);
      unsigned int of_dimension = 0, number = 0;
      std::string name;
      // The first line is the number of names.
      if (words >> of_dimension >> number >> std::quoted(name) &&
          of_dimension == dimension && !name.empty())
        names[number] = name;
    }
  }
  return names;
}


template std::vector<std::string> read_mesh_file(const std::string &,
                                                 const std::string &,
                                                 dealii::Triangulation<1> &);
template std::vector<std::string> read_mesh_file(const std::string &,
                                                 const std::string &,
                                                 dealii::Triangulation<2> &);
template std::vector<std::string> read_mesh_file(const std::string &,
                                                 const std::string &,
                                                 dealii::Triangulation<3> &);
} // namespace contrecoup
