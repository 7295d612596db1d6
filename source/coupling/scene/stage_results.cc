// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/stage_results.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/output/history_reader.h>

#include <deal.II/base/tensor.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

namespace contrecoup::coupling
{
namespace
{
  using Vector = dealii::Tensor<1, 3>;

  constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

  /// A group in the summary of a stage, an object of objects with value and
  /// unit.
  io::Json group_in(const std::string &folder, const std::string &group)
  {
    const io::Json summary =
      io::read_json(folder + "/summary.json", io::formats::summary);
    return summary.is_object() && summary.contains(group) &&
               summary[group].is_object()
             ? summary[group]
             : io::Json::object();
  }

  double value_in(const io::Json &group, const std::string &name)
  {
    return group.contains(name) && group[name].is_object() &&
               group[name].contains("value") && group[name]["value"].is_number()
             ? group[name]["value"].get<double>()
             : not_measured;
  }

  /// The vector that begins with column @p first in a row.
  Vector
  vector_at(const io::HistoryTable &table, std::size_t first, std::size_t row)
  {
    Vector vector;
    for (unsigned int d = 0; d < 3; ++d)
      vector[d] = table.columns[first + d][row];
    return vector;
  }

  /// Length of the longest of vectors over @p times until @p last [s], between
  /// which they go straight.
  double longest(const std::vector<double> &times,
                 const std::vector<Vector> &vectors,
                 const double last)
  {
    double length = not_measured;
    for (std::size_t row = 0; row < times.size(); ++row)
    {
      if (times[row] > last)
      {
        if (row > 0)
          length =
            std::fmax(length,
                      (vectors[row - 1] + (last - times[row - 1]) /
                                            (times[row] - times[row - 1]) *
                                            (vectors[row] - vectors[row - 1]))
                        .norm());
        break;
      }
      length = std::fmax(length, vectors[row].norm());
    }
    return length;
  }

  /// Largest displacement of a probe until @p last [m].
  double displacement_of_probes(const std::string &file, const double last)
  {
    double largest = not_measured;
    const io::HistoryTable table = io::read_history(file);
    const std::vector<double> &times = table.column("time", file);
    for (std::size_t i = 0; i + 2 < table.names.size(); ++i)
      if (table.names[i].find("displacement_x") != std::string::npos)
      {
        std::vector<Vector> places;
        for (std::size_t row = 0; row < times.size(); ++row)
          places.push_back(vector_at(table, i, row));
        largest = std::fmax(largest, longest(times, places, last));
      }
    return largest;
  }

  /// The centre of mass by the momentum of the body.
  BodyMotion motion_of_center(const std::string &file, const double last)
  {
    BodyMotion largest{not_measured, not_measured};
    const io::HistoryTable table = io::read_history(file);
    const std::vector<double> &times = table.column("time", file);
    const std::vector<double> &mass = table.column("mass", file);
    std::array<const std::vector<double> *, 3> momentum;
    for (unsigned int d = 0; d < 3; ++d)
      momentum[d] = &table.column(std::string("momentum_") + "xyz"[d], file);
    Vector place, before;
    std::vector<Vector> places;
    for (std::size_t row = 0; row < times.size(); ++row)
    {
      Vector velocity;
      for (unsigned int d = 0; d < 3; ++d)
        velocity[d] = (*momentum[d])[row] / mass[row];
      if (row > 0)
        place += 0.5 * (times[row] - times[row - 1]) * (before + velocity);
      before = velocity;
      largest.speed = std::fmax(largest.speed, velocity.norm());
      places.push_back(place);
    }
    largest.displacement = longest(times, places, last);
    return largest;
  }
} // namespace


double stage_result(const std::string &folder, const std::string &name)
{
  return value_in(group_in(folder, "results"), name);
}


std::map<std::string, double> stage_results(const std::string &folder)
{
  std::map<std::string, double> values;
  const io::Json results = group_in(folder, "results");
  for (const auto &[name, result] : results.items())
    if (result.is_object() && result.contains("value") &&
        result["value"].is_number())
      values[name] = result["value"].get<double>();
  return values;
}


double stage_check(const std::string &folder, const std::string &name)
{
  return value_in(group_in(folder, "checks"), name);
}


double skin_projections(const std::string &folder)
{
  const io::Json summary =
    io::read_json(folder + "/summary.json", io::formats::summary);
  const std::string name = "surface_projections";
  return summary.is_object() && summary.contains(name) &&
             summary[name].is_number()
           ? summary[name].get<double>()
           : not_measured;
}


double largest_trunk_peak(const std::string &folder)
{
  const io::Json results = group_in(folder, "results");
  double largest = not_measured;
  for (const std::string place :
       {"chest", "abdomen", "back", "left_upper_arm", "right_upper_arm"})
    largest = std::fmax(largest, value_in(results, "loads_" + place + "_peak"));
  return largest;
}


BodyMotion measure_motion(const std::string &folder, const double last)
{
  BodyMotion largest{not_measured, not_measured};
  if (const std::string file = folder + "/history.csv";
      std::filesystem::exists(file))
    largest = motion_of_center(file, last);
  if (const std::string file = folder + "/probes.csv";
      std::filesystem::exists(file))
    largest.displacement =
      std::fmax(largest.displacement, displacement_of_probes(file, last));
  return largest;
}
} // namespace contrecoup::coupling
