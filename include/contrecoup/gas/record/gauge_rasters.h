// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/point_sampler.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Gauges on lines and planes that stand still while the mesh adapts: each
 * follows peak overpressure, impulse, arrival and duration, see BlastRecord.
 * They are read in every step without communication; the result depends
 * neither on the number of ranks nor on when the mesh was adapted, except
 * through the gas itself.
 */
template <int dim>
class GaugeRasters
{
public:
  /// Declares entries of subsection "Probes".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a text that cannot be read and for gauges
  /// outside the box @p mesh.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const CoarseMesh<dim> &mesh);

  bool empty() const
  {
    return places_.empty();
  }

  /// The pressures before anything happens [Pa], from the initial state.
  void set_ambient(const InitialState<dim> &initial_state);

  /// Call when the mesh changed. Collective.
  void reinit(const LeafMesh<dim> &mesh, const LeafPoints<dim> &points);

  /// Takes the state at the end @p time of a step, both [s].
  void add(const GasField &field,
           const GasMaterial &material,
           const double time,
           const double step);

  /// Sets the records of all gauges for which @p record has one.
  void set_records(const std::function<std::optional<BlastRecord<double>>(
                     const dealii::Point<dim> &)> &record);

  /// Gives every rank the records of all gauges. Collective.
  void share();

  /// The records, for checkpoints; call share() before save().
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

  /**
   * Writes the measures at @p time [s]: lines as gauges_line_N.csv, planes as
   * gauges_plane_N_QUANTITY.npy. Call share() before, and on one rank alone.
   * @throws SystemError when the disk is full
   */
  void write(const std::string &folder, const double time) const;

private:
  using Record = BlastRecord<double>;

  /// A line (second count 0) or a plane of gauges.
  struct Raster
  {
    dealii::Point<dim> begin, end;
    std::array<unsigned int, 2> axes;   ///< of a plane
    std::array<unsigned int, 2> counts; ///< along the line or the axes
    std::size_t first;                  ///< gauge
  };

  void parse_list(const std::string &entry,
                  const std::string &text,
                  const unsigned int n_counts);
  void add_gauges(Raster raster);
  void write_line(const std::string &file,
                  const Raster &raster,
                  const double time) const;
  void write_plane(const std::string &stem,
                   const Raster &raster,
                   const double time) const;

  std::vector<Raster> rasters_;
  std::vector<dealii::Point<dim>> places_;
  std::vector<double> ambient_; ///< [Pa]
  std::vector<Record> records_;
  PointSampler<dim> sampler_;
  MPI_Comm communicator_ = MPI_COMM_SELF;
  bool is_shared_ = true; ///< whether every rank has all records
};
} // namespace contrecoup::gas
