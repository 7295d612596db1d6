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
#include <utility>

namespace contrecoup::coupling
{
namespace
{
  /// Scaled distances [m/kg^(1/3)] and masses [kg] of the measurements.
  constexpr std::array<double, 6> distances = {{1., 1.5, 2., 3., 4., 6.}};
  constexpr std::array<double, 7> masses = {{0.1, 0.3, 1., 3., 10., 30., 100.}};

  /// Differences in per cent: of peaks at these distances, then of impulses,
  /// then of durations.
  using Row = std::array<int, 3 * distances.size()>;

  /// From parameter_files/study/results/explosive_bias.md, a row for each mass;
  /// one alone holds for any, as without afterburn all scales with distance.
  // clang-format off
  const std::map<std::string, std::vector<Row>> measured{
    {"tnt",
     {{{-5, -11, -13, -10, -6, -3, -12, -23, -18, -2, -2, -3, 25, -34, -20, 16, 15, 15}},
      {{-1, -8, -10, -7, -2, 1, -3, -4, 2, 7, 7, 5, 19, 20, 26, 8, 9, 9}},
      {{4, -2, -5, -2, 2, 5, 4, 2, 8, 13, 12, 11, 6, 6, 12, -1, 1, 3}},
      {{11, 4, 1, 4, 7, 10, 6, 2, 8, 13, 14, 12, -7, -5, 3, -6, -3, 0}},
      {{21, 13, 9, 10, 13, 15, 4, 0, 5, 11, 12, 11, -12, -5, 3, -5, -2, 2}},
      {{32, 21, 15, 14, 16, 17, 1, -8, -2, 4, 5, 7, -9, -37, -25, -23, -16, 8}},
      {{43, 27, 18, 16, 18, 18, -5, -7, -1, 5, 6, 5, -49, -39, -27, -24, -17, -11}}}},
    {"tnt dobratz",
     {{{3, -5, -8, -6, -2, 1, -22, -21, -15, -12, -12, -13, -49, -37, -23, -24, -19, -14}},
      {{6, -2, -5, -3, 1, 3, -6, -18, -12, 4, 4, 3, 18, -32, -20, 13, 13, 13}},
      {{11, 2, -1, 1, 4, 7, 0, -2, 4, 9, 9, 8, 7, 12, 18, 4, 6, 7}},
      {{16, 7, 3, 5, 8, 10, 2, -1, 5, 10, 11, 10, -3, 3, 10, -1, 2, 5}},
      {{24, 14, 9, 10, 13, 14, 1, -9, -3, 8, 8, 8, -7, -35, -23, 0, 3, 7}},
      {{33, 21, 15, 13, 15, 16, -6, -8, -2, 3, 4, 3, -46, -38, -26, -24, -17, -11}},
      {{42, 26, 18, 16, 17, 18, -5, -7, -1, 5, 6, 5, -50, -39, -27, -24, -18, -11}}}},
    {"c-4",
     {{{0, -11, -15, -14, -10, -6, -19, -21, -16, -11, -11, -2, -38, -40, -24, -24, -20, 15}},
      {{3, -9, -13, -12, -8, -4, -2, -19, -13, 5, 5, 4, 17, -33, -20, 9, 9, 10}},
      {{6, -6, -10, -9, -6, -2, 4, -2, 4, 10, 10, 9, 7, 5, 15, 1, 3, 5}},
      {{11, -2, -7, -6, -3, 2, 6, -1, 5, 11, 12, 11, -3, -3, 7, -3, -1, 2}},
      {{17, 4, -2, -2, 1, 5, 6, -2, 3, 10, 10, 10, -6, -4, 7, -3, 0, 4}},
      {{24, 9, 3, 1, 4, 7, 5, -9, -4, 2, 9, 8, -4, -38, -25, -23, 4, 7}},
      {{32, 14, 6, 3, 5, 8, 4, -8, -3, 4, 5, 4, 3, -40, -27, -25, -18, -11}}}},
    {"composition b",
     {{{5, -6, -10, -9, -5, -2, -24, -25, -19, -15, -15, -16, -55, -43, -27, -26, -22, -16}},
      {{6, -4, -9, -8, -4, -1, -22, -23, -18, -14, -14, -15, -50, -41, -26, -26, -21, -15}},
      {{9, -2, -6, -5, -2, 1, -19, -21, -16, -11, -11, -5, -38, -39, -24, -24, -19, 11}},
      {{13, 1, -4, -3, 0, 3, -9, -19, -13, -9, -3, -4, -1, -38, -23, -23, 5, 7}},
      {{17, 5, 0, 0, 3, 6, -15, -17, -12, -7, -6, -7, -49, -41, -26, -25, -20, -14}},
      {{23, 9, 3, 3, 5, 8, -15, -17, -12, -6, -6, -6, -53, -43, -28, -26, -20, -14}},
      {{29, 13, 5, 4, 6, 8, -14, -16, -11, -5, -5, -6, -54, -44, -28, -26, -21, -14}}}},
    {"petn 1.77",
     {{{1, -11, -16, -15, -11, -7, -29, -31, -25, -21, -21, -22, -60, -49, -31, -29, -25, -19}},
      {{1, -10, -15, -14, -11, -7, -29, -30, -25, -21, -21, -22, -59, -49, -30, -29, -24, -19}},
      {{2, -10, -15, -14, -10, -6, -28, -30, -25, -20, -20, -21, -59, -48, -30, -28, -24, -19}},
      {{2, -9, -14, -13, -10, -6, -28, -29, -24, -20, -20, -21, -58, -48, -30, -28, -24, -19}},
      {{4, -8, -13, -12, -9, -5, -27, -29, -24, -19, -19, -20, -59, -48, -30, -28, -24, -19}},
      {{5, -7, -13, -12, -9, -5, -27, -29, -23, -19, -19, -20, -59, -49, -31, -29, -24, -19}},
      {{7, -6, -12, -11, -8, -5, -27, -28, -23, -19, -18, -19, -59, -49, -31, -29, -24, -19}}}},
    {"petn 1.50",
     {{{2, -10, -15, -14, -11, -7, -29, -30, -25, -21, -21, -22, -59, -48, -30, -29, -24, -19}},
      {{2, -10, -15, -14, -10, -7, -28, -30, -25, -20, -20, -21, -58, -48, -30, -28, -24, -19}},
      {{3, -9, -15, -14, -10, -6, -28, -29, -24, -20, -20, -21, -58, -48, -30, -28, -24, -19}},
      {{4, -9, -14, -13, -10, -6, -27, -29, -24, -19, -19, -20, -57, -48, -30, -28, -24, -18}},
      {{5, -8, -13, -12, -9, -5, -26, -28, -23, -19, -18, -19, -58, -48, -30, -28, -24, -18}},
      {{6, -7, -12, -12, -8, -4, -26, -28, -23, -18, -18, -19, -58, -48, -31, -28, -24, -18}},
      {{8, -6, -12, -11, -8, -4, -26, -28, -23, -18, -18, -19, -59, -48, -31, -28, -24, -18}}}},
    {"anfo",
     {{{-9, -11, -10, -6, -3, -1, -28, -21, -16, -15, -15, -17, -58, -33, -29, -24, -20, -16}}}},
    {"pentolite",
     {{{5, -5, -9, -8, -5, -1, -24, -24, -19, -15, -15, -16, -55, -42, -27, -26, -21, -16}},
      {{7, -4, -8, -6, -3, 0, -22, -22, -17, -13, -13, -14, -51, -41, -25, -25, -20, -15}},
      {{10, -1, -5, -4, -1, 2, -18, -20, -15, -10, -2, -3, -40, -38, -24, -24, 10, 11}},
      {{14, 2, -2, -1, 2, 5, -8, -18, -12, -8, -1, -2, -2, -37, -23, -23, 6, 8}},
      {{19, 7, 1, 2, 5, 7, -14, -16, -11, -6, -5, -6, -49, -41, -26, -25, -19, -13}},
      {{25, 11, 5, 4, 7, 9, -14, -16, -10, -5, -4, -5, -53, -43, -28, -26, -20, -14}},
      {{31, 15, 7, 6, 8, 10, -14, -15, -10, -4, -3, -4, -55, -43, -28, -26, -20, -14}}}}};
  // clang-format on

