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
    if (inside < space_->n_locally_owned_cells())
      contents[width * inside + f] += carried[f];
    if (outside < space_->n_locally_owned_cells())
      contents[width * outside + f] -= carried[f];
  }
}


void BoundedFlows::limit_masses(const dealii::AlignedVector<double> &fields,
                                const dealii::AlignedVector<double> &masses)
{
  const std::size_t n_own = space_->n_locally_owned_cells();
  std::vector<double> low(masses.begin(), masses.begin() + n_own);
  std::vector<double> staying = low, volumes(n_own), corrections;
  for (std::size_t c = 0; c < n_own; ++c)
    volumes[c] =
      fields[n_fields_ * c] > 0. ? masses[c] / fields[n_fields_ * c] : 0.;
  for (std::size_t i = 0; i < flows_.size(); ++i)
  {
    const Flow &flow = flows_[i];
    const double mass = flow.volume * fields[n_fields_ * flow.donor];
    corrections.push_back(carried_[n_fields_ * i] - mass);
    add_to_cells(flow, &mass, 1, low);
    add_to_cells(flow, &flow.volume, 1, volumes);
    if (flow.donor < n_own)
      staying[flow.donor] -= std::abs(mass);
  }
  find_capacity(fields, 0, 1, volumes, low);
  // A cell must not lose more mass than it has, so that other fields stay
  // bounded.
  for (std::size_t c = 0; c < n_own; ++c)
    capacity_[2 * c + 1] =
      std::max(0., std::min(capacity_[2 * c + 1], staying[c]));
  limit_corrections(mass_exchange_, 1, corrections);
  for (std::size_t i = 0; i < flows_.size(); ++i)
  {
    const double *const field = &fields[n_fields_ * flows_[i].donor];
    double *const carried = &carried_[n_fields_ * i];
    const double mass = flows_[i].volume * field[0] + corrections[i];
    for (unsigned int f = 1; f < n_fields_; ++f)
      carried[f] += (mass - carried[0]) * field[f];
    carried[0] = mass;
  }
}


void BoundedFlows::limit_others(const dealii::AlignedVector<double> &fields,
                                const dealii::AlignedVector<double> &masses)
{
  const std::size_t n_own = space_->n_locally_owned_cells();
  const unsigned int width = n_fields_ - 1;
  std::vector<double> sizes(masses.begin(), masses.begin() + n_own);
  std::vector<double> low(width * n_own), mean(width), corrections;
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
      corrections.push_back(carried[1 + f] - mean[f]);
  }
  find_capacity(fields, 1, width, sizes, low);
  limit_corrections(other_exchange_, width, corrections);
  for (std::size_t i = 0; i < flows_.size(); ++i)
  {
    mean_of(i);
    for (unsigned int f = 0; f < width; ++f)
      carried_[n_fields_ * i + 1 + f] = mean[f] + corrections[width * i + f];
  }
}


void BoundedFlows::find_capacity(const dealii::AlignedVector<double> &fields,
                                 const unsigned int first,
                                 const unsigned int width,
                                 const std::vector<double> &sizes,
                                 const std::vector<double> &low)
{
  capacity_.resize(2 * width * space_->n_locally_owned_cells());
  std::vector<double> smallest(width), largest(width);
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
  {
    const double *const own = &fields[n_fields_ * c + first];
    std::copy(own, own + width, smallest.begin());
    std::copy(own, own + width, largest.begin());
    for (const std::uint32_t other : stencil_.neighbors(c))
      for (unsigned int f = 0; f < width; ++f)
      {
        const double value = fields[n_fields_ * other + first + f];
        smallest[f] = std::min(smallest[f], value);
        largest[f] = std::max(largest[f], value);
      }
    for (unsigned int f = 0; f < width; ++f)
    {
      const std::size_t i = width * c + f;
      capacity_[2 * i] = std::max(0., largest[f] * sizes[c] - low[i]);
      capacity_[2 * i + 1] = std::max(0., low[i] - smallest[f] * sizes[c]);
    }
  }
}


void BoundedFlows::limit_corrections(const FieldExchange &exchange,
                                     const unsigned int width,
                                     std::vector<double> &corrections)
{
  // Sums of inflow and outflow of each cell, then the admissible fractions.
  dealii::AlignedVector<double> fractions(exchange.size());
  const auto index =
    [&](const std::size_t cell, const unsigned int f, const bool gains) {
      return 2 * (width * cell + f) + (gains ? 0 : 1);
    };
  for (std::size_t i = 0; i < flows_.size(); ++i)
    for (unsigned int f = 0; f < width; ++f)
    {
      const double value = corrections[width * i + f];
      const HexSpace::Face &face = *flows_[i].face;
      fractions[index(face.inside, f, value > 0.)] += std::abs(value);
      fractions[index(face.outside, f, value < 0.)] += std::abs(value);
    }
  for (std::size_t k = 0; k < capacity_.size(); ++k)
    fractions[k] =
      fractions[k] > capacity_[k] ? capacity_[k] / fractions[k] : 1.;
  exchange.update_ghost_values(fractions);
  for (std::size_t i = 0; i < flows_.size(); ++i)
    for (unsigned int f = 0; f < width; ++f)
    {
      double &value = corrections[width * i + f];
      const HexSpace::Face &face = *flows_[i].face;
      value *= std::min(fractions[index(face.inside, f, value > 0.)],
                        fractions[index(face.outside, f, value < 0.)]);
    }
}
} // namespace contrecoup::ale
