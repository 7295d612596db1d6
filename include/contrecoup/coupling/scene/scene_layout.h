// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/own_grid.h>
#include <contrecoup/coupling/scene/scene_parameters.h>
#include <contrecoup/geometry/shape/shape.h>
#include <contrecoup/numerics/injury/expected_blast.h>
#include <contrecoup/numerics/injury/incident_wave.h>

#include <array>
#include <optional>

namespace contrecoup::coupling
{
/**
 * Geometry of a scene: position of the charge, plane of symmetry, domain, and
 * the expected arrival of the blast; a calculation by hand before the run.
 */
struct SceneLayout
{
  /// Edge of coarse leaves [m]; a leaf has `subcells` subcells per edge. Those
  /// of a domain of the user are at most as large.
  static constexpr double leaf = 0.64;
  static constexpr unsigned int subcells = 4;
  /// Edge of the subcells of the 1-D stage [m].
  static constexpr double radial_cell = 0.001;
  /// Largest number of coarse leaves of a domain: hundreds of gigabytes of
  /// gas.
  static constexpr double max_leaves = 1e7;

  /**
   * Determines the position of the charge, the plane of symmetry, and a domain
   * so large that the time to first reflection from an open side (taken as a
   * mirror) at body and probe, and at gauges of the user within the domain, is
   * later than the end time. The front is that of
   * ExpectedBlast in free air.
   * @param surface surface of the body
   * @param unturned box of the same body before it was turned; that of
   * @p surface by default
   * @param own what the user chose; a corner may cut or widen the domain
   * @throws InputError for a charge that overlaps the body or the ground or is
   * closer to the skin than the subcells resolve, a body below ground or
   * thinner than a subcell, a requested symmetry that does not exist, a lower
   * side that is not where ground or plane of symmetry are, and times and
   * distances that need more than max_leaves leaves
   */
  SceneLayout(const SceneParameters &scene,
              const Shape &surface,
              const std::optional<dealii::BoundingBox<3>> &unturned = {},
              const OwnGrid &own = {});

  static constexpr double air_pressure = 101325.; ///< [Pa]
  static constexpr double air_density = 1.225;    ///< [kg/m^3]
  static constexpr double sound_speed = 340.;     ///< of air [m/s]

  /// Most refinement levels beyond those of the preset.
  static constexpr unsigned int max_extra_levels = 2;

  /// Least cells of the gas along the body's shortest side. With 3.7, those of
  /// 40 mm next to a head, elements got 1.4 times the impulse of the gas.
  static constexpr double least_cells_across = 6.;

  dealii::BoundingBox<3> body;
  /// Box of the body before it was turned, whose sides are the body's own.
  dealii::BoundingBox<3> unturned;
  dealii::Point<3> charge; ///< centre of the charge [m]
  double charge_radius;    ///< [m]
  /// Whether charge and ground make one wave: see IncidentWave.
  bool is_surface_burst;
  /// From the charge's centre to the nearest point of the skin [m]
  double distance;
  dealii::Point<3> nearest_skin; ///< the nearest point of the skin [m]
  /// From the charge's centre to the skin along -x [m]; NaN where that line
  /// misses the body
  double distance_along_x;
  double asymmetry; ///< of the body about y = 0 [m]
  /// Largest asymmetry for which only half of the gas is computed: a hundredth
  /// of the body's width, less than the natural asymmetry of persons [m].
  double symmetry_limit;
  bool is_half; ///< whether only y > 0 is computed
  /// Arrival of the front of a point source at the body, earlier than that of
  /// a charge [s]
  double earliest_arrival;
  /// Expected arrival of the front at the body [s] and its overpressure [Pa]:
  /// see IncidentWave.
  double arrival, overpressure;
  /// Time when the ground reflection has passed the body, and the incident wave
  /// all gauges() [s]
  double last_arrival;
  double positive_phase; ///< expected_phase() at the body [s]
  /// Refinement levels at the skin and of fronts near the body: those of the
  /// preset, both raised until the positive phase has the cells it asks for,
  /// and the body those of least_cells_across.
  unsigned int levels, front_levels;
  /// Largest distance of the front at the end time: that of a charge on the
  /// ground [m].
  double front_distance;
  /// Probe of the wave in the air next to the body, at the body's distance from
  /// the charge and as high as the charge, beside a charge on the ground as
  /// high as the body's middle; none where the charge or sides are too near.
  std::optional<dealii::Point<3>> probe;
  dealii::Point<3> lower, upper; ///< corners of the domain [m]
  std::array<unsigned int, 3> n_leaves;
  double leaf_edge = leaf; ///< longest edge of the coarse leaves [m]

