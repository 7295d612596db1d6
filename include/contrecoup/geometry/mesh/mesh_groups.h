// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/image/body_part.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
/**
 * The tissues of the groups of cells in a mesh file, an entry "Tissues": "1:
 * brain; 2-5: skeleton; scalp: skin". Before the colon stands the number of a
 * group, a range of numbers, or its name; behind it a tissue, or the name of a
 * part, "=" and its tissue. Later rows win. A group without a row whose name is
 * that of a tissue has this tissue.
 */
class MeshGroups
{
public:
  /// Declares the entry in the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entry from the current subsection.
  /// @param section its path, for error messages
  /// @throws InputError for a row that cannot be read
  void parse_parameters(dealii::ParameterHandler &prm,
                        const std::string &section);

  /**
   * Gives each cell the number of its part as material id.
   * @param names of the groups by material id, see read_group_names()
   * @return the parts that occur
   * @throws InputError, which lists the groups, for a group without tissue and
   * for a row without a group
   */
  std::vector<BodyPart> assign(const std::map<unsigned int, std::string> &names,
                               dealii::Triangulation<3> &mesh) const;

private:
  struct Row
  {
    std::string text;
    std::string group; ///< number, range or name
    BodyPart part;
  };

  std::string entry_;
  std::vector<Row> rows_;
};
} // namespace contrecoup
