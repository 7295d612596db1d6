// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>

namespace contrecoup::gas
{
/// A rigid body that stands in the gas, as subsection "Rigid body" describes
/// it. In 2-D it is cut at z = 0.
class RigidBody
{
public:
  enum class Treatment
  {
    embedded, ///< cells are cut by the surface
    staircase ///< cells are gas or body by their centre
  };

  /// Declares subsections "Rigid body" and "Body".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when the body cannot be made.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether there is none.
  bool empty() const
  {
    return shape_ == nullptr;
  }

  Treatment treatment() const
  {
    return treatment_;
  }

  /// Times that coarse leaves at the surface stay halved beyond the initial
  /// refinement.
  unsigned int levels() const
  {
    return levels_;
  }

  /// Shape::value() at a place in the gas's coordinates [m].
  template <int dim>
  double value(const dealii::Point<dim> &place) const
  {
    dealii::Point<3> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = place[d];
    return shape_->value(point);
  }

  /// A point of the surface near a place, see Shape::project().
  template <int dim>
  dealii::Point<3> project(const dealii::Point<dim> &place) const
  {
    dealii::Point<3> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = place[d];
    return shape_->project(point);
  }

  /// The unit normal out of the body at a place of its surface.
  dealii::Tensor<1, 3> normal(const dealii::Point<3> &place) const
  {
    return shape_->normal(place);
  }

  const std::vector<Landmark> &landmarks() const
  {
    return landmarks_;
  }

private:
  ShapePointer shape_;
  std::vector<Landmark> landmarks_;
  Treatment treatment_ = Treatment::embedded;
  unsigned int levels_ = 0;
};
} // namespace contrecoup::gas
