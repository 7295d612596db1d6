// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/gas/explosive/afterburn.h>
#include <contrecoup/gas/state/state_parameters.h>
#include <contrecoup/materials/explosives.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace contrecoup::coupling
{
namespace
{
  constexpr std::size_t n_distances = 6;
  /// Scaled distances of the measurements [m/kg^(1/3)].
  constexpr std::array<double, n_distances> distances = {
    {1., 1.5, 2., 3., 4., 6.}};

  /// Relative differences at these distances [-].
  struct Measured
  {
    std::array<double, n_distances> peak, impulse, duration;
  };

  /// From parameter_files/study/results/explosive_bias.md.
  const std::map<std::string, Measured> &measured()
  {
    // clang-format off
    static const std::map<std::string, Measured> table{
      {"tnt",
       {{{0.043, -0.024, -0.046, -0.019, 0.022, 0.052}},
        {{0.043, 0.015, 0.078, 0.125, 0.124, 0.110}},
        {{0.06, 0.06, 0.12, -0.01, 0.01, 0.03}}}},
      {"tnt dobratz",
       {{{0.109, 0.018, -0.014, 0.007, 0.035, 0.066}},
        {{0.005, -0.022, 0.041, 0.093, 0.095, 0.083}},
        {{0.07, 0.12, 0.18, 0.04, 0.06, 0.07}}}},
      {"c-4",
       {{{0.062, -0.057, -0.103, -0.092, -0.058, -0.016}},
        {{0.042, -0.022, 0.036, 0.098, 0.103, 0.092}},
        {{0.07, 0.05, 0.15, 0.01, 0.03, 0.05}}}},
      {"composition b",
       {{{0.091, -0.020, -0.065, -0.051, -0.021, 0.014}},
        {{-0.188, -0.211, -0.157, -0.112, -0.110, -0.046}},
        {{-0.38, -0.39, -0.24, -0.24, -0.19, 0.11}}}},
      {"petn 1.77",
       {{{0.016, -0.099, -0.148, -0.139, -0.102, -0.064}},
        {{-0.283, -0.299, -0.246, -0.202, -0.201, -0.211}},
        {{-0.59, -0.48, -0.30, -0.28, -0.24, -0.19}}}},
      {"petn 1.50",
       {{{0.030, -0.095, -0.145, -0.136, -0.099, -0.060}},
        {{-0.277, -0.295, -0.242, -0.198, -0.197, -0.207}},
        {{-0.58, -0.48, -0.30, -0.28, -0.24, -0.19}}}},
      {"anfo",
       {{{-0.090, -0.105, -0.103, -0.061, -0.033, -0.011}},
        {{-0.275, -0.206, -0.163, -0.148, -0.153, -0.166}},
        {{-0.58, -0.33, -0.29, -0.24, -0.20, -0.16}}}},
      {"pentolite",
       {{{0.101, -0.008, -0.053, -0.039, -0.010, 0.023}},
        {{-0.185, -0.201, -0.147, -0.102, -0.022, -0.032}},
        {{-0.40, -0.38, -0.24, -0.24, 0.10, 0.11}}}}};
    // clang-format on
    return table;
  }

  /// Linear between the logarithms of distances; in whole per cents, as it is
  /// told everywhere.
  double interpolate(const std::array<double, n_distances> &values,
                     const double distance)
  {
    const auto after =
      std::lower_bound(distances.begin() + 1, distances.end() - 1, distance);
    const auto i = static_cast<std::size_t>(after - distances.begin());
    const double part = std::log(distance / distances[i - 1]) /
                        std::log(distances[i] / distances[i - 1]);
    return 0.01 * std::round(100. * (values[i - 1] +
                                     part * (values[i] - values[i - 1])));
  }

  /// Distances of the probes from the centre of the charge [m].
  template <int dim>
  std::vector<double> probe_distances(ParameterHandler &prm,
                                      const std::string &charge)
  {
    dealii::Point<dim> centre;
    {
      const Section charges(prm, "Charges");
      const Section one(prm, "Charge " + charge);
      centre = dealii::Point<dim>(
        gas::read_vector<dim>(prm, "Center", "Charges/Charge " + charge));
    }
    const Section section(prm, "Probes");
    std::vector<double> found;
    for (const dealii::Point<dim> &place : read_points<dim>(prm, "Points"))
      found.push_back(place.distance(centre));
    return found;
  }


  std::vector<double> probe_distances(ParameterHandler &prm,
                                      const std::string &charge)
  {
    const long dim = prm.get_integer({"Domain"}, "Dimension");
    return dim == 1   ? probe_distances<1>(prm, charge)
           : dim == 2 ? probe_distances<2>(prm, charge)
                      : probe_distances<3>(prm, charge);
  }


  /// Whether a charge is a sphere whose wave spreads in space: the bias was
  /// measured for these alone.
  bool is_sphere(const ParameterHandler &prm, const std::string &charge)
  {
    const std::vector<std::string> geometries = {
      "", "spherical", "axisymmetric"};
    const long dim = prm.get_integer({"Domain"}, "Dimension");
    return prm.get({"Charges", "Charge " + charge}, "Shape") == "sphere" &&
           (dim == 3 || prm.get({"Domain"}, "Geometry") == geometries[dim]);
  }


  /// The only charge of a run, of an explosive of the library.
  BiasedBurst read_burst(ParameterHandler &prm, const std::string &charge)
  {
    BiasedBurst burst;
    burst.explosive = prm.get({"Material"}, "Explosive");
    burst.mass = prm.get_double({"Charges", "Charge " + charge}, "Mass");
    const double usual = find_explosive(burst.explosive).afterburn.energy;
    gas::Afterburn afterburn;
    const Section section(prm, "Charges");
    afterburn.parse_parameters(prm);
    const double energy = afterburn.energy_left();
    burst.has_usual_afterburn = std::abs(energy - usual) <= 0.01 * usual;
    return burst;
  }
} // namespace


ModelBias model_bias(const BiasedBurst &burst, const double distance)
{
  const double scaled = distance / std::cbrt(burst.mass);
  const auto found = measured().find(burst.explosive);
  std::string gap;
  if (found == measured().end() || burst.is_custom)
    gap = "it was not measured for constants of the user's own";
  else if (!burst.has_usual_afterburn)
    gap = "it was not measured for afterburn of the user's own";
  else if (burst.is_on_ground)
    gap = "it was measured for charges in free air alone";
  else if (scaled < distances.front() || scaled > distances.back())
    gap = "it was measured from " + brief(distances.front()) + " to " +
          brief(distances.back()) + " m/kg^(1/3) alone";
  if (!gap.empty())
    return {unknown, unknown, unknown, gap};
  return {interpolate(found->second.peak, scaled),
          interpolate(found->second.impulse, scaled),
          interpolate(found->second.duration, scaled)};
}


std::string in_words(const ModelBias &bias)
{
  const auto words = [](const std::string &what, const double value) {
    return what + (value < 0. ? " -" : " +") +
           brief(std::abs(std::round(100. * value))) + " %";
  };
  return !bias.gap.empty()
           ? "unknown: " + bias.gap
           : words("peak", bias.peak) + ", " + words("impulse", bias.impulse) +
               ", " + words("duration", bias.duration);
}


std::vector<std::string> warn_of_bias(ParameterHandler &prm)
{
  constexpr double most = 0.2; // beyond which injuries of lungs are others
  const std::vector<std::string> charges = item_names(prm, "Charges/Charge");
  if (charges.size() != 1 || !prm.get_bool({"Probes"}, "Injury") ||
      prm.get({"Material"}, "Explosive") == "custom" ||
      !is_sphere(prm, charges.front()))
    return {};
  const BiasedBurst burst = read_burst(prm, charges.front());
  const auto size = [](const ModelBias &bias) {
    return std::max(std::abs(bias.impulse), std::abs(bias.duration));
  };
  ModelBias worst = {0., 0., 0.};
  double at = 0.;
  for (const double distance : probe_distances(prm, charges.front()))
    if (const ModelBias bias = model_bias(burst, distance);
        size(bias) > size(worst))
    {
      worst = bias;
      at = distance;
    }
  if (!(size(worst) > most))
    return {};
  return {
    "WARNING: Material/Explosive = " + burst.explosive + ": " + brief(at) +
    " m from the charge in free air the model's wave differs "
    "from the tables, whatever the cells, by " +
    in_words(worst) + "; injuries of lungs by the probes differ accordingly"};
}
} // namespace contrecoup::coupling
