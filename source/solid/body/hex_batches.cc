// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/hex_batches.h>

namespace contrecoup::solid
{
namespace
{
  constexpr unsigned int corner_sign[8][3] = {{0, 0, 0},
                                              {1, 0, 0},
                                              {1, 1, 0},
                                              {0, 1, 0},
                                              {0, 0, 1},
                                              {1, 0, 1},
                                              {1, 1, 1},
                                              {0, 1, 1}};
} // namespace


template <typename Real>
void HexBatches<Real>::reinit(const SolidMesh &mesh,
                              const std::vector<bool> &viscoelastic,
                              const std::vector<bool> &damped,
                              const std::vector<bool> &smoothed,
                              const unsigned int n_points)
{
  n_points_ = n_points;
  ranges_.clear();
  cells_.clear();
  slots_.assign(mesh.elements.size(), spare);
  unsigned int n_relaxed = 0, n_damping = 0;
  bool any_smoothed = false;
  for (std::uint32_t first = 0; first < mesh.elements.size();)
  {
    std::uint32_t last = first;
    for (;
         last < mesh.elements.size() && mesh.tissue[last] == mesh.tissue[first];
         ++last)
    {
      slots_[last] = static_cast<std::uint32_t>(cells_.size());
      cells_.push_back(last);
    }
    cells_.resize((cells_.size() + n - 1) / n * n, spare);
    const unsigned int begin = ranges_.empty() ? 0 : ranges_.back().end;
    const auto end = static_cast<unsigned int>(cells_.size() / n);
    const unsigned int tissue = mesh.tissue[first];
    ranges_.push_back({tissue,
                       begin,
                       end,
                       viscoelastic[tissue],
                       n_relaxed,
                       damped[tissue],
                       n_damping,
                       smoothed[tissue]});
    any_smoothed = any_smoothed || smoothed[tissue];
    if (viscoelastic[tissue])
      n_relaxed += 6 * n_points * (end - begin);
    if (damped[tissue])
      n_damping += 12 * (end - begin);
    first = last;
  }

  const auto spare_node = static_cast<unsigned int>(mesh.nodes.size());
  offsets_.resize(8 * cells_.size());
  for (std::size_t slot = 0; slot < cells_.size(); ++slot)
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      const unsigned int node = cells_[slot] == spare
                                  ? spare_node + corner
                                  : mesh.elements[cells_[slot]][corner];
      offsets_[(slot / n * 8 + corner) * n + slot % n] =
        NodeFields<Real>::width * node;
    }
  dilatation.resize(cells_.size() / n);
  viscous_pressure.resize(cells_.size() / n);
  smoothing_pressure.resize(any_smoothed ? cells_.size() / n : 0);
  smooth_dilatation.resize(smoothing_pressure.size());
  relaxed.resize(n_relaxed);
  damping.resize(n_damping);
  reset_state();
}


template <typename Real>
void HexBatches<Real>::activate(const unsigned int batch,
                                const NodeFields<Real> &nodes)
{
  constexpr unsigned int numbers =
    NodeFields<Real>::width * NodeFields<Real>::block;
  const unsigned int *offset = offsets(batch, 0);
  unsigned int any = 0;
  for (unsigned int i = 0; i < 8 * n; ++i)
    any |= nodes.active[offset[i] / numbers];
  active_[batch] = static_cast<unsigned char>(any);
  n_active_ += any;
}


template <typename Real>
void HexBatches<Real>::activate_all()
{
  active_.assign(n_batches(), 1);
  n_active_ = n_batches();
}


template <typename Real>
void HexBatches<Real>::reset_state()
{
  dilatation.fill(Lane(Real()));
  viscous_pressure.fill(Lane(Real()));
  smoothing_pressure.fill(Lane(Real()));
  smooth_dilatation.fill(Lane(Real()));
  relaxed.fill(Lane(Real()));
  active_.assign(n_batches(), 0);
  n_active_ = 0;
  damping.fill(Lane(Real()));
}


template <typename Real>
void HexBatches<Real>::reinit_nodes(const SolidMesh &mesh,
                                    NodeFields<Real> &nodes)
{
  nodes.reinit(mesh.nodes.size() + 8);
  const auto coordinate = [&](const std::size_t node,
                              const unsigned int d) -> Real & {
    return nodes
      .position_and_displacement[NodeFields<Real>::position_width * node + d];
  };
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      coordinate(i, d) = static_cast<Real>(mesh.nodes[i][d]);
  for (unsigned int corner = 0; corner < 8; ++corner)
    for (unsigned int d = 0; d < 3; ++d)
      coordinate(mesh.nodes.size() + corner, d) = Real(corner_sign[corner][d]);
}


template <typename Real>
double HexBatches<Real>::memory() const
{
  return static_cast<double>(
    offsets_.memory_consumption() + dilatation.memory_consumption() +
    viscous_pressure.memory_consumption() +
    smoothing_pressure.memory_consumption() +
    smooth_dilatation.memory_consumption() + relaxed.memory_consumption() +
    damping.memory_consumption() + 4 * (cells_.capacity() + slots_.capacity()));
}


template class HexBatches<double>;
template class HexBatches<float>;
} // namespace contrecoup::solid
