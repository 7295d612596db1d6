// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/rezone/bounded_flows.h>

#include <algorithm>

namespace contrecoup::ale
{
void BoundedFlows::reinit(const HexSpace &space, const unsigned int n_fields)
{
  space_ = &space;
  n_fields_ = n_fields;
  stencil_.reinit(space);
  mass_exchange_.reinit(space.cells(), 2);
  other_exchange_.reinit(space.cells(), 2 * (n_fields - 1));
}


void BoundedFlows::clear()
{
  flows_.clear();
  carried_.clear();
}


void BoundedFlows::add(const HexSpace::Face &face,
                       const double volume,
                       const std::uint32_t donor,
                       const double *carried)
{
  flows_.push_back({&face, volume, donor});
  carried_.insert(carried_.end(), carried, carried + n_fields_);
}


void BoundedFlows::limit(const dealii::AlignedVector<double> &fields,
                         const dealii::AlignedVector<double> &masses)
{
  limit_masses(fields, masses);
  limit_others(fields, masses);
}


void BoundedFlows::add_to_cells(const Flow &flow,
                                const double *carried,
                                const unsigned int width,
                                std::vector<double> &contents) const
{
  const std::size_t inside = flow.face->inside, outside = flow.face->outside;
  for (unsigned int f = 0; f < width; ++f)
  {
    if (inside < space_->n_own_cells())
      contents[width * inside + f] += carried[f];
    if (outside < space_->n_own_cells())
      contents[width * outside + f] -= carried[f];
  }
}


void BoundedFlows::limit_masses(const dealii::AlignedVector<double> &fields,
                                const dealii::AlignedVector<double> &masses)
{
  const std::size_t n_own = space_->n_own_cells();
  std::vector<double> low(masses.begin(), masses.begin() + n_own);
  std::vector<double> staying = low, volumes(n_own), rest;
  for (std::size_t c = 0; c < n_own; ++c)
    volumes[c] =
      fields[n_fields_ * c] > 0. ? masses[c] / fields[n_fields_ * c] : 0.;
  for (std::size_t i = 0; i < flows_.size(); ++i)
  {
    const Flow &flow = flows_[i];
    const double mass = flow.volume * fields[n_fields_ * flow.donor];
    rest.push_back(carried_[n_fields_ * i] - mass);
    add_to_cells(flow, &mass, 1, low);
    add_to_cells(flow, &flow.volume, 1, volumes);
    if (flow.donor < n_own)
      staying[flow.donor] -= std::abs(mass);
  }
  find_room(fields, 0, 1, volumes, low);
  // A cell must not lose more mass than it has, so that other fields stay
  // bounded.
  for (std::size_t c = 0; c < n_own; ++c)
    room_[2 * c + 1] = std::max(0., std::min(room_[2 * c + 1], staying[c]));
  cut(mass_exchange_, 1, rest);
  for (std::size_t i = 0; i < flows_.size(); ++i)
  {
    const double *const field = &fields[n_fields_ * flows_[i].donor];
    double *const carried = &carried_[n_fields_ * i];
    const double mass = flows_[i].volume * field[0] + rest[i];
    for (unsigned int f = 1; f < n_fields_; ++f)
      carried[f] += (mass - carried[0]) * field[f];
    carried[0] = mass;
  }
}


void BoundedFlows::limit_others(const dealii::AlignedVector<double> &fields,
                                const dealii::AlignedVector<double> &masses)
{
  const std::size_t n_own = space_->n_own_cells();
  const unsigned int width = n_fields_ - 1;
  std::vector<double> sizes(masses.begin(), masses.begin() + n_own);
  std::vector<double> low(width * n_own), mean(width), rest;
  for (std::size_t c = 0; c < n_own; ++c)
    for (unsigned int f = 0; f < width; ++f)
      low[width * c + f] = masses[c] * fields[n_fields_ * c + 1 + f];
  // The donor of mass may differ from the donor of volume.
  const auto mean_of = [&](const std::size_t i) {
    const double mass = carried_[n_fields_ * i];
    const HexSpace::Face &face = *flows_[i].face;
    const double *const field =
      &fields[n_fields_ * (mass > 0. ? face.outside : face.inside)];
    for (unsigned int f = 0; f < width; ++f)
      mean[f] = mass * field[1 + f];
    return mean.data();
  };
  for (std::size_t i = 0; i < flows_.size(); ++i)
  {
    const double *const carried = &carried_[n_fields_ * i];
    mean_of(i);
    add_to_cells(flows_[i], carried, 1, sizes);
    add_to_cells(flows_[i], mean.data(), width, low);
    for (unsigned int f = 0; f < width; ++f)
      rest.push_back(carried[1 + f] - mean[f]);
  }
  find_room(fields, 1, width, sizes, low);
  cut(other_exchange_, width, rest);
  for (std::size_t i = 0; i < flows_.size(); ++i)
  {
    mean_of(i);
    for (unsigned int f = 0; f < width; ++f)
      carried_[n_fields_ * i + 1 + f] = mean[f] + rest[width * i + f];
  }
}


void BoundedFlows::find_room(const dealii::AlignedVector<double> &fields,
                             const unsigned int first,
                             const unsigned int width,
                             const std::vector<double> &sizes,
                             const std::vector<double> &low)
{
  room_.resize(2 * width * space_->n_own_cells());
  std::vector<double> least(width), most(width);
  for (std::size_t c = 0; c < space_->n_own_cells(); ++c)
  {
    const double *const own = &fields[n_fields_ * c + first];
    std::copy(own, own + width, least.begin());
    std::copy(own, own + width, most.begin());
    for (const std::uint32_t other : stencil_.neighbors(c))
      for (unsigned int f = 0; f < width; ++f)
      {
        const double value = fields[n_fields_ * other + first + f];
        least[f] = std::min(least[f], value);
        most[f] = std::max(most[f], value);
      }
    for (unsigned int f = 0; f < width; ++f)
    {
      const std::size_t i = width * c + f;
      room_[2 * i] = std::max(0., most[f] * sizes[c] - low[i]);
      room_[2 * i + 1] = std::max(0., low[i] - least[f] * sizes[c]);
    }
  }
}


void BoundedFlows::cut(const FieldExchange &exchange,
                       const unsigned int width,
                       std::vector<double> &rest)
{
  // Sums of inflow and outflow of each cell, then the admissible fractions.
  dealii::AlignedVector<double> parts(exchange.size());
  const auto place =
    [&](const std::size_t cell, const unsigned int f, const bool gains) {
      return 2 * (width * cell + f) + (gains ? 0 : 1);
    };
  for (std::size_t i = 0; i < flows_.size(); ++i)
    for (unsigned int f = 0; f < width; ++f)
    {
      const double value = rest[width * i + f];
      const HexSpace::Face &face = *flows_[i].face;
      parts[place(face.inside, f, value > 0.)] += std::abs(value);
      parts[place(face.outside, f, value < 0.)] += std::abs(value);
    }
  for (std::size_t k = 0; k < room_.size(); ++k)
    parts[k] = parts[k] > room_[k] ? room_[k] / parts[k] : 1.;
  exchange.update_copies(parts);
  for (std::size_t i = 0; i < flows_.size(); ++i)
    for (unsigned int f = 0; f < width; ++f)
    {
      double &value = rest[width * i + f];
      const HexSpace::Face &face = *flows_[i].face;
      value *= std::min(parts[place(face.inside, f, value > 0.)],
                        parts[place(face.outside, f, value < 0.)]);
    }
}
} // namespace contrecoup::ale
