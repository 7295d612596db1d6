// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/mesh/mesh_groups.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace contrecoup
{
namespace
{
  using Names = std::map<unsigned int, std::string>;
  using Counts = std::map<unsigned int, std::size_t>;

  /// A number without sign; nothing for other words.
  std::optional<unsigned int> number_of(const std::string &word)
  {
    const bool is_number =
      !word.empty() && word.size() <= 9 &&
      std::all_of(word.begin(), word.end(), [](const unsigned char letter) {
        return std::isdigit(letter) != 0;
      });
    if (!is_number)
      return {};
    return static_cast<unsigned int>(std::stoul(word));
  }

  std::string name_in(const Names &names, const unsigned int number)
  {
    const auto found = names.find(number);
    return found == names.end() ? "" : found->second;
  }

  /// Whether @p group is this number, a range with it, or its name.
  bool
  means(const std::string &group, const unsigned int number, const Names &names)
  {
    if (group == name_in(names, number))
      return true;
    const std::size_t dash = std::min(group.find('-'), group.size());
    const auto first = number_of(trim(group.substr(0, dash)));
    const auto last =
      dash < group.size() ? number_of(trim(group.substr(dash + 1))) : first;
    return first && last && *first <= number && number <= *last;
  }

  /// The groups with these numbers, with names and counts of cells.
  std::string list_groups(const Counts &counts, const Names &names)
  {
    std::vector<std::string> texts;
    for (const auto &[number, count] : counts)
    {
      const std::string name = name_in(names, number);
      texts.push_back(std::to_string(number) +
                      (name.empty() ? "" : " \"" + name + "\"") + " (" +
                      std::to_string(count) + " cells)");
    }
    constexpr std::size_t most = 30;
    if (texts.size() > most)
      texts[most] = "...";
    texts.resize(std::min(texts.size(), most + 1));
    return join(texts, ", ");
  }
} // namespace


void MeshGroups::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_string(
    prm,
    "Tissues",
    "",
    selecting(
      "Tissue of each group of cells in the file, by number or name: \"1: brain; "
      "2-5: skeleton; scalp: soft tissue\"; groups that are named as a tissue, as "
      "in mesh.msh of `anatomy`, need no row, all others do."));
}


void MeshGroups::parse_parameters(dealii::ParameterHandler &prm,
                                  const std::string &section)
{
  entry_ = section + "/Tissues";
  rows_.clear();
  for (const std::string &text : split(prm.get("Tissues"), ';'))
  {
    if (text.empty())
      continue;
    const std::string where = entry_ + ", row \"" + text + "\"";
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || trim(text.substr(0, colon)).empty())
      throw InputError(where + ": must read \"group: tissue\", such as \"1: "
                               "brain\"");
    rows_.push_back({text,
                     trim(text.substr(0, colon)),
                     parse_body_part(text.substr(colon + 1), where)});
    if (rows_.back().part.tissue == Tissue::none)
      throw InputError(where + ": cells without tissue must be left out of the "
                               "file");
  }
}


std::vector<BodyPart> MeshGroups::assign(const Names &names,
                                         dealii::Triangulation<3> &mesh) const
{
  Counts counts;
  for (const auto &cell : mesh.active_cell_iterators())
    ++counts[cell->material_id()];
  std::vector<BodyPart> parts;
  std::map<unsigned int, unsigned int> part_of;
  Counts unknown;
  std::vector<std::size_t> n_cells(rows_.size(), 0);
  for (const auto &[number, count] : counts)
  {
    std::optional<BodyPart> part;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (means(rows_[i].group, number, names))
      {
        if (part)
          throw InputError(entry_ + ", row \"" + rows_[i].text +
                           "\": a row before it gives group " +
                           std::to_string(number) + " a tissue");
        part = rows_[i].part;
        n_cells[i] += count;
      }
    const std::string name = name_in(names, number);
    const auto &tissues = tissue_names();
    if (!part &&
        std::find(tissues.begin() + 1, tissues.end(), name) != tissues.end())
      part = BodyPart{name, find_tissue(name)};
    if (!part)
      unknown[number] = count;
    else
    {
      part_of[number] = parts.size();
      parts.push_back(*part);
    }
  }
  if (!unknown.empty())
    throw InputError(
      entry_ +
      " gives these groups of cells no tissue: " + list_groups(unknown, names) +
      "; name each, such as \"1: brain; skull: skeleton\"; "
      "tissues are " +
      join({tissue_names().begin() + 1, tissue_names().end()}, ", "));
  Selections selections;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    selections.add(entry_, rows_[i].text, "cell of the mesh", n_cells[i]);
  selections.require_some(MPI_COMM_SELF,
                          "its groups are " + list_groups(counts, names));
  if (parts.size() > 255)
    throw InputError(entry_ + ": the mesh has " + std::to_string(parts.size()) +
                     " groups of cells, at most 255 are allowed");
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(part_of[cell->material_id()]);
  return parts;
}
} // namespace contrecoup
