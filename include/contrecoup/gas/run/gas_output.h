// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/io/file/plane_file.h>
#include <contrecoup/io/output/field_output.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Writes the field output of a run: all leaves as VTU, and the planes of
/// subsection "Pictures" as VTK images.
template <int dim>
class GasOutput
{
public:
  /// Folder and number of an output.
  struct Target
  {
    std::string folder;
    unsigned int index; ///< number of the output
  };

  /// Declares subsection "Pictures" and the entries on fields of "Output".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for planes outside of the mesh.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const CoarseMesh<dim> &mesh);

  /**
   * Writes density, velocity, pressure, refinement level, sensor, burned
   * fraction of explosive, open fraction around a body and, unless they are
   * empty, maps of all leaves as VTU (if volume fields are requested), and the
   * planes as images: pressure and density, and the maps in a file of their
   * own, which replaces that of earlier outputs. Collective.
   * @return the files for the .pvd collection
   */
  std::vector<FieldFile> write(const GasSnapshot<dim> &gas,
                               const BlastMaps<dim> &maps,
                               const Target &target) const;

private:
  struct Plane
  {
    unsigned int direction;
    double position; ///< [m]
  };

  /// Name of a plane, and the samples of its files; without maps, maps has no
  /// fields.
  struct PlaneFiles
  {
    FieldFile file;
    std::string stem;
    io::PlaneSamples gas;
    io::PlaneSamples maps;
  };

  std::vector<io::FieldName> field_names(const GasSnapshot<dim> &gas,
                                         const bool has_maps) const;
  std::string write_leaves(const GasSnapshot<dim> &gas,
                           const BlastMaps<dim> &maps,
                           const Target &target) const;
  /// Contents of a plane's files, on the first rank. Collective.
  PlaneFiles sample_plane(const Plane &plane,
                          const GasSnapshot<dim> &gas,
                          const BlastMaps<dim> &maps,
                          const Target &target) const;

  bool wants_volume_ = true;
  std::vector<Plane> planes_;
  unsigned int resolution_ = 256;
};
} // namespace contrecoup::gas
