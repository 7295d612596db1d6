// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/person_legs.h>

#include <queue>

namespace contrecoup
{
using dealii::Point;

namespace
{
  Region arm_of(const unsigned int side)
  {
    return side == 0 ? Region::left_arm : Region::right_arm;
  }


  class RegionFinder : private PersonLegs
  {
  public:
    using PersonLegs::PersonLegs;
    PersonRegions find(std::optional<double> neck_height);

  private:
    void find_trunk();
    std::vector<float> distances_from_axis() const;
    void find_arm(unsigned int side, const std::vector<float> &distances);
    void find_hanging_arm(unsigned int side);
    std::vector<std::size_t> beyond(const std::vector<float> &distances,
                                    std::size_t tip,
                                    float distance) const;
    std::vector<std::size_t> trunk_areas() const;
    void find_neck();
    void set_neck(double height);
  };


  /// Follows the trunk upwards: of several patches above one, the nearest.
  void RegionFinder::find_trunk()
  {
    unsigned int layer = result_.crotch;
    while (trunk_[layer] >= 0)
    {
      const Patch &below = patches_[layer][trunk_[layer]];
      std::vector<int> candidates;
      for (const std::size_t voxel : below.voxels)
      {
        const int patch = patch_of_[voxel + layer_size()];
        if (patch >= 0 &&
            std::find(candidates.begin(), candidates.end(), patch) ==
              candidates.end())
          candidates.push_back(patch);
      }
      ++layer;
      double nearest = std::numeric_limits<double>::max();
      for (const int candidate : candidates)
      {
        const Patch &patch = patches_[layer][candidate];
        const double distance =
          std::hypot(patch.x - below.x, patch.y - below.y) +
          (patch.voxels.size() < area(0.0005) ? 1e3 : 0.);
        if (distance < nearest)
        {
          nearest = distance;
          trunk_[layer] = candidate;
        }
      }
    }
    result_.vertex = layer;
  }


  /// Lengths of paths from the axis of trunk and head, in voxels; 0 for what
  /// belongs to a leg or is outside.
  std::vector<float> RegionFinder::distances_from_axis() const
  {
    const float far = std::numeric_limits<float>::max();
    std::vector<float> distances(grid_.labels.size(), far);
    using Entry = std::pair<float, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (unsigned int layer = result_.crotch; layer < result_.vertex; ++layer)
    {
      const Patch &patch = patches_[layer][trunk_[layer]];
      for (const std::size_t voxel : patch.voxels)
      {
        const Point<3> place = place_of(voxel);
        if (std::hypot(place[0] - patch.x, place[1] - patch.y) <
            0.02 * n_layers_ * grid_.spacing)
          queue.push({distances[voxel] = 0.f, voxel});
      }
    }
    while (!queue.empty())
    {
      const auto [distance, voxel] = queue.top();
      queue.pop();
      if (distance > distances[voxel])
        continue;
      for (int k = -1; k <= 1; ++k)
        for (int j = -1; j <= 1; ++j)
          for (int i = -1; i <= 1; ++i)
          {
            const std::size_t next =
              voxel + i + static_cast<int>(grid_.size[0]) * j +
              static_cast<std::ptrdiff_t>(layer_size()) * k;
            const float there =
              distance + std::sqrt(float(i * i + j * j + k * k));
            if (grid_.labels[next] == unknown_ && is_open(next) &&
                there < distances[next])
              queue.push({distances[next] = there, next});
          }
    }
    for (float &distance : distances)
      distance = distance == far ? 0.f : distance;
    return distances;
  }


  /// Connected voxels with larger distances than this, from the tip on.
  std::vector<std::size_t>
  RegionFinder::beyond(const std::vector<float> &distances,
                       const std::size_t tip,
                       const float distance) const
  {
    std::vector<bool> is_found(grid_.labels.size());
    std::vector<std::size_t> found{tip};
    is_found[tip] = true;
    for (std::size_t n = 0; n < found.size(); ++n)
      for (const std::size_t step :
           {std::size_t(1), std::size_t(grid_.size[0]), layer_size()})
        for (const std::size_t next : {found[n] - step, found[n] + step})
          if (!is_found[next] && distances[next] > distance)
          {
            is_found[next] = true;
            found.push_back(next);
          }
    return found;
  }


  void RegionFinder::find_arm(const unsigned int side,
                              const std::vector<float> &distances)
  {
    const double axis = patches_[result_.crotch][trunk_[result_.crotch]].y;
    std::size_t tip = 0;
    for (std::size_t voxel = 0; voxel < distances.size(); ++voxel)
    {
      const unsigned int j = column(voxel);
      if ((grid_.center(0, j, 0)[1] > axis) == (side == 0) &&
          distances[voxel] > distances[tip])
        tip = voxel;
    }
    // From the tip to the shoulder: the section is that of an arm as long as
    // it is not much larger than near the elbow.
    const double height = result_.vertex - sole_;
    const float farthest = distances[tip];
    if (farthest < 0.28 * height)
      return;
    constexpr float step = 1.5f;
    double elbow = 0.;
    std::vector<std::size_t> arm, band;
    for (float distance = farthest - step; distance > 0.05 * height;
         distance -= step)
    {
      const auto found = beyond(distances, tip, distance);
      const double section = (found.size() - arm.size()) / step;
      const double length = farthest - distance;
      if (length < 0.28 * height)
        elbow = length > 0.1 * height ? std::max(elbow, section) : 0.;
      if (length > 0.12 * height &&
          section > std::min(1.9 * elbow, area(0.006)))
        break;
      band.clear();
      for (const std::size_t voxel : found)
        if (distances[voxel] <= distance + 2 * step)
          band.push_back(voxel);
      arm = found;
    }
    if (arm.empty() || farthest - distances[band.front()] < 0.26 * height)
      return;
    result_.has_arm[side] = result_.has_hand[side] = true;
    result_.arm_root[side] = center(band);
    result_.arm_tip[side] =
      center(beyond(distances, tip, farthest - 0.02 * height));
    for (const std::size_t voxel : arm)
      grid_.labels[voxel] = static_cast<unsigned char>(arm_of(side));
  }


