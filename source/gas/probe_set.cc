// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/probe_set.h>

#include <sstream>

namespace contrecoup::gas
{
namespace
{
  std::string probe_name(const std::size_t i, const std::string &quantity)
  {
    return "probe_" + std::to_string(i + 1) + "_" + quantity;
  }
} // namespace


template <int dim>
void ProbeSet<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Probes");
  declare_points(prm,
                 "Points",
                 "",
                 "m",
                 "Places where pressure, density and velocity are recorded "
                 "in every step.");
}


template <int dim>
void ProbeSet<dim>::parse_parameters(ParameterHandler &prm,
                                     const CoarseMesh<dim> &mesh)
{
  const Section section(prm, "Probes");
  places_ = read_points<dim>(prm, "Points");
  for (const auto &place : places_)
    for (unsigned int d = 0; d < dim && mesh.is_axis_aligned(); ++d)
      if (place[d] < mesh.lower_corner()[d] ||
          place[d] > mesh.upper_corner()[d])
      {
        std::ostringstream message;
        message << "Probes/Points: the point " << place
                << " m is outside of the domain, " << mesh.lower_corner()
                << " m to " << mesh.upper_corner() << " m";
        throw InputError(message.str());
      }
  ambient_.assign(places_.size(), 0.);
  records_.assign(places_.size(), {});
}


template <int dim>
void ProbeSet<dim>::set_ambient(const InitialState<dim> &initial_state)
{
  for (std::size_t i = 0; i < places_.size(); ++i)
    ambient_[i] = initial_state.value(places_[i]).pressure;
}


template <int dim>
void ProbeSet<dim>::reinit(const LeafMesh<dim> &mesh,
                           const LeafPoints<dim> &points)
{
  if (!places_.empty())
    sampler_.reinit(places_, mesh, points);
}


template <int dim>
void ProbeSet<dim>::read(const GasField &field,
                         const GasMaterial &material,
                         const double time)
{
  if (places_.empty())
    return;
  states_ = sampler_.sample(field, material);
  for (std::size_t i = 0; i < places_.size(); ++i)
  {
    Record &record = records_[i];
    const double pressure = states_[i].pressure;
    if (time > record.last_time)
    {
      const double rise =
        (pressure - record.last_pressure) / (time - record.last_time);
      if (rise > record.steepest)
      {
        record.steepest = rise;
        record.arrival = 0.5 * (time + record.last_time);
      }
    }
    record.peak = std::max(record.peak, pressure - ambient_[i]);
    record.last_time = time;
    record.last_pressure = pressure;
  }
}


template <int dim>
std::vector<NamedValue> ProbeSet<dim>::values(const bool has_products) const
{
  const std::array<const char *, 3> axes = {{"x", "y", "z"}};
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < states_.size(); ++i)
  {
    values.push_back({probe_name(i, "pressure"), "Pa", states_[i].pressure});
    values.push_back({probe_name(i, "density"), "kg/m^3", states_[i].density});
    for (unsigned int d = 0; d < dim; ++d)
      values.push_back({probe_name(i, std::string("velocity_") + axes[d]),
                        "m/s",
                        states_[i].velocity[d]});
    if (has_products)
      values.push_back({probe_name(i, "products"), "-", states_[i].products});
  }
  return values;
}


template <int dim>
std::vector<NamedValue> ProbeSet<dim>::peaks() const
{
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < records_.size(); ++i)
  {
    values.push_back(
      {probe_name(i, "peak_overpressure"), "Pa", records_[i].peak});
    values.push_back({probe_name(i, "arrival"), "s", records_[i].arrival});
  }
  return values;
}


template <int dim>
std::vector<NamedValue>
ProbeSet<dim>::errors(const ReferenceSolution<dim> &reference) const
{
  std::vector<NamedValue> values;
  if (!reference.has_arrivals())
    return values;
  for (std::size_t i = 0; i < records_.size(); ++i)
  {
    const ShockArrival exact = reference.arrival(places_[i]);
    values.push_back({probe_name(i, "peak_overpressure_relative"),
                      "-",
                      records_[i].peak / exact.overpressure - 1.});
    values.push_back({probe_name(i, "arrival_relative"),
                      "-",
                      records_[i].arrival / exact.time - 1.});
  }
  return values;
}


template <int dim>
void ProbeSet<dim>::save(std::ostream &stream) const
{
  stream.write(reinterpret_cast<const char *>(records_.data()),
               records_.size() * sizeof(Record));
}


template <int dim>
void ProbeSet<dim>::load(std::istream &stream)
{
  stream.read(reinterpret_cast<char *>(records_.data()),
              records_.size() * sizeof(Record));
}


template class ProbeSet<1>;
template class ProbeSet<2>;
template class ProbeSet<3>;
} // namespace contrecoup::gas
