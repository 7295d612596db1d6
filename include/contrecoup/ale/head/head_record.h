// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/ale/lagrange/contact_record.h>
#include <contrecoup/ale/lagrange/region_extremes.h>
#include <contrecoup/ale/mesh/region.h>
#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/numerics/injury/own_thresholds.h>
#include <contrecoup/solid/injury/brain_record.h>
#include <contrecoup/solid/motion/mean_motion.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/// Processes that continue when a run ends, so that records may still grow.
struct RunEnd
{
  bool contact_lasts = false;
  bool tension_grows = false; ///< of a liquid
};

/**
 * Injury measures of a head, from strain and pressure in the brain, and from
 * the motion of the skull, or of the brain in a mesh without skull. Subsection
 * "Injury". Holds the part that does not depend on the method: which regions
 * count, and their records. With symmetry planes, the measures are those of the
 * whole head: velocities normal to the planes are zero, and rotation is about
 * the normal of one plane.
 */
class HeadRecord
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /**
   * Finds brain and skull. @param planes of which the first one separates the
   * side of the coup from that of the contrecoup
   * @throws InputError if a name is unknown, or a region is no solid, and for
   * thresholds of a measure that is not taken of these regions
   */
  void find(const std::vector<Region> &regions,
            const std::vector<ContactPlane> &planes);

  /// @param steps of the run, approximately
  /// @throws InputError if only the start would be recorded
  void check_interval(const double steps) const;

  /// Whether there is a brain or a skull.
  bool active() const
  {
    return brain_ != none || skull_ != none;
  }

  bool has_brain() const
  {
    return brain_ != none;
  }

  /// Thresholds that are not the published ones.
  const OwnThresholds &own_thresholds() const
  {
    return own_;
  }

  /// Processes that continue at @p time [s], by the records until then.
  RunEnd end_at(const double time,
                const ContactRecord &contact,
                const ExtremeRecord &extremes) const;

  /// Measures recorded so far: lower limits by @p end, and those that
  /// brain_measures() and head_motion_measures() mark. Collective.
  std::vector<solid::InjuryMeasure> measures(const MPI_Comm communicator,
                                             const RunEnd &end = {}) const;

  /// Largest pressure in the half of the brain at the first plane (coup) and
  /// least one in the other half (contrecoup), with their times, and which of
  /// them are lower limits, as these are at the end or continue by @p end;
  /// empty without brain or plane. Collective.
  std::vector<NamedValue> coup(const MPI_Comm communicator,
                               const RunEnd &end = {}) const;

  /// Which pressures of the brain are recorded, as "of single cells".
  /// @param is_smoothed whether averages differ from the pressures themselves
  std::string pressures_in_words(const bool is_smoothed) const;

  /// Writes injury.csv into the output folder, if active(). Collective.
  void write(const std::string &folder,
             const MPI_Comm communicator,
             const RunEnd &end) const;

  /// coup() and measures(), for "results" in summary.json. Collective.
  std::vector<NamedValue> results(const MPI_Comm communicator,
                                  const RunEnd &end) const;

  /// Saves this rank's record, or adds what a rank has saved after the regions
  /// were found. @throws InputError for a record of another scene
  void save_record(io::StateWriter &out) const;
  void restore_record(io::StateReader &in, const MPI_Comm communicator);

protected:
  static constexpr unsigned int none = -1;

  /// Counts a step; whether it is to be recorded.
  bool is_due()
  {
    return active() && record_.n_steps++ % interval_ == 0;
  }
  /// Whether this region moves as the head does, or is its brain.
  bool is_of_head(const unsigned int region) const
  {
    return region == moving_region() || region == brain_;
  }
  /// The region whose motion is that of the head.
  unsigned int moving_region() const
  {
    return skull_ != none ? skull_ : brain_;
  }
  /// Coordinate along the normal of the first plane [m].
  double height(const dealii::Tensor<1, 3> &place) const
  {
    return place * normal_;
  }

  /**
   * Records the pressures in the brain.
   * @param pressures of the elements or particles, in the order of the samples
   * @param averages over neighbours [Pa]; @p pressures where there are none
   * @param heights at the start, over that of the brain's centre [m]
   */
  void record_brain(const double time,
                    const std::vector<double> &pressures,
                    const std::vector<double> &averages,
                    const std::vector<double> &heights,
                    std::vector<solid::BrainSample> &samples);

  /**
   * Records the motion of the head. Collective.
   * @param moving point masses of the moving region
   * @param head these and those of the brain
   */
  void record_motion(const double time,
                     const MPI_Comm communicator,
                     solid::MeanMotion &moving,
                     solid::MeanMotion &head);

  unsigned int brain_ = none; ///< region number
  unsigned int skull_ = none;
  solid::BrainRecord record_;    ///< with velocities of moving_region()
  std::string object_ = "cells"; ///< whose pressures are recorded

private:
  /// A pressure and when it was reached; plain data for checkpoints.
  struct Extreme
  {
    double pressure = 0.; ///< [Pa]
    double time = 0.;     ///< [s]
  };

  OwnThresholds own_;
  std::string brain_name_, skull_name_;
  std::vector<std::size_t> liquids_; ///< region numbers
  bool averaged_ = true;             ///< pressures, over neighbours
  unsigned int interval_ = 10;
  SymmetryPlanes is_mirrored_{};
  dealii::Tensor<1, 3> normal_;       ///< of the first plane; 0: no plane
  std::array<Extreme, 2> extremes_{}; ///< coup, contrecoup; of this rank
};
} // namespace contrecoup::ale
