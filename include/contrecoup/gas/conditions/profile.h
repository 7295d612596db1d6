// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/mesh/coarse_mesh.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Data of a profile: a blast with an axis or a centre, on a rectilinear raster
 * of cells. Spherical and cylindrical profiles have one direction, the radius;
 * axisymmetric ones have two, the radius and the axis. Cell (i, j) has number
 * i + n_0 j. Beyond the raster the gas is ambient.
 */
struct ProfileData
{
  Geometry geometry = Geometry::spherical;
  double time = 0.;     ///< [s]
  std::string material; ///< description of equation of state and explosive
  std::string version;  ///< version of the software that wrote the profile
  double afterburn_fraction = 0.; ///< released fraction, see Afterburn [-]
  /// Energy released by afterburn in the whole gas [J]
  double afterburn_released = 0.;

  /// Ambient density [kg/m^3], energy [J/m^3], density of products [kg/m^3].
  std::array<double, 3> ambient{};
  double ambient_pressure = 0.; ///< [Pa]

  /// Bounds of the domain of the first run, by direction [m]: a side of the
  /// raster that coincides with such a bound need not lie in ambient gas.
  std::vector<double> domain_begin, domain_end;

  /// Cell edges by direction, increasing [m].
  std::vector<std::vector<double>> edges;

  /// Means over the cells, [component][cell]: density [kg/m^3], momentum along
  /// each direction [kg/(m^2 s)], total energy [J/m^3], density of products
  /// [kg/m^3].
  std::vector<std::vector<double>> values;

  /// Further quantities by name, such as peak overpressures so far: [cell].
  std::map<std::string, std::vector<double>> maps;
};


/**
 * Profile prepared for sampling by a table of integrals. All means are means
 * of the excess over the ambient state, in the order of ProfileData::values.
 */
class Profile
{
public:
  /// @throws InputError when @p data are inconsistent or have a cell without
  /// mass or energy.
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

  /// Bounds of the raster [m].
  double begin(const unsigned int direction) const
  {
    return data_.edges[direction].front();
  }
  double end(const unsigned int direction) const
  {
    return data_.edges[direction].back();
  }

  /// Whether the raster ends at a bound of the first run's domain, so that the
  /// gas beyond is unknown; centre and axis do not count.
  bool is_cut(const unsigned int direction, const bool upper) const;

  /// Volume of a cell over the full angle [m^3; m^2 if cylindrical].
  double volume(const unsigned int cell) const;

  /// Volume integral over the full angle of the excess of each component.
  const std::vector<double> &totals() const
  {
    return totals_;
  }

  /// Width of the cell along @p direction at @p place [m]; beyond the raster
  /// that of the nearest cell.
  double cell_width(const unsigned int direction, const double place) const;

  /// Mean excess of each component over the window between @p lower and @p
  /// upper [m], restricted to the domain, into @p means. The weights of cells
  /// are positive, so that means of admissible states are admissible.
  void mean(const std::array<double, 2> &lower,
            const std::array<double, 2> &upper,
            double *means) const;

  /// Relative variation of density and energy across the window: the sum of
  /// the total variations of their logarithms along each direction [-].
  double variation(const std::array<double, 2> &lower,
                   const std::array<double, 2> &upper) const;

  /// Quantity @p name of ProfileData::maps in the cell at @p place [m]; @p
  /// beyond outside of the raster.
  /// @throws std::out_of_range
  double map_value(const std::string &name,
                   const std::array<double, 2> &place,
                   const double beyond) const;

private:
  void check() const;
  void sum_up();
  /// Logarithmic variation per length in each cell [1/m].
  std::vector<double> variations() const;
  unsigned int index(const unsigned int direction, const double place) const;
  /// Integral of table rows @p begin to @p end from the raster's begin to @p
  /// place.
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
