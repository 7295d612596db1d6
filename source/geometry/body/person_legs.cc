// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/person_legs.h>

namespace contrecoup
{
using dealii::Point;

namespace
{
  Region leg_of(const unsigned int side)
  {
    return side == 0 ? Region::left_leg : Region::right_leg;
  }
} // namespace


unsigned int PersonLegs::largest_patch(const unsigned int layer) const
{
  const std::vector<Patch> &all = patches_[layer];
  return std::max_element(all.begin(),
                          all.end(),
                          [](const Patch &a, const Patch &b) {
                            return a.voxels.size() < b.voxels.size();
                          }) -
         all.begin();
}


void PersonLegs::label_halves(const Patch &patch, const double middle)
{
  for (const std::size_t voxel : patch.voxels)
  {
    const unsigned int j = column(voxel);
    grid_.labels[voxel] = static_cast<unsigned char>(
      leg_of(grid_.center(0, j, 0)[1] > middle ? 0 : 1));
  }
}


/// Gives what is below the layer @p begin to the leg above it; to both,
/// divided between them, where it is below both or nothing. A part below
/// something else, such as a hand next to a seat, belongs to no leg.
void PersonLegs::label_feet(const unsigned int begin)
{
  std::array<double, 2> places{{0., 0.}};
  for (unsigned int layer = begin; layer-- > sole_;)
  {
    std::array<double, 2> sums{{0., 0.}}, counts{{0., 0.}};
    for (std::size_t voxel = (layer + 1) * layer_size();
         voxel < (layer + 2) * layer_size();
         ++voxel)
      for (const unsigned int side : {0, 1})
        if (is(voxel, leg_of(side)))
        {
          sums[side] += grid_.center(0, column(voxel), 0)[1];
          counts[side] += 1.;
        }
    for (const unsigned int side : {0, 1})
      if (counts[side] > 0.)
        places[side] = sums[side] / counts[side];
    for (const Patch &patch : patches_[layer])
    {
      std::array<bool, 2> is_below{{false, false}};
      bool is_below_others = false;
      for (const std::size_t voxel : patch.voxels)
      {
        const std::size_t above = voxel + layer_size();
        for (const unsigned int side : {0, 1})
          if (is(above, leg_of(side)))
            is_below[side] = true;
        is_below_others = is_below_others || is_open(above);
      }
      if (is_below_others && !is_below[0] && !is_below[1])
        continue;
      const double far = grid_.size[1] * grid_.spacing;
      const double middle = 0.5 * (places[0] + places[1]);
      label_halves(patch,
                   is_below[0] == is_below[1] ? middle
                   : is_below[0]              ? middle - far
                                              : middle + far);
    }
  }
}


void PersonLegs::follow_legs()
{
  // Below the knees, hands and skirts rarely reach.
  const unsigned int begin = sole_ + std::lround(0.25 * n_layers_);
  const std::vector<int> legs = find_two("leg", begin);
  const unsigned int most = sole_ + std::lround(0.58 * n_layers_);
  const double far = std::numeric_limits<double>::max();
  int left = legs.front(), right = legs.back();
  unsigned int layer = begin;
  for (; left != right && layer < most; ++layer)
  {
    label_halves(patches_[layer][left], -far);
    label_halves(patches_[layer][right], far);
    left = next(patches_[layer][left], layer, true);
    right = next(patches_[layer][right], layer, true);
    if (left < 0 || right < 0)
      throw InputError("a leg ends at " +
                       brief(100. * (layer - sole_) / n_layers_, 2) +
                       " % of its height");
  }
  if (left != right)
    throw InputError("its legs do not join below 58 % of its height");
  result_.crotch = layer;
  trunk_.assign(grid_.size[2], -1);
  trunk_[layer] = left;
  if (layer == begin)
    label_halves(patches_[layer][left], patches_[layer][left].y);
  label_feet(begin);
}


/// Middle and front of the trunk above the thighs of who sits [m].
std::pair<double, double> PersonLegs::trunk_depth() const
{
  double middle = 0., front = 0., n = 0.;
  for (unsigned int layer = sole_ + std::lround(0.62 * n_layers_);
       layer < sole_ + std::lround(0.75 * n_layers_);
       ++layer)
  {
    const Patch &trunk = patches_[layer][largest_patch(layer)];
    // Half the depth of an ellipse is twice its spread.
    middle += trunk.x;
    front += trunk.x + 2. * trunk.spread(grid_, 0);
    n += 1.;
  }
  return {middle / n, front / n};
}


/// How far to the front what is above the joined legs reaches [m].
double PersonLegs::reach_of_legs() const
{
  double reach = std::numeric_limits<double>::lowest();
  unsigned int layer = result_.crotch;
  const unsigned int end = layer + std::lround(0.12 * n_layers_);
  for (int patch = trunk_[layer]; patch >= 0 && layer < end; ++layer)
  {
    const Patch &here = patches_[layer][patch];
    for (const std::size_t voxel : here.voxels)
      reach = std::max(reach, place_of(voxel)[0]);
    patch = next(here, layer, true);
  }
  return reach;
}


/// Takes the thighs of who sits from trunk and legs: what reaches farther to
/// the front than trunk and hands of who stands do where the legs join.
void PersonLegs::find_thighs()
{
  constexpr double least_reach = 0.28, thickest = 0.2; // of the height
  const auto [middle, front] = trunk_depth();
  const double reach = reach_of_legs(), length = reach - front;
  if (reach - middle < least_reach * n_layers_ * grid_.spacing || length <= 0.)
    return;
  // The layers of the thighs are full between trunk and knees.
  std::vector<std::size_t> counts(grid_.size[2]);
  for (std::size_t voxel = 0; voxel < grid_.labels.size(); ++voxel)
  {
    const double part = (place_of(voxel)[0] - front) / length;
    if (grid_.labels[voxel] != LabelGrid::outside && part > 0.2 && part < 0.7)
      ++counts[voxel / layer_size()];
  }
  const auto fullest = std::max_element(
    counts.begin(), counts.begin() + sole_ + std::lround(0.6 * n_layers_));
  unsigned int bottom = fullest - counts.begin(), top = bottom + 1;
  // Those of thighs that slope down are less full below.
  while (counts[bottom - 1] > 0.1 * *fullest)
    --bottom;
  while (counts[top] > 0.4 * *fullest &&
         top < bottom + std::lround(thickest * n_layers_))
    ++top;
  const double sides = patches_[result_.crotch][trunk_[result_.crotch]].y;
  for (unsigned int layer = bottom; layer < top; ++layer)
    label_thighs(layer, front, front + 0.5 * length, sides);
  label_seat(bottom, front);
  result_.thigh_height =
    height_of_thighs(front + 0.75 * length, front + 0.95 * length);
  find_patches();
  while (patches_[result_.crotch].empty() ||
         patches_[result_.crotch][largest_patch(result_.crotch)].voxels.size() <
           area(0.006))
    ++result_.crotch;
  trunk_[result_.crotch] = largest_patch(result_.crotch);
}


/// Mean height of the thighs between two places along x [m].
double PersonLegs::height_of_thighs(const double from, const double to) const
{
  double sum = 0., n = 0.;
  for (std::size_t voxel = 0; voxel < grid_.labels.size(); ++voxel)
  {
    const Point<3> place = place_of(voxel);
    if (place[0] > from && place[0] < to &&
        (is(voxel, Region::left_thigh) || is(voxel, Region::right_thigh)))
    {
      sum += place[2];
      n += 1.;
    }
  }
  return sum / n;
}


/// Thighs are what is before the trunk in a layer, but hands that hang there.
void PersonLegs::label_thighs(const unsigned int layer,
                              const double front,
                              const double beyond_hands,
                              const double middle)
{
  std::vector<bool> is_thigh(patches_[layer].size());
  const auto for_each = [&](const auto &action) {
    for (std::size_t voxel = layer * layer_size();
         voxel < (layer + 1) * layer_size();
         ++voxel)
      if (grid_.labels[voxel] != LabelGrid::outside && patch_of_[voxel] >= 0)
        action(voxel, place_of(voxel));
  };
  for_each([&](const std::size_t voxel, const Point<3> &place) {
    if (place[0] > beyond_hands)
      is_thigh[patch_of_[voxel]] = true;
  });
  for_each([&](const std::size_t voxel, const Point<3> &place) {
    if (is_thigh[patch_of_[voxel]] && place[0] > front)
      grid_.labels[voxel] = static_cast<unsigned char>(
        place[1] > middle ? Region::left_thigh : Region::right_thigh);
  });
}


/// Gives what was followed as a leg under the trunk to the thighs, which else
/// would draw the upper end of the lower leg to the hip.
void PersonLegs::label_seat(const unsigned int bottom, const double front)
{
  // Thighs that slope to the knees are lower at the hip.
  const std::size_t begin =
    (bottom - std::lround(0.03 * n_layers_)) * layer_size();
  for (std::size_t voxel = begin; voxel < grid_.labels.size(); ++voxel)
    for (const auto &[leg, thigh] :
         {std::pair(Region::left_leg, Region::left_thigh),
          std::pair(Region::right_leg, Region::right_thigh)})
      if (is(voxel, leg) && place_of(voxel)[0] <= front)
        grid_.labels[voxel] = static_cast<unsigned char>(thigh);
}


void PersonLegs::raise_crotch()
{
  // Parts of the stature; 0.837 of 1.756 m in the survey that the phantom is
  // of, recalled.
  constexpr double least = 0.465, usual = 0.477;
  const unsigned int height = result_.vertex - sole_;
  if (result_.thigh_height || result_.crotch >= sole_ + least * height)
    return;
  const unsigned int crotch = sole_ + std::lround(usual * height);
  for (unsigned int layer = result_.crotch; layer < crotch; ++layer)
  {
    const Patch &patch = patches_[layer][trunk_[layer]];
    label_halves(patch, patch.y);
  }
  result_.crotch = crotch;
}


void PersonLegs::find_legs()
{
  follow_legs();
  find_thighs();
}
} // namespace contrecoup
