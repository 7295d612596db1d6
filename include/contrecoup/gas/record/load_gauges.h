// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/io/output/history.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Named places on a rigid body: its landmarks and those of "Loads/Gauges".
 * Each reads the mean overpressure, weighted by area, over a patch of the
 * surface: the facets with centroids within "Loads/Gauge radius" that look the
 * same way, or the nearest facet where there is none.
 *
 * Histories go to load_gauges.csv as means over the samples of the loads, and
 * what these would do to a chest or an ear to gauge_injury.csv; what the blast
 * did is found from every step.
 */
class LoadGauges
{
public:
  /// Declares entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads them, and keeps what of the body's landmarks is in the box from
  /// @p lower to @p upper; in 2-D what is in the plane z = 0.
  /// @throws InputError for text that names no places, places outside of the
  /// box, and equal names.
  template <int dim>
  void parse_parameters(dealii::ParameterHandler &prm,
                        const RigidBody &body,
                        const dealii::Point<dim> &lower,
                        const dealii::Point<dim> &upper);

  void set_folder(const std::string &folder)
  {
    folder_ = folder;
  }

  /// Finds the patches.
  /// @param geometry of all facets: centroid [m] and area vector into the
  /// body [m^2], six numbers each
  /// @param owned numbers of the facets that this rank knows the pressure of
  void reinit(const std::vector<double> &geometry,
              const std::vector<std::size_t> &owned);

  /// What this rank's facets add to the overpressures of all gauges.
  /// @param overpressure of a facet, given its number [Pa]
  template <typename Function>
  std::vector<double> partial_sums(const Function &overpressure) const
  {
    std::vector<double> sums(places_.size(), 0.);
    for (const Contribution &contribution : contributions_)
      sums[contribution.gauge] +=
        contribution.weight * overpressure(contribution.facet);
    return sums;
  }

  /// Takes the overpressures at the end of a step [Pa].
  /// @param smallest overpressure that counts [Pa]
  void add(const std::vector<double> &overpressures,
           const double time,
           const double step,
           const double smallest);

  /// Ends a sample of this duration [s].
  /// @param writes whether this rank writes the file
  void end_sample(const double time, const double duration, const bool writes);

  /// Writes what is still in memory. @throws SystemError
  void flush();

  /// Writes load_injury() of the whole histories as gauge_injury.csv, one row
  /// for each place. Call after flush(), on the rank that writes.
  /// @throws SystemError
  void write_injury() const;

  /// What is known so far, for checkpoints; call flush() before save().
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

  /// Peak, its time, arrival and positive impulse at each place.
  std::vector<NamedValue> measures(const double time) const;

  /// The same as a table for people.
  std::vector<std::string> table(const double time) const;

  /// The places as an entry "Loads/Gauges" would give them.
  std::string description() const;

private:
  struct Place
  {
    std::string name;
    dealii::Point<3> point;      ///< on the surface [m]
    dealii::Tensor<1, 3> normal; ///< out of the body [-]
  };
  /// What a facet adds to a gauge.
  struct Contribution
  {
    std::size_t facet;
    unsigned int gauge;
    double weight; ///< [-]
  };
  struct Record
  {
    BlastRecord<double> blast;
    double peak_time = 0.; ///< [s]
    double last = 0.;      ///< overpressure at the end of the last step [Pa]
    double sum = 0.;       ///< integral of the sample that is going on [Pa s]
  };

  void add_place(const std::string &name,
                 const dealii::Point<3> &point,
                 const RigidBody &body);
  void find_patch(const unsigned int gauge,
                  const std::vector<double> &geometry,
                  std::vector<Contribution> &contributions) const;
  void open_file();

  double radius_ = 0.;    ///< of patches [m]
  double body_mass_ = 0.; ///< [kg]
  std::vector<Place> places_;
  std::vector<std::size_t> patch_sizes_;    ///< facets of each
  std::vector<Contribution> contributions_; ///< of this rank
  std::vector<Record> records_;             ///< the same on all ranks

  std::string folder_;
  std::unique_ptr<io::HistoryFile> file_; ///< once a row was written
  std::uint64_t file_size_ = 0;           ///< that the checkpoint knows [byte]
};
} // namespace contrecoup::gas
