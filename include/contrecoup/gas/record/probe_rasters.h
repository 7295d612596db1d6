// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/blast_probes.h>

namespace contrecoup::gas
{
/**
 * Probes on lines and planes at fixed positions, independent of mesh
 * adaptation: peak overpressure, impulse, arrival and duration at each, see
 * BlastRecord, and where "Probes/Injury" asks for them the injuries of people
 * there, see mapped_injury_values(). Reading them in every step needs no
 * communication. The result does not depend on the number of ranks.
 */
template <int dim>
class ProbeRasters : public Recorder<dim>
{
public:
  /// Declares entries of subsection "Probes".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for text that cannot be parsed, for probes outside of
  /// the domain, for a line or plane that lies in the body, and for injuries
  /// that are asked for without probes.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasScene<dim> &scene) override;

  void mesh_changed(const GasSnapshot<dim> &gas) override;
  /// Takes no records after take(), which has recorded all that came before.
  void inherit(const KnownRecord<dim> &record,
               const GasSnapshot<dim> &gas) override;
  void add_step(const GasSnapshot<dim> &gas) override;

  /// Positions of all probes [m].
  const std::vector<dealii::Point<dim>> &places() const
  {
    return probes_.places();
  }

  /// Records the state at probe @p i at the end @p time of a step [s] that was
  /// sampled elsewhere, equal on all ranks.
  void take(const std::size_t i,
            const GasState<dim> &state,
            const double time,
            const double step)
  {
    probes_.add(i, state, time, step);
    is_taken_ = true;
  }

  /// Writes lines as gauges_line_N.csv and planes as gauges_plane_N.vti.
  /// @throws SystemError when the disk is full
  void write(const GasSnapshot<dim> &gas, const std::string &folder) override;

  void reduce_over_ranks() override;
  /// Gaps of probes with injuries; the others' maps show them.
  std::vector<std::string> gaps(const double time) const override;
  /// Says at how many probes nothing is known of lungs.
  void finish() override;
  void save(std::ostream &stream, const std::string &folder) const override;
  void load(std::istream &stream, const std::string &folder) override;

private:
  /// A line of probes (second count 0) or a plane of probes.
  struct Raster
  {
    dealii::Point<dim> begin, end;
    std::array<unsigned int, 2> axes;   ///< of a plane
    std::array<unsigned int, 2> counts; ///< along the line or the axes
    std::size_t first;                  ///< number of its first probe

    std::vector<dealii::Point<dim>> places() const;
  };

  void parse_list(const std::string &entry,
                  const std::string &text,
                  const unsigned int n_counts,
                  const RigidBody &body,
                  std::vector<dealii::Point<dim>> &places);
  bool has_injuries() const
  {
    return probes_.exposure() != Exposure::none;
  }
  /// Whether the peak of the blast has come to probe @p i at the end of the
  /// last step, but may grow further; asked where injuries are.
  bool is_rising(const std::size_t i) const
  {
    const BlastRecord<double> &record = probes_.records()[i];
    return has_injuries() && record.arrival < 0. &&
           probes_.exposures()[i].last >= record.peak;
  }
  /// Names and units of values().
  std::vector<std::pair<std::string, std::string>> quantities() const;
  /// Known values of probe @p i at @p time [s]; others are not a number.
  std::vector<double> values(const std::size_t i, const double time) const;
  void write_line(const std::string &file,
                  const Raster &raster,
                  const double time) const;
  void write_plane(const std::string &file,
                   const Raster &raster,
                   const double time) const;

  double body_mass_ = 0.; ///< [kg]
  std::vector<Raster> rasters_;
  std::vector<bool> is_in_body_; ///< whether each probe is, without gas
  BlastProbes<dim> probes_;
  MPI_Comm communicator_ = MPI_COMM_SELF;
  bool is_shared_ = true; ///< whether every rank has all records
  bool is_taken_ = false; ///< whether take() was called
};
} // namespace contrecoup::gas
