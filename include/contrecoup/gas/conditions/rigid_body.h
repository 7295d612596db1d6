// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/region.h>
#include <contrecoup/geometry/body/body.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

namespace contrecoup::gas
{
/// Fixed rigid body in the gas, read from subsection "Rigid body". In 2-D the
/// body is its cross-section at z = 0; in axisymmetric geometry that section
/// is revolved about the axis, x = 0.
class RigidBody
{
public:
  enum class Treatment
  {
    embedded, ///< the surface cuts subcells
    staircase ///< a subcell is gas or body, by its centre
  };

  /// Declares subsections "Rigid body" and "Body".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when the body cannot be built.
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether a run is refused if the body covers no subcell.
  bool is_required() const
  {
    return is_required_;
  }

  /// Mass of the phantom that the body is [kg]; NaN for other bodies.
  double phantom_mass() const
  {
    return phantom_mass_;
  }

  /// Whether there is no body.
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

  /// Refinement level of leaves at the surface, above the initial refinement,
  /// outside of finer regions.
  unsigned int levels() const
  {
    return levels_;
  }

  /// Refinement level of a leaf between two corners [m] at the surface, above
  /// the initial refinement.
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

  /// Distance from the circumscribed ball of a leaf to the surface, in
  /// diagonals of a leaf of refinement level levels() [-]; negative where they
  /// intersect. Inside the body, where leaves are refined only at the surface,
  /// the result is larger by max_diagonals_at_body.
  /// @param level_above_initial refinement level of this leaf above the initial
  /// refinement
  template <int dim>
  double leaf_diagonals_to(const dealii::Point<dim> &lower,
                           const dealii::Point<dim> &upper,
                           const int level_above_initial) const;

  /// Upper bound of leaf_diagonals_to() for leaves that the body cuts and their
  /// neighbours.
  static constexpr double max_diagonals_at_body = 1. + 1e-9;

  /// Largest value of levels().
  unsigned int most_levels() const;

  /// Shape::value() at a position in the coordinates of the gas [m].
  template <int dim>
  double value(const dealii::Point<dim> &place) const
  {
    dealii::Point<3> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = place[d];
    return shape_->value(point);
  }

  /// value() at the centre of a leaf, cached: every change of the mesh needs
  /// it.
  template <int dim>
  double value_in_leaf(const dealii::Point<dim> &middle) const;

  /// Projection of a position onto the surface, see Shape::project().
  template <int dim>
  dealii::Point<3> project(const dealii::Point<dim> &place) const
  {
    dealii::Point<3> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = place[d];
    return shape_->project(point);
  }

  /// Outward unit normal of the body at a position on its surface.
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
  double phantom_mass_ = std::numeric_limits<double>::quiet_NaN(); ///< [kg]
  Treatment treatment_ = Treatment::embedded;
  unsigned int levels_ = 0;
  bool is_required_ = true;
  std::vector<FinerRegion> finer_regions_;
  using Place = std::array<double, 3>;
  mutable std::unordered_map<Place, double, boost::hash<Place>> known_values_;
};
} // namespace contrecoup::gas
