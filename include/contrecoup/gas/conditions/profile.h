// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/coarse_mesh.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * The content of a profile: a blast with an axis or a centre on a raster of
 * cells. Spherical and cylindrical ones have one direction, the radius;
 * axisymmetric ones have two, the radius and the place on the axis. Cell
 * (i, j) has number i + n_0 j. Beyond the raster the gas is ambient.
 */
struct ProfileData
{
  Geometry geometry = Geometry::spherical;
  double time = 0.;               ///< [s]
  std::string material;           ///< equation of state and explosive, in words
  std::string version;            ///< of the software that made it
  double afterburn_fraction = 0.; ///< see Afterburn [-]
  double afterburn_released = 0.; ///< by the whole body [J]

  /// Ambient density [kg/m^3], energy [J/m^3], density of products [kg/m^3].
  std::array<double, 3> ambient{};
  double ambient_pressure = 0.; ///< [Pa]

  /// Ends of the domain that it comes from, by direction [m]: ends of the
  /// raster that coincide with them need not be surrounded by ambient gas.
  std::vector<double> domain_begin, domain_end;

  /// Cell edges by direction, increasing [m].
  std::vector<std::vector<double>> edges;

  /// Means over the cells: [component][cell] of density [kg/m^3], momentum
  /// along each direction [kg/(m^2 s)], total energy [J/m^3], density of
  /// products [kg/m^3].
  std::vector<std::vector<double>> values;

  /// Further quantities by name, such as peaks so far: [cell].
  std::map<std::string, std::vector<double>> maps;
};


/**
 * A profile, ready to be sampled. All means are of the excess over the
 * ambient state, in the order of ProfileData::values.
 */
class Profile
{
public:
  /// @throws InputError when @p data contradict themselves or have a cell
  /// without mass or energy.
  explicit Profile(ProfileData data);

  const ProfileData &data() const
  {
    return data_;
  }
  unsigned int n_directions() const
  {
    return static_cast<unsigned int>(data_.edges.size());
  }
  unsigned int n_components() const
  {
    return n_directions() + 3;
  }

  /// Ends of the raster [m].
  double begin(const unsigned int direction) const
  {
    return data_.edges[direction].front();
  }
  double end(const unsigned int direction) const
  {
    return data_.edges[direction].back();
  }

  /// Whether the raster ends where the domain did, so that nobody knows
  /// what is beyond; the centre and the axis are no such ends.
  bool is_cut(const unsigned int direction, const bool upper) const;

  /// Volume of a cell, of the whole body [m^3; m^2 if cylindrical].
  double volume(const unsigned int cell) const;

  /// Volume integral of the excess of each component, of the whole body.
  const std::vector<double> &totals() const
  {
    return totals_;
  }

  /// Width of the cell along @p direction at @p place [m]; that of the
  /// nearest one beyond the raster.
  double cell_width(const unsigned int direction, const double place) const;

  /// Mean excess of each component over the window between @p lower and
  /// @p upper [m], as far as it is in the domain, into @p means. Sums of
  /// cells with positive weights: means of states are states.
  void mean(const std::array<double, 2> &lower,
            const std::array<double, 2> &upper,
            double *means) const;

  /// Relative change of density and energy across the window: the sum of
  /// their logarithms' variations along each direction [-].
  double variation(const std::array<double, 2> &lower,
                   const std::array<double, 2> &upper) const;

  /// Quantity @p name of ProfileData::maps in the cell at @p place;
  /// @p beyond outside of the raster. @throws std::out_of_range
  double map_value(const std::string &name,
                   const std::array<double, 2> &place,
                   const double beyond) const;

private:
  void check() const;
  void sum_up();
  /// Logarithmic variation per length in each cell [1/m].
  std::vector<double> variations() const;
  unsigned int index(const unsigned int direction, const double place) const;
  /// Integral of some table rows from the raster's begin to @p place.
  void integral(const std::array<double, 2> &place,
                const unsigned int begin,
                const unsigned int end,
                double *sums) const;

  ProfileData data_;
  std::array<unsigned int, 2> n_cells_{};
  std::vector<double> totals_;
  /// Integrals up to each corner of the raster, [corner][row]: the excess of
  /// each component, then the variation.
  std::vector<double> table_;
};
} // namespace contrecoup::gas
