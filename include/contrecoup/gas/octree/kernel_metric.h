// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_metric.h>

#include <type_traits>

namespace contrecoup::gas
{
/**
 * Face areas and volumes of the subcells of one batch in single precision:
 * those of LeafMetric, rounded. Two leaves compute the area of their common
 * face separately, in double precision; rounded, both values are nearly always
 * equal to the last bit. A uniform flow keeps seven digits.
 */
template <int dim>
class SingleLeafMetric
{
public:
  using Number = Lanes<float>;
  using Vector = dealii::Tensor<1, dim, Number>;

  /// @param n subcells per direction
  explicit SingleLeafMetric(const unsigned int n)
    : metrics_(n_lanes<float> / double_width, LeafMetric<dim>(n))
    , n_(n)
    , n_face_points_(dealii::Utilities::pow(n, dim - 1))
    , areas_(dim * (n + 1) * n_face_points_)
    , volumes_(n * n_face_points_)
  {}

  /// See LeafMetric::reinit(); @p batch is one of n_lanes<float> leaves.
  void reinit(const LeafMesh<dim> &mesh, const unsigned int batch)
  {
    for (unsigned int part = 0; part < metrics_.size(); ++part)
      metrics_[part].reinit(mesh, batch * metrics_.size() + part);
    for (unsigned int direction = 0; direction < dim; ++direction)
      for (unsigned int layer = 0; layer <= n_; ++layer)
        for (unsigned int line = 0; line < n_face_points_; ++line)
          areas_[face(direction, layer, line)] =
            rounded([&](const LeafMetric<dim> &metric) {
              return metric.area(direction, layer, line);
            });
    for (unsigned int q = 0; q < volumes_.size(); ++q)
      for (unsigned int lane = 0; lane < n_lanes<float>; ++lane)
        volumes_[q][lane] =
          metrics_[lane / double_width].volume(q)[lane % double_width];
  }

  /// See LeafMetric.
  const Vector &area(const unsigned int direction,
                     const unsigned int layer,
                     const unsigned int line) const
  {
    return areas_[face(direction, layer, line)];
  }
  /// See LeafMetric.
  Vector face_center(const unsigned int direction,
                     const unsigned int layer,
                     const unsigned int line) const
  {
    return rounded([&](const LeafMetric<dim> &metric) {
      return metric.face_center(direction, layer, line);
    });
  }
  /// See LeafMetric.
  Vector tangent(const unsigned int direction,
                 const unsigned int layer,
                 const unsigned int line,
                 const unsigned int along) const
  {
    return rounded([&](const LeafMetric<dim> &metric) {
      return metric.tangent(direction, layer, line, along);
    });
  }
  /// See LeafMetric.
  const Number &volume(const unsigned int point) const
  {
    return volumes_[point];
  }

private:
  unsigned int face(const unsigned int direction,
                    const unsigned int layer,
                    const unsigned int line) const
  {
    return (direction * (n_ + 1) + layer) * n_face_points_ + line;
  }

  /// The vectors of all lanes that @p vector_of gives for each metric.
  template <typename VectorOf>
  Vector rounded(const VectorOf &vector_of) const
  {
    Vector result;
    for (unsigned int part = 0; part < metrics_.size(); ++part)
    {
      const auto from = vector_of(metrics_[part]);
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int lane = 0; lane < double_width; ++lane)
          result[d][part * double_width + lane] = from[d][lane];
    }
    return result;
  }

  std::vector<LeafMetric<dim>> metrics_; ///< of parts of the batch
  unsigned int n_;
  unsigned int n_face_points_;
  dealii::AlignedVector<Vector> areas_;
  dealii::AlignedVector<Number> volumes_;
};

/// The metric of a kernel that computes in @p Real.
template <int dim, typename Real>
using KernelMetric = std::conditional_t<std::is_same_v<Real, float>,
                                        SingleLeafMetric<dim>,
                                        LeafMetric<dim>>;
} // namespace contrecoup::gas