  /// Where @p value lies among rising @p places: the one after it, and the
  /// part of the logarithmic way to that.
  template <std::size_t n>
  std::pair<std::size_t, double> place_in(const std::array<double, n> &places,
                                          const double value)
  {
    const auto after =
      std::lower_bound(places.begin() + 1, places.end() - 1, value);
    const auto i = static_cast<std::size_t>(after - places.begin());
    return {
      i, std::log(value / places[i - 1]) / std::log(places[i] / places[i - 1])};
  }

  /// Linear between the logarithms of distances and of masses; in whole per
  /// cents, as it is told everywhere. NaN where the values around differ so
  /// much that a second shock must join the first wave in between.
  /// @param quantity 0 to 2, see Row
  double interpolate(const std::vector<Row> &rows,
                     const std::size_t quantity,
                     const double distance,
                     const double mass)
  {
    constexpr int largest_jump = 25;
    const auto [i, of_distance] = place_in(distances, distance);
    const auto [j, of_mass] = place_in(masses, mass);
    double sum = 0.;
    int low = 1000, high = -1000;
    for (const std::size_t corner : {0, 1, 2, 3})
    {
      const std::size_t right = corner % 2, upper = corner / 2;
      const double weight = (right ? of_distance : 1. - of_distance) *
                            (upper ? of_mass : 1. - of_mass);
      if (weight < 1e-9)
        continue;
      const Row &row = rows[rows.size() == 1 ? 0 : j - 1 + upper];
      const int value = row[quantity * distances.size() + i - 1 + right];
      sum += weight * value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    return high - low > largest_jump ? unknown : 0.01 * std::round(sum);
  }


  /// The least and the largest distance of probes from the centre of a charge
  /// [m].
  using Reach = std::pair<double, double>;

  /// That of a point, "1,0,0", or of the box between two corners of a line or
  /// plane, "0,0,0 : 2,0,0 : 101".
  template <int dim>
  Reach reach_of(const std::string &places, const dealii::Point<dim> &centre)
  {
    const auto words = split(places, ':');
    double nearest = 0., farthest = 0.;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const auto side = [&](const std::size_t corner) {
        return std::stod(
                 split(words[std::min(corner, words.size() - 1)], ',').at(d)) -
               centre[d];
      };
      const auto [low, high] = std::minmax({side(0), side(1)});
      nearest += std::pow(std::max({low, -high, 0.}), 2);
      farthest += std::pow(std::max(-low, high), 2);
    }
    return {std::sqrt(nearest), std::sqrt(farthest)};
  }


