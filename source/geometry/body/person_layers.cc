// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/person_layers.h>
#include <contrecoup/geometry/image/voxel_mask.h>

namespace contrecoup
{
using dealii::Point;

double PersonLayers::Patch::spread(const LabelGrid &grid,
                                   const unsigned int direction) const
{
  double sum = 0.;
  for (const std::size_t voxel : voxels)
  {
    const unsigned int i = voxel % grid.size[0];
    const unsigned int j = voxel / grid.size[0] % grid.size[1];
    const double offset =
      grid.center(i, j, 0)[direction] - (direction == 0 ? x : y);
    sum += offset * offset;
  }
  return std::sqrt(sum / double(voxels.size()));
}


PersonLayers::PersonLayers(const Shape &surface)
{
  constexpr double n_layers = 200.;
  grid_ = fill_shape(surface, surface.bounding_box().side_length(2) / n_layers);
  for (unsigned char &label : grid_.labels)
    label = label == LabelGrid::outside ? label : unknown_;
  keep_one_piece();
  is_wall_.assign(grid_.labels.size(), false);
  find_patches();
  require_ankles();
  put_walls();
  find_patches();
}


std::size_t PersonLayers::count_inside(const unsigned int layer) const
{
  const auto begin = grid_.labels.begin() + layer * layer_size();
  return layer_size() -
         std::count(begin, begin + layer_size(), LabelGrid::outside);
}


/// Removes small pieces, refuses large ones, and finds the lowest layer.
void PersonLayers::keep_one_piece()
{
  VoxelMask mask{
    grid_.size, {{grid_.spacing, grid_.spacing, grid_.spacing}}, {}};
  for (const unsigned char label : grid_.labels)
    mask.inside.push_back(label != LabelGrid::outside);
  const VoxelMask largest = largest_piece(mask);
  const double all = mask.count();
  if (all == 0.)
    throw InputError("it has no inside");
  const double rest = 1. - largest.count() / all;
  if (rest > 0.02)
    throw InputError("pieces of " + brief(100. * rest, 2) +
                     " % of its volume are apart from the largest one; it "
                     "must be one person");
  for (std::size_t i = 0; i < grid_.labels.size(); ++i)
    if (!largest.inside[i])
      grid_.labels[i] = LabelGrid::outside;
  unsigned int top = grid_.size[2];
  while (count_inside(top - 1) == 0)
    --top;
  while (count_inside(sole_) == 0)
    ++sole_;
  n_layers_ = top - sole_;
}


void PersonLayers::find_patches()
{
  patches_.assign(grid_.size[2], {});
  patch_of_.assign(grid_.labels.size(), -1);
  for (std::size_t first = 0; first < grid_.labels.size(); ++first)
  {
    if (!is_open(first) || patch_of_[first] >= 0)
      continue;
    auto &layer = patches_[first / layer_size()];
    Patch patch;
    patch.voxels.push_back(first);
    patch_of_[first] = layer.size();
    for (std::size_t n = 0; n < patch.voxels.size(); ++n)
    {
      const std::size_t voxel = patch.voxels[n];
      // The grid has a margin: neighbours exist.
      for (const std::size_t next :
           {voxel - 1, voxel + 1, voxel - grid_.size[0], voxel + grid_.size[0]})
        if (is_open(next) && patch_of_[next] < 0)
        {
          patch_of_[next] = layer.size();
          patch.voxels.push_back(next);
        }
    }
    const Point<3> middle = center(patch.voxels);
    patch.x = middle[0];
    patch.y = middle[1];
    layer.push_back(patch);
  }
}


Point<3> PersonLayers::center(const std::vector<std::size_t> &voxels) const
{
  dealii::Tensor<1, 3> sum;
  for (const std::size_t voxel : voxels)
    sum +=
      grid_.center(voxel % grid_.size[0], column(voxel), voxel / layer_size());
  return Point<3>(sum / double(voxels.size()));
}


/// Where an arm that touches the trunk is thinnest: the column between two
/// others whose thickness is much less than on both sides; -1: nowhere.
int PersonLayers::find_gap(const std::vector<unsigned int> &thickness,
                           const unsigned int outer,
                           const unsigned int inner) const
{
  constexpr double least_thickness = 0.015, least_ratio = 0.88;
  const int step = inner > outer ? 1 : -1;
  int gap = -1;
  unsigned int arm = 0, thinnest = 0;
  for (int j = outer; j != static_cast<int>(inner); j += step)
  {
    const unsigned int here = thickness[j];
    if (gap < 0 || here < thinnest)
    {
      if (here < least_ratio * arm && arm > least_thickness * n_layers_)
      {
        gap = j;
        thinnest = here;
      }
    }
    else if (here > thinnest / least_ratio)
      return gap;
    if (gap < 0)
      arm = std::max(arm, here);
  }
  return -1;
}


/// Divides arms from the trunk that they touch, by walls along x which are
/// one voxel thick.
void PersonLayers::put_walls()
{
  constexpr double inner_part = 0.25; // of the half width
  for (unsigned int n = std::lround(0.4 * n_layers_); n < 0.8 * n_layers_; ++n)
    for (const Patch &patch : patches_[sole_ + n])
    {
      std::vector<unsigned int> thickness(grid_.size[1]);
      unsigned int right = grid_.size[1], left = 0;
      for (const std::size_t voxel : patch.voxels)
      {
        const unsigned int j = column(voxel);
        ++thickness[j];
        right = std::min(right, j);
        left = std::max(left, j);
      }
      const double middle = 0.5 * (left + right);
      const unsigned int reach = std::lround(inner_part * 0.5 * (left - right));
      for (const int gap :
           {find_gap(thickness, left, std::lround(middle) + reach),
            find_gap(thickness, right, std::lround(middle) - reach)})
        for (const std::size_t voxel : patch.voxels)
          if (gap == int(column(voxel)))
            is_wall_[voxel] = true;
    }
}


/// Ankles are much thinner than the trunk; a body cut off has none.
void PersonLayers::require_ankles() const
{
  std::size_t ankles = layer_size(), trunk = 0;
  unsigned int layer = 0;
  for (unsigned int n = 0; n < n_layers_; ++n)
  {
    const std::size_t area = count_inside(sole_ + n);
    if (n > 0.03 * n_layers_ && n < 0.15 * n_layers_)
    {
      if (area < ankles)
        layer = sole_ + n;
      ankles = std::min(ankles, area);
    }
    else if (n > 0.4 * n_layers_)
      trunk = std::max(trunk, area);
  }
  if (ankles > 0.45 * trunk)
    throw InputError("no ankles were found at its lower end");
  find_two("ankle", layer);
}


std::vector<int> PersonLayers::find_two(const std::string &what,
                                        const unsigned int layer) const
{
  const std::vector<Patch> &all = patches_[layer];
  std::vector<int> found;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].voxels.size() > area(0.0006))
      found.push_back(i);
  if (found.size() > 2)
    found.erase(std::remove_if(
                  found.begin(),
                  found.end(),
                  [&](const int patch) { return !stands(all[patch], layer); }),
                found.end());
  if (found.size() == 1 &&
      all[found[0]].spread(grid_, 1) > 1.4 * all[found[0]].spread(grid_, 0))
    found.push_back(found[0]);
  if (found.size() != 2)
    throw InputError(
      std::to_string(found.size()) + " " + what + "(s) were found at " +
      brief(100. * (layer - sole_) / n_layers_, 2) +
      " % of its height: two sections there must go on down to the feet, apart "
      "from arms and clothes");
  if (all[found[0]].y < all[found[1]].y)
    std::swap(found[0], found[1]);
  return found;
}


int PersonLayers::next(const Patch &patch,
                       const unsigned int layer,
                       const bool is_up) const
{
  const unsigned int there = is_up ? layer + 1 : layer - 1;
  std::vector<unsigned int> shared(patches_[there].size());
  for (const std::size_t voxel : patch.voxels)
  {
    const int other =
      patch_of_[is_up ? voxel + layer_size() : voxel - layer_size()];
    if (other >= 0)
      ++shared[other];
  }
  const auto most = std::max_element(shared.begin(), shared.end());
  return most == shared.end() || *most == 0 ? -1 : most - shared.begin();
}


bool PersonLayers::stands(const Patch &patch, unsigned int layer) const
{
  // Feet need not be at the same height.
  const unsigned int lowest = sole_ + std::lround(0.03 * n_layers_);
  const Patch *here = &patch;
  for (; layer > lowest; --layer)
  {
    const int below = next(*here, layer, false);
    if (below < 0)
      return false;
    here = &patches_[layer - 1][below];
  }
  return true;
}
} // namespace contrecoup
