// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/materials/gas_material.h>

#include <functional>
#include <vector>

namespace contrecoup::gas
{
/**
 * Interpolates conserved quantities of a leaf to its children and restricts
 * those of children to their parent. Conserves each quantity to round-off and
 * keeps every state admissible. Leaf values are [component][point].
 */
template <int dim>
class LeafTransfer
{
public:
  static constexpr unsigned int n_children = 1U << dim;

  LeafTransfer(const LeafPoints<dim> &points,
               const LeafLayout &layout,
               const GasMaterial &material);

  /// Values of all children of a leaf, in deal.II's order. Finite volumes:
  /// limited linear reconstruction, replaced by a constant in a subcell where
  /// a part would be inadmissible. Galerkin: the same polynomial; if a child
  /// would be inadmissible, all children are scaled towards the mean of the
  /// leaf by one factor.
  std::vector<std::vector<double>>
  to_children(const std::vector<double> &parent,
              const LeafBox<dim> &parent_box) const;

  /// Values of a leaf from its children: volume means (finite volumes) or the
  /// L2 projection (Galerkin), scaled towards its mean where a node would be
  /// inadmissible.
  std::vector<double>
  from_children(const std::vector<std::vector<double>> &children,
                const LeafBox<dim> &parent_box) const;

private:
  using Matrices =
    std::function<const dealii::FullMatrix<double> &(unsigned int)>;

  /// Whether the state with the components @p first, @p first + stride, ... is
  /// admissible.
  bool is_admissible(const double *first, const unsigned int stride) const;
  bool is_admissible(const std::vector<double> &values) const;
  /// Whether all points of the leaf hold the same state.
  bool is_uniform(const std::vector<double> &values) const;
  std::vector<double> apply(const std::vector<double> &values,
                            const Matrices &matrices,
                            const unsigned int child) const;
  std::vector<std::vector<double>>
  interpolated_children(const std::vector<double> &parent,
                        const LeafBox<dim> &parent_box) const;
  std::vector<std::vector<double>>
  reconstructed_children(const std::vector<double> &parent,
                         const LeafBox<dim> &parent_box) const;
  std::vector<double>
  projected_parent(const std::vector<std::vector<double>> &children,
                   const LeafBox<dim> &parent_box) const;
  std::vector<double>
  averaged_parent(const std::vector<std::vector<double>> &children,
                  const LeafBox<dim> &parent_box) const;
  /// Scales all leaves towards @p mean by one factor such that all points are
  /// admissible.
  void make_admissible(std::vector<std::vector<double>> &leaves,
                       const std::vector<double> &mean) const;
  /// Values of the 2^dim parts of one subcell, [part][component].
  std::array<std::vector<double>, n_children>
  subcell_parts(const std::vector<double> &parent,
                const LeafBox<dim> &parent_box,
                const unsigned int point) const;
  void scale(std::vector<double> &values,
             const std::vector<double> &mean,
             const double theta) const;
  /// Mean of each component over the leaf's volume.
  std::vector<double> mean(const std::vector<double> &values,
                           const LeafBox<dim> &box) const;
  /// In curvilinear geometry, adds a constant to each component of @p to, so
  /// that its integral equals that of @p from.
  void balance(const std::vector<std::vector<double>> &from,
               const std::vector<LeafBox<dim>> &from_boxes,
               std::vector<std::vector<double>> &to,
               const std::vector<LeafBox<dim>> &to_boxes) const;

  const LeafPoints<dim> points_;
  const LeafLayout layout_;
  const GasMaterial material_;
};
} // namespace contrecoup::gas
