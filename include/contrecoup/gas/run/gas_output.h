// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/io/field_output.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// The gas at one time, and where output of it goes.
template <int dim>
struct GasSnapshot
{
  const std::string &folder; ///< that takes the files
  unsigned int index;        ///< number of the output
  double time;               ///< [s]
  const LeafMesh<dim> &mesh;
  const LeafPoints<dim> &points;
  const GasField &field;
  const GasMaterial &material;
  const BlastMaps<dim> &maps; ///< may be empty
};

/// What is written at each output tick, as subsection "Pictures" says
/// beyond the fields themselves.
template <int dim>
class GasOutput
{
public:
  /// Declares subsection "Pictures" and what concerns fields in "Output".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for planes that the mesh does not have.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const CoarseMesh<dim> &mesh);

  /// Adds the burned fraction of explosive to the fields.
  void show_burned()
  {
    shows_burned_ = true;
  }

  /**
   * Writes density, velocity, pressure, level, sensor, the open fraction
   * beside a body and, unless they are empty, the maps of all leaves as VTU,
   * unless planes are enough, and the planes as arrays; planes of maps replace
   * those of earlier outputs. Collective.
   * @return the file for the .pvd collection; empty: none
   */
  std::string write(const GasSnapshot<dim> &gas) const;

  /// Whether "Output/Maps" asks for maps.
  bool wants_maps() const
  {
    return wants_maps_;
  }

private:
  struct Plane
  {
    unsigned int direction;
    double position; ///< [m]
  };

  std::vector<io::FieldName> field_names(const GasSnapshot<dim> &gas) const;
  std::string write_leaves(const GasSnapshot<dim> &gas) const;
  void write_plane(const Plane &plane, const GasSnapshot<dim> &gas) const;

  bool wants_maps_ = false;
  bool wants_volume_ = true;
  std::vector<Plane> planes_;
  bool shows_burned_ = false;
  unsigned int resolution_ = 256;
};
} // namespace contrecoup::gas
