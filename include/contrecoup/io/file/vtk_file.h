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
  /// A VTK XML file for ParaView, with arrays in the form of deal.II's: in
  /// their elements, compressed by zlib, as text (base64), as only few readers
  /// know raw bytes. Arrays are compressed when they are added, which saves
  /// memory. VtkInput reads it.
  class VtkFile
  {
  public:
    /// @param type UnstructuredGrid, ImageData or another VTK type
    /// @param grid_attributes attributes of the grid, such as WholeExtent
    /// @param piece_attributes attributes of its only piece, such as
    /// NumberOfPoints
    VtkFile(const std::string &type,
            const std::string &grid_attributes,
            const std::string &piece_attributes);

    /**
     * Adds an array.
     * @param section Points, Cells, Polys, Lines, PointData or CellData; add
     * the arrays of a section consecutively
     * @param unit becomes VTK's UNITS_LABEL of the array; empty: none
     * @tparam Number double, float, std::uint32_t, std::int64_t or unsigned
     * char
     */
    template <typename Number>
    void add(const std::string &section,
             const std::string &name,
             const std::vector<Number> &values,
             unsigned int n_components = 1,
             const std::string &unit = "");

    /// Sets the simulated time [s], "TimeValue" in the field data.
    void set_time(double time);

    /// Adds to the field data what the integers in an array stand for, by
    /// fields whose names are "tissue 4: brain": readers other than ParaView
    /// refuse arrays of texts.
    void add_names(const std::string &array,
                   const std::vector<std::string> &names);

    /// @throws SystemError
    void write(const std::string &file) const;

  private:
    void add_bytes(const std::string &section,
                   const std::string &attributes,
                   const std::string &unit,
                   const unsigned char *data,
                   std::size_t n_bytes);

    std::string type_;
    std::string grid_attributes_;
    std::string piece_attributes_;
    std::string field_data_;
    std::string section_;
    std::vector<std::string> content_; ///< of the piece
  };

  /// VTK cell types of linear hexahedra and quadrilaterals.
  inline constexpr unsigned char vtk_hexahedron = 12;
  inline constexpr unsigned char vtk_quadrilateral = 9;
} // namespace io
} // namespace contrecoup
