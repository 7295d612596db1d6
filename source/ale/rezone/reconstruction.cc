// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/ale/rezone/reconstruction.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  /// Whether second differences @p a and @p b indicate a smooth extremum.
  bool alike(const double a, const double b)
  {
    return a * b > 0. && std::abs(b) > 0.5 * std::abs(a) &&
           std::abs(b) < 2. * std::abs(a);
  }

  /// Largest fraction of a change that stays within @p least <= 0 and @p most
  /// >= 0, with tolerance for round-off of values of this size.
  double allowed_fraction(const double change,
                          const double least,
                          const double most,
                          const double size)
  {
    const double margin = (change > 0. ? most : -least) + 1e-13 * size;
    return std::abs(change) > margin ? margin / std::abs(change) : 1.;
  }
  /// Eigenvector of the dominant eigenvalue of a nearly rank-one matrix.
  Vector3<double> direction_of(const Matrix3<double> &matrix)
  {
    unsigned int largest = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (matrix[d][d] > matrix[largest][largest])
        largest = d;
    Vector3<double> result = matrix[largest];
    const double length = std::sqrt(dot(result, result));
    for (double &value : result)
      value /= length;
    return result;
  }

  /// Pseudo-inverse of a least squares matrix. Nearly singular directions, as
  /// in a slab of one cell, are left out because they would be noise.
  Matrix3<double> inverse_where_known(Matrix3<double> sum)
  {
    // Squared sine of an angle of a hundredth of a degree.
    constexpr double least = 3e-8;
    const double trace = sum[0][0] + sum[1][1] + sum[2][2];
    Matrix3<double> c = cofactor(sum);
    const double planes = c[0][0] + c[1][1] + c[2][2];
    Matrix3<double> result{};
    if (!(planes > least * trace * trace))
    {
      if (!(trace > 0.))
        return result;
      const Vector3<double> line = direction_of(sum);
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int e = 0; e < 3; ++e)
          result[d][e] = line[d] * line[e] / trace;
      return result;
    }
    const bool is_flat =
      !(sum[0][0] * c[0][0] + sum[0][1] * c[0][1] + sum[0][2] * c[0][2] >
        least * trace * planes);
    const Vector3<double> normal =
      is_flat ? direction_of(c) : Vector3<double>{};
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int e = 0; e < 3; ++e)
        sum[d][e] += trace * normal[d] * normal[e];
    c = cofactor(sum);
    const double scale =
      1. / (sum[0][0] * c[0][0] + sum[0][1] * c[0][1] + sum[0][2] * c[0][2]);
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int e = 0; e < 3; ++e)
        result[d][e] =
          scale * c[d][e] - (is_flat ? normal[d] * normal[e] / trace : 0.);
    return result;
  }
} // namespace


void Reconstruction::reinit(const HexSpace &space,
                            const unsigned int n_fields,
                            const std::vector<bool> &is_left_out,
                            const RemapLimiter limiter)
{
  space_ = &space;
  limiter_ = limiter;
  cells_.clear();
  all_cells_.clear();
  for (std::uint32_t c = 0; c < space.n_cells(); ++c)
    if (is_left_out.empty() || !is_left_out[space.region(c)])
    {
      all_cells_.push_back(c);
      if (c < space.n_locally_owned_cells())
        cells_.push_back(c);
    }
  n_fields_ = n_fields;
  gradient_exchange_.reinit(space.cells(), 3 * n_fields);
  curvature_exchange_.reinit(space.cells(), n_fields);
  gradients_.resize(gradient_exchange_.size());
  curvatures_.resize(curvature_exchange_.size());
  smallest_.resize(n_fields);
  largest_.resize(n_fields);
  factor_.resize(n_fields);

  stencil_.reinit(space);
  find_slots(is_left_out);
}


void Reconstruction::find_slots(const std::vector<bool> &is_left_out)
{
  is_left_out_ = is_left_out;
  slots_.assign(space_->n_nodes(), no_slot);
  slot_nodes_.clear();
  std::vector<bool> is_seen(space_->n_nodes());
  for (const std::uint32_t cell : cells_)
    for (const std::uint32_t node : space_->cell(cell))
    {
      if (is_seen[node])
        continue;
      is_seen[node] = true;
      const auto around = space_->cells_around(node);
      if (std::all_of(
            around.begin(), around.end(), [&](const std::uint32_t other) {
              const unsigned int region = space_->region(other);
              return region == space_->region(cell) ||
                     (!is_left_out.empty() && is_left_out[region]);
            }))
      {
        slots_[node] = slot_nodes_.size();
        slot_nodes_.push_back(node);
      }
    }
  extrema_.resize(2 * n_fields_ * slot_nodes_.size());
}