  /// Finds an arm whose hand touches the body by what is next to the trunk.
  void RegionFinder::find_hanging_arm(const unsigned int side)
  {
    const unsigned int height = result_.vertex - sole_;
    const double axis = patches_[result_.crotch][trunk_[result_.crotch]].y;
    std::vector<std::size_t> arm;
    for (unsigned int layer = result_.crotch;
         layer < sole_ + std::lround(0.8 * height);
         ++layer)
      for (std::size_t i = 0; i < patches_[layer].size(); ++i)
        if (static_cast<int>(i) != trunk_[layer] &&
            (patches_[layer][i].y > axis) == (side == 0))
          for (const std::size_t voxel : patches_[layer][i].voxels)
            if (grid_.labels[voxel] == unknown_)
              arm.push_back(voxel);
    if (arm.empty())
      return;
    const unsigned int low = arm.front() / layer_size();
    const unsigned int high = arm.back() / layer_size();
    if (high - low < 0.1 * height)
      return;
    std::vector<std::size_t> ends[2];
    for (const std::size_t voxel : arm)
    {
      grid_.labels[voxel] = static_cast<unsigned char>(arm_of(side));
      const std::size_t layer = voxel / layer_size();
      const double part = double(layer - low) / (high - low);
      if (part < 0.2 || part > 0.8)
        ends[part < 0.5 ? 0 : 1].push_back(voxel);
    }
    result_.has_arm[side] = true;
    result_.arm_root[side] = center(ends[1]);
    result_.arm_tip[side] = center(ends[0]);
  }


  /// Sections of trunk, neck and head by layer, in voxels.
  std::vector<std::size_t> RegionFinder::trunk_areas() const
  {
    std::vector<std::size_t> areas(grid_.size[2]);
    for (unsigned int layer = result_.crotch; layer < result_.vertex; ++layer)
      for (const std::size_t voxel : patches_[layer][trunk_[layer]].voxels)
        if (is(voxel, Region::trunk))
          ++areas[layer];
    return areas;
  }


  void RegionFinder::find_neck()
  {
    // Parts of the height between which necks are, of children too.
    constexpr double low = 0.75, high = 0.92;
    // Largest section of a neck over those of head and trunk; that of a
    // muscular neck is nearly as large as the head's.
    constexpr double most_of_head = 0.95, most_of_trunk = 0.6;
    const std::vector<std::size_t> areas = trunk_areas();
    const unsigned int height = result_.vertex - sole_;
    const auto at = [&](const double part) {
      return areas.begin() + sole_ + std::lround(part * height);
    };
    const auto neck = std::min_element(at(low), at(high));
    const double head = *std::max_element(neck, areas.begin() + result_.vertex);
    const double trunk = *std::max_element(areas.begin(), neck);
    if (height >= 0.6 * n_layers_ && *neck <= most_of_head * head &&
        *neck <= most_of_trunk * trunk)
    {
      result_.neck = neck - areas.begin();
      return;
    }
    const auto percent = [](const double part) {
      return brief(100. * part, 3) + " %";
    };
    throw InputError(
      "no neck with a head was found at its upper end: between " +
      percent(low) + " and " + percent(high) +
      " of the height, the least section of trunk and head is at " +
      percent(double(neck - areas.begin() - sole_) / height) + " and has " +
      percent(*neck / head) + " of the largest one above it and " +
      percent(*neck / trunk) + " of that below; at most " +
      percent(most_of_head) + " and " + percent(most_of_trunk) +
      " are those of a neck. Body/Surface/Neck height says where it is");
  }


  void RegionFinder::set_neck(const double height)
  {
    result_.neck = sole_ + std::lround(height / grid_.spacing);
    const double all = (result_.vertex - sole_) * grid_.spacing;
    if (!(height > 0.6 * all && height < 0.95 * all))
      throw InputError("Body/Surface/Neck height = " + brief(height) +
                       " m is not between 60 and 95 % of its height of " +
                       brief(all) + " m");
  }


  PersonRegions RegionFinder::find(const std::optional<double> neck_height)
  {
    find_legs();
    find_trunk();
    raise_crotch();
    const auto distances = distances_from_axis();
    for (const unsigned int side : {0, 1})
    {
      find_arm(side, distances);
      if (!result_.has_arm[side])
        find_hanging_arm(side);
    }
    for (unsigned char &label : grid_.labels)
      if (label == unknown_)
        label = static_cast<unsigned char>(Region::trunk);
    if (neck_height)
      set_neck(*neck_height);
    else
      find_neck();
    result_.grid = grid_;
    result_.sole = sole_;
    return result_;
  }
} // namespace


double PersonRegions::stature() const
{
  // Sitting height over stature, recalled from the survey that the phantom is
  // of.
  constexpr double sitting = 0.52;
  return grid.spacing *
         (thigh_height ? (vertex - crotch) / sitting : vertex - sole);
}


double PersonRegions::knee() const
{
  constexpr double part = 0.273; // of the phantom's stature
  return grid.origin[2] + grid.spacing * sole + part * stature();
}


PersonRegions find_regions(const Shape &surface,
                           const std::optional<double> neck_height)
{
  return RegionFinder(surface).find(neck_height);
}
} // namespace contrecoup
