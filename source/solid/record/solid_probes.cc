// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/record/solid_probes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::solid
{
namespace
{
  const std::vector<std::string> statistics{"maximum",
                                            "minimum",
                                            "last",
                                            "arrival",
                                            "frequency"};

  /// Names of the quantities, for parameter files.
  std::vector<std::string> quantity_names()
  {
    std::vector<std::string> names;
    for (const ProbeQuantity &quantity : probe_quantities())
      names.push_back(quantity.name);
    return names;
  }

  /// Distance of a point from the box around an element, over the element's
  /// edge.
  double distance_in_edges(const SolidMesh &mesh,
                           const std::uint32_t element,
                           const dealii::Point<3> &point)
  {
    dealii::Point<3> low = mesh.nodes[mesh.elements[element][0]], high = low;
    for (const std::uint32_t node : mesh.elements[element])
      for (unsigned int d = 0; d < 3; ++d)
      {
        low[d] = std::min(low[d], mesh.nodes[node][d]);
        high[d] = std::max(high[d], mesh.nodes[node][d]);
      }
    dealii::Tensor<1, 3> outside;
    for (unsigned int d = 0; d < 3; ++d)
      outside[d] = std::max({0., low[d] - point[d], point[d] - high[d]});
    return outside.norm() / (high - low).norm() * std::sqrt(3.);
  }

  /// @throws InputError on all ranks
  void refuse_outside(const SolidMesh &mesh,
                      const dealii::Point<3> &point,
                      const std::size_t number,
                      const MPI_Comm communicator)
  {
    constexpr double largest_distance = 0.5; // in edges
    double distance = std::numeric_limits<double>::max();
    for (std::uint32_t i = 0; i < mesh.elements.size() && distance > 0.; ++i)
      distance = std::min(distance, distance_in_edges(mesh, i, point));
    distance = dealii::Utilities::MPI::min(distance, communicator);
    if (distance <= largest_distance)
      return;
    throw InputError("Probes/Points: probe " + std::to_string(number) +
                     " at (" + coordinates(point) +
                     ") m is outside of the body, by " + brief(distance, 2) +
                     " edges of an element; " +
                     extent_in_words(mesh, communicator));
  }

  /// True on the rank with the smallest distance, and there only.
  bool is_nearest(const double distance, const MPI_Comm communicator)
  {
    struct
    {
      double value;
      int rank;
    } mine, all;
    mine.value = distance;
    mine.rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE_INT, MPI_MINLOC, communicator);
    return all.rank == mine.rank;
  }
} // namespace


const std::vector<ProbeQuantity> &probe_quantities()
{
  static const std::vector<ProbeQuantity> quantities{
    {"displacement_x", "m"},
    {"displacement_y", "m"},
    {"displacement_z", "m"},
    {"velocity_x", "m/s"},
    {"velocity_y", "m/s"},
    {"velocity_z", "m/s"},
    {"pressure", "Pa"},
    {"von_mises_stress", "Pa"},
    {"principal_strain", "-"},
    {"stress_xx", "Pa"},
    {"stress_yy", "Pa"},
    {"stress_zz", "Pa"},
    {"stress_xy", "Pa"},
    {"stress_yz", "Pa"},
    {"stress_zx", "Pa"},
    {"averaged_pressure", "Pa"}};
  return quantities;
}


template <typename Real>
void SolidProbes<Real>::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Probes");
    declare_points(
      prm,
      "Points",
      "",
      "m",
      selecting("Probe positions in the undeformed body; displacement "
                "and velocity are those of the nearest node, stresses "
                "and strains those of the element with the nearest "
                "centre, and the averaged pressure is the mean over that "
                "element's corners of the pressure in the elements of its "
                "tissue around each."));
  }
  const Section section(prm, "Measures");
  const Section measure(prm, "Measure *");
  declare_integer(prm, "Probe", "1", 1, 100000, "Number of the probe, from 1.");
  declare_selection(prm,
                    "Quantity",
                    "displacement_x",
                    quantity_names(),
                    "Measured quantity of the probe.");
  declare_selection(prm,
                    "Statistic",
                    "maximum",
                    statistics,
                    "Over all steps: largest or smallest value, value at "
                    "the end, time [s] at which the threshold is first "
                    "crossed in either direction, or frequency [Hz] of "
                    "rising through the threshold.");
  declare_double(prm,
                 "First time",
                 "0",
                 0.,
                 bounds::time,
                 "s",
                 "Steps before this time do not count.");
  // These bounds admit values of every quantity.
  declare_double(
    prm,
    "Threshold",
    "0",
    -bounds::energy,
    bounds::energy,
    "-",
    used_with(
      "Statistic = arrival, frequency",
      "Threshold of arrival and frequency, in the unit of the quantity."));
  declare_double(prm,
                 "Expected",
                 "0",
                 -bounds::energy,
                 bounds::energy,
                 "-",
                 "Expected value of the measure; summary.json has the "
                 "relative error. 0: no error is given.");
}