void Reconstruction::find_extrema(const dealii::AlignedVector<double> &fields)
{
  for (std::size_t slot = 0; slot < slot_nodes_.size(); ++slot)
  {
    double *const least = &extrema_[2 * n_fields_ * slot];
    double *const most = least + n_fields_;
    std::fill(least, most, std::numeric_limits<double>::max());
    std::fill(most, most + n_fields_, -std::numeric_limits<double>::max());
    for (const std::uint32_t cell : space_->cells_around(slot_nodes_[slot]))
    {
      if (!is_left_out_.empty() && is_left_out_[space_->region(cell)])
        continue;
      const double *const values = &fields[n_fields_ * cell];
      for (unsigned int f = 0; f < n_fields_; ++f)
      {
        least[f] = std::min(least[f], values[f]);
        most[f] = std::max(most[f], values[f]);
      }
    }
  }
}


void Reconstruction::compute(const dealii::AlignedVector<double> &position,
                             const dealii::AlignedVector<double> &fields)
{
  position_ = &position;
  find_centres(position);
  find_extrema(fields);
  for (const std::uint32_t c : cells_)
    find_gradients(fields, c);
  if (limiter_ == RemapLimiter::keep_smooth_extrema)
  {
    for (const std::uint32_t c : cells_)
      find_curvatures(fields, c);
    curvature_exchange_.update_ghost_values(curvatures_);
  }
  for (const std::uint32_t c : cells_)
    limit_inside(fields, c);
  // Cells at edges use limited gradients of cells at sides, and these those of
  // interior cells.
  for (unsigned int n_walls = 1; n_walls <= 3; ++n_walls)
  {
    gradient_exchange_.update_ghost_values(gradients_);
    for (const std::uint32_t c : cells_)
      if (stencil_.cells_opposite_to_walls(c).size() == n_walls)
        limit_towards_walls(fields, c);
  }
  gradient_exchange_.update_ghost_values(gradients_);
}


void Reconstruction::find_centres(const dealii::AlignedVector<double> &position)
{
  volumes_.resize(space_->n_cells());
  centres_.resize(space_->n_cells());
  for (const std::uint32_t c : all_cells_)
  {
    const auto moments = hex_moments(corners_of(space_->cell(c), position));
    volumes_[c] = moments.volume;
    for (unsigned int d = 0; d < 3; ++d)
      centres_[c][d] = moments.first[d] / moments.volume;
  }
}


void Reconstruction::find_gradients(const dealii::AlignedVector<double> &fields,
                                    const std::size_t cell)
{
  double *gradient = &gradients_[3 * n_fields_ * cell];
  std::fill(gradient, gradient + 3 * n_fields_, 0.);
  const double *own = &fields[n_fields_ * cell];
  Matrix3<double> sum{};
  for (const std::uint32_t neighbor : stencil_.neighbors(cell))
  {
    const auto way = centres_[neighbor] - centres_[cell];
    const double weight = 1. / way.norm_square();
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int e = 0; e < 3; ++e)
        sum[d][e] += weight * way[d] * way[e];
    const double *other = &fields[n_fields_ * neighbor];
    for (unsigned int f = 0; f < n_fields_; ++f)
      for (unsigned int d = 0; d < 3; ++d)
        gradient[3 * f + d] += weight * way[d] * (other[f] - own[f]);
  }
  const Matrix3<double> inverse = inverse_where_known(sum);
  for (unsigned int f = 0; f < n_fields_; ++f)
  {
    double *g = gradient + 3 * f;
    const Vector3<double> b{{g[0], g[1], g[2]}};
    for (unsigned int d = 0; d < 3; ++d)
      g[d] = dot(inverse[d], b);
  }
}


void Reconstruction::find_curvatures(
  const dealii::AlignedVector<double> &fields,
  const std::size_t cell)
{
  double *curvature = &curvatures_[n_fields_ * cell];
  std::fill(curvature, curvature + n_fields_, 0.);
  const double *own = &fields[n_fields_ * cell];
  for (const std::uint32_t neighbor : stencil_.neighbors(cell))
  {
    const auto way = centres_[neighbor] - centres_[cell];
    const double *other = &fields[n_fields_ * neighbor];
    for (unsigned int f = 0; f < n_fields_; ++f)
      curvature[f] += other[f] - own[f] - change(cell, f, way);
  }
}