  /// The charge's wave as known beforehand, on the ground or in free air.
  IncidentWave incident_wave(const SceneParameters &scene) const;

  /// The point source of the charge's energy, as it spreads on the ground or in
  /// free air.
  ExpectedBlast point_source(const SceneParameters &scene) const;

  /// Earliest arrival of the front at a place from the charge's image behind an
  /// open side; the front may have merged with its reflection by the ground
  /// [s].
  double earliest_return(const SceneParameters &scene,
                         const dealii::Point<3> &image,
                         const dealii::Point<3> &place) const;

  /// Where the wave in the air is asked for: by the user, and at the probe.
  std::vector<GaugeRaster> gauges(const SceneParameters &scene) const;

  /// Positive phase of the model's incident wave at a distance [m]: by Kingery
  /// and Bulmash at the nearest distance that they cover, and by what
  /// model_bias() knows there [s].
  double expected_phase(const SceneParameters &scene, double way) const;

  /// Area of the body's box across the line from the charge to the nearest
  /// skin, of sides of at most twice the distance [m^2].
  double seen_area() const;

  /// Distance from the charge to the nearest of the body and the open sides
  /// [m].
  double unobstructed_distance() const;

  /// Radius of the products of the explosive at rest, which scales with the
  /// cube root of the mass: 0.9 m for 2.268 kg of C-4 [m].
  double fireball_radius(const SceneParameters &scene) const;

  /// Whether the front has swept more than the charge's mass of air when it
  /// reaches the body; only then the expected arrival is meaningful.
  bool is_far(const SceneParameters &scene) const;

  /// Whether the side z low is a wall, and not the user's open side.
  bool has_ground() const
  {
    return own_.has_ground;
  }

  bool has_own_corners() const
  {
    return own_.lower || own_.upper;
  }

  /// Longest edge of the subcells at a refinement level [m].
  double cell_size(unsigned int level) const;
  /// The same at the skin [m].
  double cell_size() const;
  /// The body's shortest side, however it is turned [m].
  double shortest_side() const;
  /// Subcells at the skin for the length of the positive phase in air.
  double cells_per_phase() const;
  /// Subcells at the skin along the body's shortest side.
  double cells_across() const;

private:
  void place_charge(const SceneParameters &scene, const Shape &surface);
  void choose_levels(const SceneParameters &scene);
  void expect_front(const SceneParameters &scene, const ExpectedBlast &blast);
  void check_charge(const SceneParameters &scene) const;
  /// Takes corners and leaves of the user, and chooses levels by them.
  void take_domain(const SceneParameters &scene);
  void find_symmetry(const SceneParameters &scene, const Shape &surface);
  /// Places the probe some cells off all sides of the domain but the ground,
  /// or leaves it out.
  void place_probe(const dealii::BoundingBox<3> &domain);
  /// Numbers of coarse leaves per direction, below and above 0, that the
  /// domain needs for a front that travels @p front_distance [m].
  std::array<std::array<double, 2>, 3> leaves_for(double front_distance) const;
  void size_domain(const SceneParameters &scene, const ExpectedBlast &blast);
  void set_corners();
  /// Extends the domain for gauges of the user, as far as max_leaves allows.
  void watch(const std::vector<GaugeRaster> &gauges);

  OwnGrid own_;
  std::vector<dealii::Point<3>> watched_;
};
} // namespace contrecoup::coupling