  /// Where the probes of a run are, one entry for each point, line and plane;
  /// the run has read these entries and found them to be right.
  template <int dim>
  std::vector<Reach> probe_reaches(ParameterHandler &prm,
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
    std::vector<Reach> found;
    for (const char *entry : {"Points", "Lines", "Gauge planes"})
      for (const std::string &places : split(prm.get(entry), ';'))
        found.push_back(reach_of(places, centre));
    return found;
  }


  std::vector<Reach> probe_reaches(ParameterHandler &prm,
                                   const std::string &charge)
  {
    const long dim = prm.get_integer({"Domain"}, "Dimension");
    return dim == 1   ? probe_reaches<1>(prm, charge)
           : dim == 2 ? probe_reaches<2>(prm, charge)
                      : probe_reaches<3>(prm, charge);
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
  const auto found = measured.find(burst.explosive);
  std::string gap;
  if (found == measured.end() || burst.is_custom)
    gap = "it was not measured for constants of the user's own";
  else if (!burst.has_usual_afterburn)
    gap = "it was not measured for afterburn of the user's own";
  else if (burst.is_on_ground)
    gap = "it was measured for charges in free air alone";
  else if (scaled < distances.front() || scaled > distances.back())
    gap = "it was measured from " + brief(distances.front()) + " to " +
          brief(distances.back()) + " m/kg^(1/3) alone";
  else if (found->second.size() > 1 &&
           (burst.mass < masses.front() || burst.mass > masses.back()))
    gap = "it was measured from " + brief(masses.front()) + " to " +
          brief(masses.back()) + " kg alone";
  if (!gap.empty())
    return {unknown, unknown, unknown, gap};
  const auto value = [&](const std::size_t quantity) {
    return interpolate(found->second, quantity, scaled, burst.mass);
  };
  const ModelBias bias = {value(0), value(1), value(2)};
  return std::isfinite(bias.peak + bias.impulse + bias.duration)
           ? bias
           : ModelBias{unknown,
                       unknown,
                       unknown,
                       "around this mass and distance a second shock joins the "
                       "first wave or does not"};
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
  const auto consider = [&](const double distance) {
    const ModelBias bias = model_bias(burst, distance);
    if (size(bias) > size(worst))
    {
      worst = bias;
      at = distance;
    }
  };
  for (const auto &[nearest, farthest] : probe_reaches(prm, charges.front()))
  {
    consider(nearest);
    consider(farthest);
    for (const double scaled : distances)
      if (const double distance = scaled * std::cbrt(burst.mass);
          distance > nearest && distance < farthest)
        consider(distance);
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