double Reconstruction::change(const std::size_t cell,
                              const unsigned int field,
                              const dealii::Tensor<1, 3> &way) const
{
  const double *g = gradient(cell, field);
  return g[0] * way[0] + g[1] * way[1] + g[2] * way[2];
}


dealii::Point<3> Reconstruction::place(const std::size_t node) const
{
  const double *x = &(*position_)[node_width * node];
  return {x[0], x[1], x[2]};
}


bool Reconstruction::is_smooth(const std::size_t cell,
                               const unsigned int field) const
{
  if (limiter_ == RemapLimiter::strict)
    return false;
  const auto neighbors = stencil_.neighbors(cell);
  const double own = curvatures_[n_fields_ * cell + field];
  return std::all_of(
    neighbors.begin(), neighbors.end(), [&](const std::uint32_t other) {
      return alike(own, curvatures_[n_fields_ * other + field]);
    });
}


void Reconstruction::extend_bounds(const dealii::AlignedVector<double> &fields,
                                   const std::size_t cell,
                                   const std::uint32_t node)
{
  const auto add = [&](const double *const least, const double *const most) {
    for (unsigned int f = 0; f < n_fields_; ++f)
    {
      smallest_[f] = std::min(smallest_[f], least[f]);
      largest_[f] = std::max(largest_[f], most[f]);
    }
  };
  if (slots_[node] != no_slot)
  {
    const double *const least = &extrema_[2 * n_fields_ * slots_[node]];
    return add(least, least + n_fields_);
  }
  for (const std::uint32_t other : space_->cells_around(node))
    if (space_->region(other) == space_->region(cell))
      add(&fields[n_fields_ * other], &fields[n_fields_ * other]);
}


void Reconstruction::limit_at(
  const dealii::AlignedVector<double> &fields,
  const std::size_t cell,
  const dealii::ArrayView<const std::uint32_t> &nodes)
{
  const double *own = &fields[n_fields_ * cell];
  std::copy(own, own + n_fields_, smallest_.begin());
  std::copy(own, own + n_fields_, largest_.begin());
  dealii::Point<3> centre;
  for (const std::uint32_t node : nodes)
  {
    centre += place(node) / static_cast<double>(nodes.size());
    extend_bounds(fields, cell, node);
  }
  const auto way = centre - centres_[cell];
  for (unsigned int f = 0; f < n_fields_; ++f)
    factor_[f] =
      std::min(factor_[f],
               allowed_fraction(change(cell, f, way),
                                smallest_[f] - own[f],
                                largest_[f] - own[f],
                                std::max(-smallest_[f], largest_[f])));
}


void Reconstruction::limit_inside(const dealii::AlignedVector<double> &fields,
                                  const std::size_t cell)
{
  std::fill(factor_.begin(), factor_.end(), 1.);
  for (const std::uint32_t face : stencil_.faces(cell))
  {
    const auto &nodes = space_->faces()[face].nodes;
    limit_at(fields, cell, {nodes.data(), nodes.size()});
  }
  for (const std::uint32_t node : space_->cell(cell))
    if (stencil_.is_inside(node))
      limit_at(fields, cell, {&node, 1});
  apply_factors(cell);
}


void Reconstruction::limit_towards_walls(
  const dealii::AlignedVector<double> &fields,
  const std::size_t cell)
{
  std::fill(factor_.begin(), factor_.end(), 1.);
  const double *own = &fields[n_fields_ * cell];
  for (const std::uint32_t node : space_->cell(cell))
  {
    if (stencil_.is_inside(node))
      continue;
    const auto way = place(node) - centres_[cell];
    for (unsigned int f = 0; f < n_fields_; ++f)
    {
      double least = 0., most = 0., size = std::abs(own[f]);
      for (const std::uint32_t other : stencil_.cells_opposite_to_walls(cell))
      {
        const double value = fields[n_fields_ * other + f] - own[f] +
                             change(other, f, place(node) - centres_[other]);
        least = std::min(least, value);
        most = std::max(most, value);
        size = std::max(size, std::abs(fields[n_fields_ * other + f]));
      }
      factor_[f] = std::min(
        factor_[f], allowed_fraction(change(cell, f, way), least, most, size));
    }
  }
  apply_factors(cell);
}


void Reconstruction::apply_factors(const std::size_t cell)
{
  double *gradient = &gradients_[3 * n_fields_ * cell];
  for (unsigned int f = 0; f < n_fields_; ++f)
    if (factor_[f] < 1. && !is_smooth(cell, f))
      for (unsigned int d = 0; d < 3; ++d)
        gradient[3 * f + d] *= factor_[f];
}
} // namespace contrecoup::ale
