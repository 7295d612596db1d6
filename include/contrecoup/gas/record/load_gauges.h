// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/state/wave_peaks.h>
#include <contrecoup/io/output/history.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Gauges on a rigid body: its landmarks and the positions of "Loads/Gauges".
 * Each gauge reads the area-weighted mean overpressure over a patch of the
 * surface: the facets with centroids within "Loads/Gauge radius" whose normals
 * point to the same side, or the nearest facet if there is none.
 *
 * Histories go to load_gauges.csv, as means over the samples of the loads;
 * peak, arrival, impulse and positive phase, from every time step, to
 * gauge_measures.csv; injuries by both to gauge_injury.csv.
 */
class LoadGauges
{
public:
  /// Declares entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads these entries, and keeps the landmarks of the body that lie in the
  /// box from @p lower to @p upper; in 2-D those in the plane z = 0.
  /// @param cell edge of the subcells at the body [m]
  /// @throws InputError for text that defines no gauges, positions outside of
  /// the box or farther from the surface of the body than the radius of a gauge
  /// and two cells, and equal names.
  template <int dim>
  void parse_parameters(dealii::ParameterHandler &prm,
                        const RigidBody &body,
                        const dealii::Point<dim> &lower,
                        const dealii::Point<dim> &upper,
                        const double cell);

  void set_folder(const std::string &folder)
  {
    folder_ = folder;
  }

  /// Finds the facets of each patch.
  /// @param geometry of the facets of all ranks: centroid [m] and area vector
  /// into the body [m^2], six numbers each
  /// @param owned numbers of the facets whose pressure is computed on this rank
  void reinit(const std::vector<double> &geometry,
              const std::vector<std::size_t> &owned);

  /// Contributions of the facets of this rank to the overpressures of all
  /// gauges [Pa].
  /// @param overpressure function from facet number to overpressure [Pa]
  template <typename Function>
  std::vector<double> partial_sums(const Function &overpressure) const
  {
    std::vector<double> sums(places_.size(), 0.);
    for (const Contribution &contribution : contributions_)
      sums[contribution.gauge] +=
        contribution.weight * overpressure(contribution.facet);
    return sums;
  }

  /// Adds the last overpressures to the current sample, until the middle of a
  /// step.
  void begin_step(const double step);

  /// Adds the overpressures of all gauges at the end of this step [Pa].
  /// @param smallest overpressure below which no blast has arrived [Pa]
  void add(const std::vector<double> &overpressures,
           const double time,
           const double step,
           const double smallest);

  /// Completes a sample of length @p duration [s].
  /// @param writes whether this rank writes the file
  void end_sample(const double time, const double duration, const bool writes);

  /// Largest part of a gauge's peak that its samples miss [-].
  double largest_peak_loss() const;

  /// Writes buffered samples to the file. @throws SystemError
  void flush();

  /// Writes gauge_measures.csv and, with a gauge at chest, back or ear,
  /// gauge_injury.csv, see gauge_tables.h, for the blast until @p time [s].
  /// Call after flush(), on the rank that writes.
  /// @throws SystemError
  void write_tables(const double time) const;

  /// Writes and reads the record of a checkpoint; call flush() before save().
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

  /// Peak, its time, arrival, positive impulse and phase at each gauge, and the
  /// peak of the first wave there.
  std::vector<NamedValue> measures(const double time) const;

  /// The same as a text table, one line per row.
  std::vector<std::string> table(const double time) const;

  /// Gauges whose record is not whole at @p time [s], see RecordGaps.
  std::vector<std::string> gaps(const double time) const;

  std::vector<std::string> names() const;

  /// Overpressures after the last step, in the order of names() [Pa].
  std::vector<double> overpressures() const;

  /// The gauges in the syntax of entry "Loads/Gauges".
  std::string description() const;

private:
  struct Place
  {
    std::string name;
    dealii::Point<3> point;      ///< on the surface [m]
    dealii::Tensor<1, 3> normal; ///< out of the body [-]
  };
  /// Contribution of a facet to a gauge.
  struct Contribution
  {
    std::size_t facet;
    unsigned int gauge;
    double weight; ///< [-]
  };
  struct Record
  {
    BlastRecord<double> blast;
    WavePeaks peaks;
    double peak_time = 0.;   ///< [s]
    double last = 0.;        ///< overpressure at the end of the last step [Pa]
    double sum = 0.;         ///< time integral over the current sample [Pa s]
    double sample_peak = 0.; ///< largest sample [Pa]
  };

  void add_place(const std::string &name,
                 const dealii::Point<3> &point,
                 const RigidBody &body);
  /// Returns the distance of the nearest facet of the gauge's side [m].
  double find_patch(const unsigned int gauge,
                    const std::vector<double> &geometry,
                    std::vector<Contribution> &contributions) const;
  void open_file();

  double radius_ = 0.;    ///< of patches [m]
  double diagonal_ = 0.;  ///< of the largest cells at the body; 0: no warnings
  double body_mass_ = 0.; ///< [kg]
  std::vector<Place> places_;
  std::vector<std::size_t> patch_sizes_;    ///< number of facets of each
  std::vector<Contribution> contributions_; ///< of this rank
  std::vector<Record> records_;             ///< the same on all ranks

  std::string folder_;
  std::unique_ptr<io::HistoryFile> file_; ///< created with the first row
  std::uint64_t file_size_ = 0;           ///< at the last checkpoint [byte]
};
} // namespace contrecoup::gas
