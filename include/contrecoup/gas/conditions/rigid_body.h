// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/region.h>
#include <contrecoup/geometry/body.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

namespace contrecoup::gas
{
/// A rigid body that stands in the gas, as subsection "Rigid body" describes
/// it. In 2-D it is cut at z = 0, and in axisymmetric geometry that cut is
/// turned about the axis, x = 0.
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

  /// Whether a run needs the body in at least one cell.
  bool is_required() const
  {
    return is_required_;
  }

  /// Whether there is none.
  bool empty() const
  {
    return shape_ == nullptr;
  }

  Treatment treatment() const
  {
    return treatment_;
  }

  /// @throws InputError for regions without @p dim coordinates.
  void check(const unsigned int dim) const;

  /// Times that coarse leaves at the surface stay halved beyond the initial
  /// refinement, where no finer region is.
  unsigned int levels() const
  {
    return levels_;
  }

  /// The same of a leaf between two corners [m].
  template <int dim>
  unsigned int levels(const dealii::Point<dim> &lower,
                      const dealii::Point<dim> &upper) const
  {
    unsigned int result = levels_;
    for (const FinerRegion &finer : finer_regions_)
      if (finer.levels > result && finer.region.meets(lower, upper))
        result = finer.levels;
    return result;
  }

  /// Diagonals of leaves of that size that fit between the ball around a leaf
  /// and the surface, negative where they meet; inside of the body, where none
  /// are wanted beside those at the surface, one more.
  /// @param halvings times that this leaf has been halved beyond the initial
  /// refinement
  template <int dim>
  double layers_to(const dealii::Point<dim> &lower,
                   const dealii::Point<dim> &upper,
                   const int halvings) const;

  /// What layers_to() is at most for leaves at the body: those that it cuts,
  /// and their neighbours.
  static constexpr double at_body = 1. + 1e-9;

  /// The most that levels() gives.
  unsigned int most_levels() const;

  /// Shape::value() at a place in the gas's coordinates [m].
  template <int dim>
  double value(const dealii::Point<dim> &place) const
  {
    dealii::Point<3> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = place[d];
    return shape_->value(point);
  }

  /// value() in the middle of a leaf, remembered, since it is asked for each
  /// time that the mesh changes.
  template <int dim>
  double value_in_leaf(const dealii::Point<dim> &middle) const;

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
  struct FinerRegion
  {
    std::string name;
    Region region;
    unsigned int levels = 0;
  };

  ShapePointer shape_;
  std::vector<Landmark> landmarks_;
  Treatment treatment_ = Treatment::embedded;
  unsigned int levels_ = 0;
  bool is_required_ = true;
  std::vector<FinerRegion> finer_regions_;
  using Place = std::array<double, 3>;
  mutable std::unordered_map<Place, double, boost::hash<Place>> known_values_;
};
} // namespace contrecoup::gas
