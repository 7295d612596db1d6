// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/record/load_gauges.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>
#include <contrecoup/materials/gas_material.h>
#include <contrecoup/numerics/riemann_flux.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * The pressure of the gas on a rigid body, recorded as the run goes. The
 * facets are the pieces of the surface in the cells that it cuts; the pressure
 * on one is that of the Riemann problem between the gas in its cell and the
 * mirror image. Written to loads.h5, see io::LoadFile, and at named places to
 * load_gauges.csv, see LoadGauges, from when the wave arrives at the first
 * facet: the first sample is the mean of all time before.
 *
 * Audits itself: force and impulse of all facets against what the scheme took
 * from the gas. A staircase's facets take one pressure for all sides of a cell
 * together, and so differ by some per cent from its scheme.
 */
template <int dim>
class WallLoads
{
public:
  /// Declares subsection "Loads".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when there is no body to record the loads of, and
  /// for gauges that are not on it.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const RigidBody &body,
                        const CoarseMesh<dim> &domain);

  bool active() const
  {
    return active_;
  }

  /// @param pressure ambient [Pa]
  void set_ambient(const double pressure)
  {
    ambient_ = pressure;
  }
  void set_folder(const std::string &folder)
  {
    file_ = folder + "/loads.h5";
    gauges_.set_folder(folder);
  }

  /// Finds the facets. Call when the mesh changed. Collective.
  void reinit(const LeafMesh<dim> &mesh,
              const LeafLayout &layout,
              const CutLeaves<dim> &cut_leaves,
              const RigidBody &body);

  /// Takes the state at the end of a step. Collective.
  /// @param wall_force of the step, see TimeStepper::Result
  void add(const GasField &field,
           const GasMaterial &material,
           const RiemannFlux flux,
           const double time,
           const double step,
           const QuietLeaves<dim> &quiet_leaves,
           const std::array<double, 6> &wall_force);

  /// Writes what is still in memory, or forgets it where there is no folder.
  /// Collective.
  void flush();

  /// Ends the sample that is going on, and flushes. Collective.
  void finish();

  /// What is known so far, for checkpoints; call flush() before save().
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

  /// Keeps loads.h5 in the folder of a checkpoint, and brings it back after
  /// load(): a run that was killed may have left it half-written. By one rank.
  void save_file(const std::string &folder) const;
  void restore_file(const std::string &folder) const;

  /// Number and area of the facets, impulses and the audit, and what the
  /// gauges say.
  std::vector<NamedValue> audit() const;

  /// What the gauges say, for people; empty without loads.
  std::vector<std::string> table() const
  {
    return active_ ? gauges_.table(totals_.time) : std::vector<std::string>();
  }

private:
  static constexpr unsigned int n_geometry = 6; ///< numbers of a facet

  /// Peaks below this part of the highest do not count for the samples.
  static constexpr double counted_part = 0.05;

  /// A facet in the leaves of this rank.
  struct Facet
  {
    unsigned int leaf;
    unsigned int point;
    std::size_t number;          ///< among those of all ranks
    dealii::Tensor<1, dim> area; ///< vector, into the body [m^(dim-1)]
  };
  /// What is known of a facet.
  struct Record
  {
    BlastRecord<double> blast;
    double sum = 0.;         ///< integral of the sample that is going on [Pa s]
    double last = 0.;        ///< overpressure at the end of the last step [Pa]
    double sample_peak = 0.; ///< largest sample so far [Pa]
  };
  /// The whole run so far.
  struct Totals
  {
    double sample_begin = -1.;          ///< [s]; below 0: nothing arrived yet
    double n_times = 0.;                ///< that the file has
    dealii::Tensor<1, 3> facet_impulse; ///< [N s]
    dealii::Tensor<1, 3> gas_impulse;   ///< [N s]
    double largest_force = 0.;          ///< [N]
    double largest_difference = 0.;     ///< between facets and gas [N]
    double time = 0.;                   ///< [s]
    /// Largest part of a facet's peak that no sample shows, among those with
    /// a twentieth of the highest peak at least [-].
    double peak_loss = 0.;
    double highest = 0.; ///< overpressure so far [Pa]
  };

  /// Makes every rank know the records of all facets. Collective.
  void share();
  /// A number that tells the cell around a place apart from all others.
  static std::uint64_t key_of(const dealii::Point<dim> &place,
                              const CoarseMesh<dim> &domain);
  void add_facets(const unsigned int leaf,
                  const LeafMesh<dim> &mesh,
                  const LeafLayout &layout,
                  const CutLeaves<dim> &cut_leaves,
                  const RigidBody &body,
                  std::vector<std::uint64_t> &keys,
                  std::vector<double> &geometry);
  void number_facets(const std::vector<std::uint64_t> &keys,
                     const std::vector<double> &geometry);
  void add_gauges(const double time, const double step);
  template <typename Gas>
  double wall_pressure(const Facet &facet,
                       const GasField &field,
                       const Gas &gas,
                       const RiemannFlux flux) const;
  void add_forces(const dealii::Tensor<1, 3> &facet_force,
                  const std::array<double, 6> &wall_force,
                  const double step);
  /// Whether a facet's peak would be lost in the sample that is going on if
  /// it took the step with the present pressures. Collective.
  bool loses_peaks(const double time, const double step);
  /// Whether no facet has met the wave yet.
  bool is_waiting() const
  {
    return totals_.sample_begin < 0.;
  }
  /// Whether some facet's pressure now tells it. Collective.
  bool has_arrived() const;
  /// Writes what was before the step that begins at @p time.
  void begin_samples(const double time, const double step);
  void end_sample(const double time);
  void create_file() const;
  void write_measures();

  bool active_ = false;
  double interval_ = 0.;     ///< of samples [s]; 0: every step
  double largest_loss_ = 1.; ///< of a peak in samples [-]
  double smallest_ = 0.;     ///< overpressure over ambient that counts [-]
  double ambient_ = 0.;      ///< [Pa]
  std::string file_;
  MPI_Comm communicator_ = MPI_COMM_SELF;

  std::vector<std::uint64_t> keys_; ///< places of all facets, in order
  std::vector<double> geometry_;    ///< of all: centroid and area vector
  std::vector<Facet> facets_;       ///< of this rank
  std::vector<double> pressures_;   ///< on this rank's, after the step [Pa]
  std::vector<Record> records_;     ///< of all; up to date for this rank's
  LoadGauges gauges_;
  Totals totals_;
  std::vector<double> times_;  ///< not yet in the file [s]
  std::vector<float> samples_; ///< [time][facet], zero for other ranks' [Pa]
};
} // namespace contrecoup::gas