template <typename Real>
void SolidProbes<Real>::parse_parameters(ParameterHandler &prm,
                                         const MeshDescription & /*mesh*/)
{
  {
    const Section section(prm, "Probes");
    for (const dealii::Point<3> &point : read_points<3>(prm, "Points"))
    {
      locations_.emplace_back();
      locations_.back().point = point;
    }
  }
  const std::size_t n_quantities = probe_quantities().size();
  values_.assign(n_quantities * locations_.size(), 0.);
  for (const std::string &name : item_names(prm, "Measures/Measure"))
  {
    const Section section(prm, "Measures");
    const Section item(prm, "Measure " + name);
    const unsigned int probe = read_unsigned(prm, "Probe");
    if (probe > locations_.size())
      throw InputError(
        "Measures/Measure " + name + "/Probe = " + std::to_string(probe) +
        ", but Probes/Points has " + std::to_string(locations_.size()));
    const std::vector<std::string> names = quantity_names();
    const auto quantity =
      std::find(names.begin(), names.end(), prm.get("Quantity"));
    Measure measure;
    measure.name = name;
    measure.column = static_cast<unsigned int>(n_quantities * (probe - 1) +
                                               (quantity - names.begin()));
    measure.statistic = prm.get("Statistic");
    measure.expected = read_double(prm, "Expected");
    measure.first_time = read_double(prm, "First time");
    measure.threshold = read_double(prm, "Threshold");
    measures_.push_back(measure);
  }
}


template <typename Real>
void SolidProbes<Real>::check(const SolidMesh &mesh,
                              const MPI_Comm communicator)
{
  for (ProbeLocation &location : locations_)
  {
    refuse_outside(mesh,
                   location.point,
                   1 + static_cast<std::size_t>(&location - locations_.data()),
                   communicator);
    double least = std::numeric_limits<double>::max();
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i)
    {
      const double distance = mesh.nodes[i].distance_square(location.point);
      if (distance < least)
      {
        least = distance;
        location.node = i;
      }
    }
    location.has_node = is_nearest(least, communicator);
    least = std::numeric_limits<double>::max();
    for (std::uint32_t i = 0; i < mesh.elements.size(); ++i)
    {
      dealii::Point<3> middle;
      for (const std::uint32_t node : mesh.elements[i])
        middle += mesh.nodes[node] / 8.;
      const double distance = middle.distance_square(location.point);
      if (distance < least)
      {
        least = distance;
        location.element = i;
      }
    }
    location.has_element = is_nearest(least, communicator);
    find_averaged(mesh, location, communicator);
  }
}


template <typename Real>
void SolidProbes<Real>::find_averaged(const SolidMesh &mesh,
                                      ProbeLocation &location,
                                      const MPI_Comm communicator)
{
  // Tissue and corners of the nearest element, known to all ranks.
  std::vector<std::uint64_t> known(9, 0);
  if (location.has_element)
  {
    known[0] = mesh.tissue[location.element];
    for (unsigned int i = 0; i < 8; ++i)
      known[1 + i] = mesh.global_node[mesh.elements[location.element][i]];
  }
  dealii::Utilities::MPI::sum(known, communicator, known);
  std::vector<double> volumes(8, 0.); // around each corner
  std::vector<std::pair<std::uint32_t, std::array<double, 8>>> parts;
  for (std::uint32_t i = 0; i < mesh.elements.size(); ++i)
  {
    if (mesh.tissue[i] != known[0])
      continue;
    std::array<double, 8> part{};
    for (const std::uint32_t node : mesh.elements[i])
      for (unsigned int corner = 0; corner < 8; ++corner)
        if (mesh.global_node[node] == known[1 + corner])
          part[corner] = cell_volume(mesh, i);
    if (std::any_of(part.begin(), part.end(), [](const double volume) {
          return volume > 0.;
        }))
      parts.emplace_back(i, part);
    for (unsigned int corner = 0; corner < 8; ++corner)
      volumes[corner] += part[corner];
  }
  dealii::Utilities::MPI::sum(volumes, communicator, volumes);
  location.averaged.clear();
  for (const auto &[element, part] : parts)
  {
    double weight = 0.;
    for (unsigned int corner = 0; corner < 8; ++corner)
      weight += part[corner] / volumes[corner] / 8.;
    location.averaged.emplace_back(element, weight);
  }
}


