// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/person_layers.h>
#include <contrecoup/geometry/body/person_regions.h>

#include <utility>
#include <vector>

namespace contrecoup
{
/// Layers of a person whose legs are found; see find_regions().
class PersonLegs : protected PersonLayers
{
protected:
  using PersonLayers::PersonLayers;

  /// Labels the legs and, of who sits, the thighs; finds soles and crotch, and
  /// the trunk's patch there.
  /// @throws InputError if there are not two legs that join
  void find_legs();

  /// Thighs of who stands that touch each other are legs up to the usual height
  /// of the crotch; needs the vertex and the trunk's patches.
  void raise_crotch();

  bool is(const std::size_t voxel, const Region region) const
  {
    return grid_.labels[voxel] == static_cast<unsigned char>(region);
  }

  dealii::Point<3> place_of(const std::size_t voxel) const
  {
    return grid_.center(
      voxel % grid_.size[0], column(voxel), voxel / layer_size());
  }

  PersonRegions result_;
  std::vector<int> trunk_; ///< patch of the trunk, by layer

private:
  void follow_legs();
  void label_feet(unsigned int begin);
  void label_halves(const Patch &patch, double middle);
  std::pair<double, double> trunk_depth() const;
  double reach_of_legs() const;
  void find_thighs();
  void label_thighs(unsigned int layer,
                    double front,
                    double beyond_hands,
                    double middle);
  void label_seat(unsigned int bottom, double front);
  double height_of_thighs(double from, double to) const;
  unsigned int largest_patch(unsigned int layer) const;
};
} // namespace contrecoup
