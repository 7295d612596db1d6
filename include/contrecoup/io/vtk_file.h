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
  /**
   * A VTK XML file of arrays that are compressed (zlib) and appended in binary
   * form, which ParaView reads. Arrays are compressed when they are added, so
   * that the file costs little memory.
   */
  class VtkFile
  {
  public:
    /// @param type UnstructuredGrid, ImageData or another of VTK's words
    /// @param grid_attributes of the grid's element, such as WholeExtent
    /// @param piece_attributes of its only piece, such as NumberOfPoints
    VtkFile(const std::string &type,
            const std::string &grid_attributes,
            const std::string &piece_attributes);

    /**
     * Adds an array.
     * @param section Points, Cells, PointData or CellData; the arrays of one
     *   section are added one after the other
     * @param Number double, float, std::uint32_t, std::int64_t or
     *   unsigned char
     */
    template <typename Number>
    void add(const std::string &section,
             const std::string &name,
             const std::vector<Number> &values,
             unsigned int n_components = 1);

    /// @throws SystemError
    void write(const std::string &file) const;

  private:
    void add_bytes(const std::string &section,
                   const std::string &attributes,
                   const unsigned char *data,
                   std::size_t n_bytes);

    std::string type_;
    std::string grid_attributes_;
    std::string piece_attributes_;
    std::string section_;
    std::string description_;
    std::vector<std::string> blocks_;
    std::uint64_t offset_ = 0;
  };

  /// The number of a linear hexahedron and quadrilateral among VTK's cells.
  inline constexpr unsigned char vtk_hexahedron = 12;
  inline constexpr unsigned char vtk_quadrilateral = 9;
} // namespace io
} // namespace contrecoup
