// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/person_sections.h>

#include <map>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Intervals between sections of the trunk, and the section at the joints of
  /// the shoulders.
  constexpr unsigned int n_trunk_sections = 22, shoulder_section = 17;

  /// Sums over voxels of coordinates across a limb.
  struct Moments
  {
    double n = 0., u = 0., v = 0., uu = 0., uv = 0., vv = 0.;

    void add(const double a, const double b)
    {
      n += 1.;
      u += a;
      v += b;
      uu += a * a;
      uv += a * b;
      vv += b * b;
    }

    void add(const Moments &other, const double weight)
    {
      n += weight * other.n;
      u += weight * other.u;
      v += weight * other.v;
      uu += weight * other.uu;
      uv += weight * other.uv;
      vv += weight * other.vv;
    }

    /// The same about the centre and for one voxel.
    Moments central() const
    {
      const double a = u / n, b = v / n;
      return {1., a, b, uu / n - a * a, uv / n - a * b, vv / n - b * b};
    }
  };


  /// Direction of the largest width; 0 if widths differ little.
  double long_direction(const Moments &m)
  {
    const double half = 0.5 * (m.uu - m.vv);
    const double root = std::hypot(half, m.uv);
    const double mean = 0.5 * (m.uu + m.vv);
    constexpr double least_ratio = 1.3; // of widths
    if (mean + root < least_ratio * least_ratio * (mean - root))
      return 0.;
    return 0.5 * std::atan2(m.uv, half);
  }


  /// From 0 to 1 without kinks.
  double ramp(const double x)
  {
    const double t = std::clamp(x, 0., 1.);
    return t * t * (3. - 2. * t);
  }


  /// Moments of a region by bins along its frame, as wide as a voxel.
  class LimbRuler
  {
  public:
    LimbRuler(const PersonRegions &regions,
              const Region region,
              const SectionFrame &frame)
      : width_(regions.grid.spacing)
    {
      const LabelGrid &grid = regions.grid;
      for (unsigned int k = 0; k < grid.size[2]; ++k)
        for (unsigned int j = 0; j < grid.size[1]; ++j)
          for (unsigned int i = 0; i < grid.size[0]; ++i)
            if (regions.is(grid.index(i, j, k), region))
            {
              const auto x = frame.coordinates(grid.center(i, j, k));
              bins_[static_cast<int>(std::floor(x[0] / width_ + 1e-6))].add(
                x[1], x[2]);
            }
    }

    /// Moments around a station, of bins weighted by their distance.
    Moments near(const double station, const double reach = 1.6) const
    {
      Moments sum;
      for (const auto &[index, bin] : bins_)
      {
        const double distance =
          std::abs((index + 0.5) * width_ - station) / width_;
        if (distance < reach && bin.n > 0.)
          sum.add(bin, 1. - distance / reach);
      }
      if (sum.n > 0.)
        return sum.central();
      return near(station, 2. * reach);
    }

    /// Mean central moments of all bins within a range.
    Moments between(const double low, const double high) const
    {
      Moments sum;
      for (const auto &[index, bin] : bins_)
      {
        const double station = (index + 0.5) * width_;
        if (station >= low && station <= high && bin.n > 1.)
          sum.add(bin.central(), bin.n);
      }
      return {1.,
              sum.u / sum.n,
              sum.v / sum.n,
              sum.uu / sum.n,
              sum.uv / sum.n,
              sum.vv / sum.n};
    }

  private:
    double width_;
    std::map<int, Moments> bins_;
  };


  LimbSection
  make_section(const double station, const Moments &m, const double turn)
  {
    const double c = std::cos(turn), s = std::sin(turn);
    LimbSection section;
    section.station = station;
    section.center[0] = m.u;
    section.center[1] = m.v;
    section.spread[0] =
      std::sqrt(std::max(0., c * c * m.uu + 2. * c * s * m.uv + s * s * m.vv));
    section.spread[1] =
      std::sqrt(std::max(0., s * s * m.uu - 2. * c * s * m.uv + c * c * m.vv));
    section.turn = turn;
    return section;
  }


  double height_of(const PersonRegions &regions, const double layer)
  {
    return regions.grid.origin[2] + layer * regions.grid.spacing;
  }


  /// Height of the hips above the soles, over the stature.
  constexpr double hip_height = 0.515;


  /// @param top height of the upper end [m]
  Limb measure_leg(const PersonRegions &regions,
                   const Region region,
                   const double top)
  {
    Limb leg;
    const LimbRuler ruler(regions, region, leg.frame);
    const double sole = height_of(regions, regions.sole);
    const double stature = regions.stature();
    const double toes =
      long_direction(ruler.between(sole, sole + 0.04 * stature));
    for (const double part : {0.01, 0.03, 0.05, 0.07, 0.09, 0.11, 0.13, 0.16,
                              0.20, 0.25, 0.30, 0.35, 0.40, 0.45, 0.50, 0.55,
                              0.60, 0.65, 0.70, 0.75, 0.80, 0.85, 0.90, 0.96})
    {
      const double station = sole + part * (top - sole);
      const double weight = 1. - ramp((station - sole) / stature / 0.03 - 1.5);
      leg.sections.push_back(
        make_section(station, ruler.near(station), weight * toes));
    }
    return leg;
  }


  Limb measure_trunk(const PersonRegions &regions)
  {
    Limb trunk;
    const LimbRuler ruler(regions, Region::trunk, trunk.frame);
    const double crotch = height_of(regions, regions.crotch);
    const double neck = height_of(regions, regions.neck + 0.5);
    for (unsigned int i = 0; i <= n_trunk_sections; ++i)
    {
      const double station = crotch + (neck - crotch) * i / n_trunk_sections;
      trunk.sections.push_back(make_section(station, ruler.near(station), 0.));
    }
    const double vertex = height_of(regions, regions.vertex);
    const double stature = regions.stature();
    const Moments cranium =
      ruler.between(vertex - 0.065 * stature, vertex - 0.02 * stature);
    trunk.sections.push_back(make_section(vertex, cranium, 0.));
    return trunk;
  }


  /// Frame of an arm: that of a hanging arm, turned on the shortest way.
  SectionFrame arm_frame(const Point<3> &root, const Point<3> &tip)
  {
    SectionFrame frame;
    frame.origin = root;
    frame.along = (tip - root) / root.distance(tip);
    const Tensor<1, 3> down = -Point<3>::unit_vector(2);
    const Tensor<1, 3> axis = cross_product_3d(down, frame.along);
    const double cosine = down * frame.along;
    Tensor<1, 3> forward = Point<3>::unit_vector(0);
    // Overhead there is no shortest way: the arm was raised sideways.
    if (1. + cosine > 0.05)
      forward +=
        cross_product_3d(axis, forward) +
        cross_product_3d(axis, cross_product_3d(axis, forward)) / (1. + cosine);
    forward -= (forward * frame.along) * frame.along;
    frame.first = forward / forward.norm();
    frame.second = cross_product_3d(frame.along, frame.first);
    return frame;
  }


  /// Joint of the shoulder. Heights and widths are those of the phantom.
  Point<3> shoulder_joint(const LimbSection &shoulder, const unsigned int side)
  {
    constexpr double width = 1.45; // over the spread of the section
    return Point<3>(shoulder.center[0],
                    shoulder.center[1] +
                      (side == 0 ? width : -width) * shoulder.spread[1],
                    shoulder.station);
  }


  /// An arm from the joint of its shoulder on. The part near the joint belongs
  /// to the trunk and is as wide there as the trunk is deep.
  Limb measure_arm(const PersonRegions &regions, const unsigned int side)
  {
    Limb arm;
    if (!regions.has_arm[side])
      return arm;
    constexpr unsigned int n_sections = 24;
    const LimbSection shoulder =
      measure_trunk(regions).sections[shoulder_section];
    const Point<3> joint = shoulder_joint(shoulder, side);
    // A hand that is not told from the trunk is in line with its arm.
    constexpr double usual_length = 0.407; // over the stature, of the phantom
    Point<3> tip = regions.arm_tip[side];
    if (!regions.has_hand[side])
      tip = joint + usual_length * regions.stature() / joint.distance(tip) *
                      (tip - joint);
    arm.frame = arm_frame(joint, tip);
    const LimbRuler ruler(
      regions, side == 0 ? Region::left_arm : Region::right_arm, arm.frame);
    const double length = joint.distance(tip);
    const double palm = regions.has_hand[side]
                          ? long_direction(ruler.between(0.86 * length, length))
                          : 0.;
    LimbSection first;
    first.spread[0] = first.spread[1] = shoulder.spread[0];
    arm.sections.push_back(first);
    for (unsigned int i = 0; i <= n_sections; ++i)
    {
      const double part = 0.34 + 0.64 * i / n_sections;
      const double station = part * length;
      arm.sections.push_back(make_section(
        station, ruler.near(station), ramp((part - 0.6) / 0.25) * palm));
    }
    return arm;
  }


  SectionPair make_pair(const LimbSection &from, const LimbSection &to)
  {
    SectionPair pair;
    pair.station = from.station;
    pair.new_station = to.station;
    pair.turn = from.turn;
    pair.new_turn = to.turn;
    for (unsigned int d = 0; d < 2; ++d)
    {
      pair.center[d] = from.center[d];
      pair.new_center[d] = to.center[d];
      pair.ratio[d] =
        std::clamp(to.spread[d] / std::max(from.spread[d], 1e-9), 0.2, 5.);
    }
    return pair;
  }


  SectionWarp warp_limb(const Limb &from, const Limb &to)
  {
    std::vector<SectionPair> pairs;
    for (std::size_t i = 0; i < from.sections.size(); ++i)
      pairs.push_back(make_pair(from.sections[i], to.sections[i]));
    return SectionWarp(from.frame, to.frame, pairs);
  }


  /// The head is scaled as its cranium, from the vertex to the skull's base.
  SectionWarp warp_trunk(const PersonRegions &from_regions,
                         const PersonRegions &to_regions)
  {
    const Limb from = measure_trunk(from_regions);
    const Limb to = measure_trunk(to_regions);
    std::vector<SectionPair> pairs = warp_limb(from, to).pairs();
    const SectionPair vertex = pairs.back();
    SectionPair base = vertex;
    const double length = 0.086 * from_regions.stature();
    base.station -= length;
    base.new_station -= std::sqrt(base.ratio[0] * base.ratio[1]) * length;
    pairs.pop_back();
    const double gap = 0.005 * to_regions.stature();
    while (pairs.back().station > base.station ||
           pairs.back().new_station > base.new_station - gap)
      pairs.pop_back();
    pairs.push_back(base);
    pairs.push_back(vertex);
    return SectionWarp(from.frame, to.frame, pairs);
  }


  /// Above the place where the legs join they go with the trunk.
  SectionWarp join_to_trunk(const SectionWarp &leg, const SectionWarp &trunk)
  {
    std::vector<SectionPair> pairs = leg.pairs();
    const SectionPair top = pairs.back();
    const double length = top.station - pairs.front().station;
    const double begin = trunk.pairs().front().station;
    for (const double part : {0.04, 0.2})
    {
      SectionPair pair = trunk.at(begin + part * length);
      const Point<3> center(top.center[0], top.center[1], pair.station);
      const Point<3> place = trunk.apply(center);
      for (unsigned int d = 0; d < 2; ++d)
      {
        pair.center[d] = center[d];
        pair.new_center[d] = place[d];
      }
      pairs.push_back(pair);
    }
    return SectionWarp(leg.frame(), leg.new_frame(), pairs);
  }


  /// Frame of the thigh of who sits, from the knee to the hip: that of a
  /// standing person, bent forward.
  SectionFrame thigh_frame(const Point<3> &knee, const Point<3> &hip)
  {
    SectionFrame frame;
    frame.origin = knee;
    frame.along = (hip - knee) / knee.distance(hip);
    frame.first = Point<3>::unit_vector(2);
    frame.first -= (frame.first * frame.along) * frame.along;
    frame.first /= frame.first.norm();
    frame.second = cross_product_3d(frame.along, frame.first);
    return frame;
  }


  /// A thigh of who sits begins in the middle of the knee, where the lower leg
  /// ends, and ends in the joint of the hip, which goes with the trunk.
  SectionWarp warp_thigh(const PersonRegions &from,
                         const PersonRegions &to,
                         const unsigned int side,
                         const SectionWarp &lower_leg,
                         const SectionWarp &trunk)
  {
    const auto of_side = [&](const Region left, const Region right) {
      return side == 0 ? left : right;
    };
    const double stature = from.stature(), begin = from.knee();
    const double length =
      height_of(from, from.sole) + hip_height * stature - begin;
    const LimbRuler ruler(
      from, of_side(Region::left_leg, Region::right_leg), SectionFrame());
    const Moments knee = ruler.near(begin);
    // Between the joints of both hips, over the stature.
    constexpr double distance = 0.1;
    const Point<3> hip(
      0., (side == 0 ? 0.5 : -0.5) * distance * stature, begin + length);
    const Point<3> new_knee = lower_leg.apply({knee.u, knee.v, begin});
    const Point<3> new_hip = trunk.apply(hip);
    const double new_length = new_knee.distance(new_hip);
    const SectionFrame frame = thigh_frame(new_knee, new_hip);
    const LimbRuler new_ruler(
      to, of_side(Region::left_thigh, Region::right_thigh), frame);

    std::vector<SectionPair> pairs{lower_leg.at(begin)};
    for (const double part : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6})
      pairs.push_back(make_pair(
        make_section(
          begin + part * length, ruler.near(begin + part * length), 0.),
        make_section(
          part * new_length, new_ruler.near(part * new_length), 0.)));
    pairs.push_back(trunk.at(hip[2]));
    pairs.front().center[0] = knee.u;
    pairs.front().center[1] = knee.v;
    pairs.back().center[0] = hip[0];
    pairs.back().center[1] = hip[1];
    pairs.front().new_station = 0.;
    pairs.back().new_station = new_length;
    for (SectionPair *end : {&pairs.front(), &pairs.back()})
    {
      end->new_center[0] = end->new_center[1] = 0.;
      end->ratio[0] = end->ratio[1] = std::sqrt(end->ratio[0] * end->ratio[1]);
      end->turn = end->new_turn = 0.;
    }
    return SectionWarp(SectionFrame(), frame, pairs);
  }


  /// Legs of a person who stands, or lower legs and thighs of one who sits.
  void warp_leg(const PersonRegions &from,
                const PersonRegions &to,
                const unsigned int side,
                std::array<SectionWarp, n_regions> &warps)
  {
    const auto at = [&](const Region left) -> SectionWarp & {
      return warps[static_cast<unsigned int>(left) + side];
    };
    const Region region = side == 0 ? Region::left_leg : Region::right_leg;
    const SectionWarp &trunk = warps[static_cast<unsigned int>(Region::trunk)];
    SectionWarp &leg = at(Region::left_leg), &thigh = at(Region::left_thigh);
    if (to.thigh_height)
    {
      leg = warp_limb(measure_leg(from, region, from.knee()),
                      measure_leg(to, region, *to.thigh_height));
      thigh = warp_thigh(from, to, side, leg, trunk);
      return;
    }
    leg = join_to_trunk(
      warp_limb(measure_leg(from, region, height_of(from, from.crotch)),
                measure_leg(to, region, height_of(to, to.crotch))),
      trunk);
    thigh = leg;
  }
} // namespace


std::array<SectionWarp, n_regions> warp_between(const PersonRegions &from,
                                                const PersonRegions &to)
{
  const SectionWarp trunk = warp_trunk(from, to);
  std::array<SectionWarp, n_regions> warps{
    {trunk, trunk, trunk, trunk, trunk, trunk, trunk}};
  for (const unsigned int side : {0, 1})
  {
    const Limb arm = measure_arm(from, side), other = measure_arm(to, side);
    if (!arm.sections.empty() && !other.sections.empty())
      warps[static_cast<unsigned int>(Region::left_arm) + side] =
        warp_limb(arm, other);
    warp_leg(from, to, side, warps);
  }
  return warps;
}
} // namespace contrecoup
