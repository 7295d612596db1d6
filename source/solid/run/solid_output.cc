// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/tissues.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/vtk_file.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_average.h>
#include <contrecoup/solid/run/solid_output.h>

namespace contrecoup::solid
{
namespace
{
  /// Names and units.
  using Names = std::vector<std::pair<std::string, std::string>>;
  const Names vector_names{{"displacement", "m"}, {"velocity", "m/s"}};
  const Names cell_names{{"pressure", "Pa"},
                         {"averaged_pressure", "Pa"},
                         {"von_mises_stress", "Pa"},
                         {"principal_strain", "-"}};

  template <typename Real>
  void add_points(io::VtkFile &file, const SolidBody<Real> &body)
  {
    const SolidMesh &mesh = body.mesh();
    std::vector<float> points;
    points.reserve(3 * mesh.nodes.size());
    for (const auto &node : mesh.nodes)
      for (unsigned int d = 0; d < 3; ++d)
        points.push_back(static_cast<float>(node[d]));
    file.add("Points", "points", points, 3, "m");
    std::vector<std::uint32_t> corners;
    corners.reserve(8 * mesh.elements.size());
    for (const HexMesh::Cell &cell : mesh.elements)
      corners.insert(corners.end(), cell.begin(), cell.end());
    file.add("Cells", "connectivity", corners);
    std::vector<std::int64_t> offsets(mesh.elements.size());
    for (std::size_t i = 0; i < offsets.size(); ++i)
      offsets[i] = 8 * static_cast<std::int64_t>(i + 1);
    file.add("Cells", "offsets", offsets);
    file.add("Cells",
             "types",
             std::vector<unsigned char>(offsets.size(), io::vtk_hexahedron));
  }

  template <typename Real>
  void add_fields(io::VtkFile &file, const SolidBody<Real> &body)
  {
    const SolidMesh &mesh = body.mesh();
    std::vector<float> displacement, velocity;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
      {
        displacement.push_back(float(body.nodes().displacement_of(i)[d]));
        velocity.push_back(float(body.nodes().velocity_of(i)[d]));
      }
    const std::vector<float> *const vectors[] = {&displacement, &velocity};
    for (unsigned int k = 0; k < 2; ++k)
      file.add("PointData",
               vector_names[k].first,
               *vectors[k],
               3,
               vector_names[k].second);
    std::vector<unsigned char> tissue;
    for (const unsigned char index : mesh.tissue)
      tissue.push_back(static_cast<unsigned char>(mesh.tissues[index]));
    file.add("CellData", "tissue", tissue);
    std::vector<std::vector<float>> values(
      cell_names.size(), std::vector<float>(mesh.elements.size()));
    body.elements().visit(
      body.nodes(),
      body.times(),
      [&](const std::uint32_t cell, const ElementValues &element) {
        values[0][cell] = static_cast<float>(pressure_of(element.stress));
        values[2][cell] = static_cast<float>(von_mises(element.stress));
        values[3][cell] = static_cast<float>(largest_principal(element.strain));
      });
    for (unsigned int tissue = 0; tissue < mesh.tissues.size(); ++tissue)
    {
      TissueAverage average;
      average.reinit(mesh, body.exchange(), tissue);
      std::vector<double> pressures;
      for (const std::uint32_t cell : average.elements())
        pressures.push_back(values[0][cell]);
      pressures = average.average(pressures);
      for (std::size_t i = 0; i < pressures.size(); ++i)
        values[1][average.elements()[i]] = static_cast<float>(pressures[i]);
    }
    for (std::size_t k = 0; k < cell_names.size(); ++k)
      file.add(
        "CellData", cell_names[k].first, values[k], 1, cell_names[k].second);
  }

  /// Writes the .pvtu file, which names the pieces of all ranks.
  void write_master(const std::string &name,
                    const std::vector<std::string> &pieces,
                    const Names &fields)
  {
    io::write_file(name, [&](std::ostream &out) {
      const auto array = [&](const std::string &type,
                             const std::string &field,
                             const unsigned int n_components,
                             const std::string &unit) {
        out << "<PDataArray type=\"" << type << "\" Name=\"" << field
            << "\" NumberOfComponents=\"" << n_components << "\">";
        if (!unit.empty())
          out << "<InformationKey name=\"UNITS_LABEL\" "
                 "location=\"vtkDataArray\">"
              << unit << "</InformationKey>";
        out << "</PDataArray>\n";
      };
      out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" "
             "version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\" "
             "compressor=\"vtkZLibDataCompressor\">\n<PUnstructuredGrid "
             "GhostLevel=\"0\">\n<PPoints>\n";
      array("Float32", "points", 3, "m");
      out << "</PPoints>\n<PPointData>\n";
      for (const auto &field : vector_names)
        array("Float32", field.first, 3, field.second);
      out << "</PPointData>\n<PCellData>\n";
      array("UInt8", "tissue", 1, "");
      for (const auto &field : fields)
        array("Float32", field.first, 1, field.second);
      out << "</PCellData>\n";
      for (const std::string &piece : pieces)
        out << "<Piece Source=\"" << piece << "\"/>\n";
      out << "</PUnstructuredGrid>\n</VTKFile>\n";
    });
  }
} // namespace


template <typename Real>
std::string write_solid(const SolidBody<Real> &body,
                        const PeakFields<Real> &peaks,
                        const std::string &folder,
                        const unsigned int index)
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(body.communicator());
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(body.communicator());
  const std::string stem =
    "solid_" + dealii::Utilities::int_to_string(index, 4);
  const auto piece = [&](const unsigned int number) {
    return stem +
           (n_ranks == 1 ? ""
                         : "." + dealii::Utilities::int_to_string(number, 4)) +
           ".vtu";
  };
  const std::string sizes =
    "NumberOfPoints=\"" + std::to_string(body.mesh().nodes.size()) +
    "\" NumberOfCells=\"" + std::to_string(body.mesh().elements.size()) + "\"";
  io::VtkFile file("UnstructuredGrid", "", sizes);
  file.add_names("tissue", tissue_names());
  add_points(file, body);
  add_fields(file, body);
  Names fields = cell_names;
  if (peaks.active())
    for (unsigned int k = 0; k < peaks.n_fields; ++k)
    {
      file.add("CellData", peaks.names[k], peaks.field(k), 1, peaks.units[k]);
      fields.emplace_back(peaks.names[k], peaks.units[k]);
    }
  file.write(folder + "/" + piece(rank));
  if (n_ranks == 1)
    return piece(0);
  std::vector<std::string> pieces;
  for (unsigned int i = 0; i < n_ranks; ++i)
    pieces.push_back(piece(i));
  if (rank == 0)
    write_master(folder + "/" + stem + ".pvtu", pieces, fields);
  return stem + ".pvtu";
}


template std::string write_solid(const SolidBody<double> &,
                                 const PeakFields<double> &,
                                 const std::string &,
                                 unsigned int);
template std::string write_solid(const SolidBody<float> &,
                                 const PeakFields<float> &,
                                 const std::string &,
                                 unsigned int);
} // namespace contrecoup::solid
