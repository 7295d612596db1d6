// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/io/output/field_output.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// What is written at each output tick, as subsection "Pictures" says
/// beyond the fields themselves.
template <int dim>
class GasOutput
{
public:
  /// Where the files of an output go.
  struct Target
  {
    std::string folder;
    unsigned int index; ///< number of the output
  };

  /// Declares subsection "Pictures" and what concerns fields in "Output".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for planes that the mesh does not have.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const CoarseMesh<dim> &mesh);

  /**
   * Writes density, velocity, pressure, level, sensor, the burned fraction of
   * explosive, the open fraction beside a body and, unless they are empty, the
   * maps of all leaves as VTU, unless planes are enough, and the planes as
   * arrays; planes of maps replace those of earlier outputs. Collective.
   * @return the file for the .pvd collection; empty: none
   */
  std::string write(const GasSnapshot<dim> &gas,
                    const BlastMaps<dim> &maps,
                    const Target &target) const;

private:
  struct Plane
  {
    unsigned int direction;
    double position; ///< [m]
  };

  std::vector<io::FieldName> field_names(const GasSnapshot<dim> &gas,
                                         const bool has_maps) const;
  std::string write_leaves(const GasSnapshot<dim> &gas,
                           const BlastMaps<dim> &maps,
                           const Target &target) const;
  void write_plane(const Plane &plane,
                   const GasSnapshot<dim> &gas,
                   const BlastMaps<dim> &maps,
                   const Target &target) const;

  bool wants_volume_ = true;
  std::vector<Plane> planes_;
  unsigned int resolution_ = 256;
};
} // namespace contrecoup::gas