template <typename Real>
void SolidProbes<Real>::read(const SolidBody<Real> &body)
{
  std::fill(values_.begin(), values_.end(), 0.);
  double *value = values_.data();
  for (const ProbeLocation &location : locations_)
  {
    if (location.has_node)
      for (unsigned int d = 0; d < 3; ++d)
      {
        value[d] = body.nodes().displacement_of(location.node)[d];
        value[3 + d] = body.nodes().velocity_of(location.node)[d];
      }
    if (location.has_element)
    {
      const ElementValues element =
        body.elements().values(body.nodes(), body.times(), location.element);
      value[6] = pressure_of(element.stress);
      value[7] = von_mises(element.stress);
      value[8] = largest_principal(element.strain);
      for (unsigned int k = 0; k < 6; ++k)
        value[9 + k] = element.stress[k];
    }
    for (const auto &[element, weight] : location.averaged)
      value[15] +=
        weight *
        pressure_of(
          body.elements().values(body.nodes(), body.times(), element).stress);
    value += probe_quantities().size();
  }
  dealii::Utilities::MPI::sum(values_, body.communicator(), values_);
  for (Measure &measure : measures_)
    measure.take(values_[measure.column], body.time());
}


template <typename Real>
void SolidProbes<Real>::Measure::take(const double now, const double time)
{
  if (time < first_time)
    return;
  const bool first = state.n_read == 0.;
  if (statistic == "maximum")
    state.value = first ? now : std::max(state.value, now);
  else if (statistic == "minimum")
    state.value = first ? now : std::min(state.value, now);
  else if (statistic == "last")
    state.value = now;
  else if (!first && (state.last < threshold) != (now < threshold) &&
           (statistic == "arrival" || now >= threshold))
  {
    state.value = state.last_time + (time - state.last_time) *
                                      (threshold - state.last) /
                                      (now - state.last);
    if (state.n_crossings == 0.)
      state.first_crossing = state.value;
    ++state.n_crossings;
  }
  state.last = now;
  state.last_time = time;
  ++state.n_read;
}


template <typename Real>
bool SolidProbes<Real>::Measure::is_found() const
{
  return state.n_read > 0. &&
         state.n_crossings >= (statistic == "arrival"     ? 1.
                               : statistic == "frequency" ? 2.
                                                          : 0.);
}


template <typename Real>
double SolidProbes<Real>::Measure::result() const
{
  if (!is_found())
    return std::numeric_limits<double>::quiet_NaN();
  if (statistic == "arrival")
    return state.first_crossing;
  if (statistic == "frequency")
    return (state.n_crossings - 1.) / (state.value - state.first_crossing);
  return state.value;
}


template <typename Real>
std::vector<NamedValue> SolidProbes<Real>::values(const SolidBody<Real> &body)
{
  if (measures_.empty() && !locations_.empty())
    read(body);
  std::vector<NamedValue> result;
  const auto &quantities = probe_quantities();
  for (std::size_t i = 0; i < values_.size(); ++i)
  {
    const ProbeQuantity &quantity = quantities[i % quantities.size()];
    result.push_back({"probe_" + std::to_string(i / quantities.size() + 1) +
                        "_" + quantity.name,
                      quantity.unit,
                      values_[i]});
  }
  return result;
}


template <typename Real>
std::vector<NamedValue>
SolidProbes<Real>::results(const SolidBody<Real> & /*body*/) const
{
  std::vector<NamedValue> result;
  const auto &quantities = probe_quantities();
  for (const Measure &measure : measures_)
  {
    const std::string &unit =
      quantities[measure.column % quantities.size()].unit;
    result.push_back({measure.name,
                      measure.statistic == "arrival"     ? "s"
                      : measure.statistic == "frequency" ? "1/s"
                                                         : unit,
                      measure.result()});
  }
  return result;
}


template <typename Real>
std::vector<std::string> SolidProbes<Real>::gaps() const
{
  std::vector<std::string> lines;
  for (const Measure &measure : measures_)
    if (!measure.is_found())
      lines.push_back("Measures/Measure " + measure.name + " has no value: " +
                      (measure.state.n_read == 0.
                         ? "the run ended before First time = " +
                             brief(measure.first_time) + " s"
                         : "its signal " +
                             std::string(measure.statistic == "arrival"
                                           ? "never crosses"
                                           : "rises less than twice through") +
                             " Threshold = " + brief(measure.threshold)));
  return lines;
}


template <typename Real>
std::vector<NamedValue> SolidProbes<Real>::errors() const
{
  std::vector<NamedValue> result;
  for (const Measure &measure : measures_)
    if (measure.expected != 0.)
      result.push_back(
        {measure.name, "-", measure.result() / measure.expected - 1.});
  return result;
}


template <typename Real>
void SolidProbes<Real>::save(const SolidBody<Real> &body,
                             const std::string &folder) const
{
  if (measures_.empty() ||
      dealii::Utilities::MPI::this_mpi_process(body.communicator()) != 0)
    return;
  io::save_state(folder + "/measures.bin", [&](io::StateWriter &out) {
    for (const Measure &measure : measures_)
      out.put(measure.state);
  });
}


template <typename Real>
void SolidProbes<Real>::restore(const SolidBody<Real> & /*body*/,
                                const std::string &folder)
{
  if (measures_.empty())
    return;
  io::StateReader in(folder + "/measures.bin");
  for (Measure &measure : measures_)
    in.take(measure.state);
}


template class SolidProbes<double>;
template class SolidProbes<float>;
} // namespace contrecoup::solid
