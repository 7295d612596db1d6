// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/principal_axes.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/person_posture.h>
#include <contrecoup/geometry/shape/composed_shapes.h>

#include <deal.II/base/symmetric_tensor.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double degree = dealii::numbers::PI / 180.;

  /// Angles about x, then y, then z of a rotation [rad].
  Tensor<1, 3> angles_of(const Tensor<2, 3> &rotation)
  {
    Tensor<1, 3> angles;
    const double sine = std::clamp(-rotation[2][0], -1., 1.);
    angles[1] = std::asin(sine);
    if (std::abs(sine) < 1. - 1e-9)
    {
      angles[0] = std::atan2(rotation[2][1], rotation[2][2]);
      angles[2] = std::atan2(rotation[1][0], rotation[0][0]);
    }
    else
      // Turns about x and z are the same then.
      angles[2] = std::atan2(-rotation[0][1], rotation[1][1]);
    for (unsigned int d = 0; d < 3; ++d)
      if (std::abs(angles[d]) < 1e-12)
        angles[d] = 0.;
    return angles;
  }


  Tensor<2, 3> rotation_to_standing(const Posture &posture)
  {
    const Tensor<1, 3> left = cross_product_3d(posture.up, posture.forward);
    Tensor<2, 3> rotation;
    for (unsigned int d = 0; d < 3; ++d)
    {
      rotation[0][d] = posture.forward[d];
      rotation[1][d] = left[d];
      rotation[2][d] = posture.up[d];
    }
    return rotation;
  }


  /// Longest axis of inertia of points.
  Tensor<1, 3> longest_axis(const std::vector<Point<3>> &points)
  {
    Tensor<1, 3> sum;
    for (const Point<3> &point : points)
      sum += point;
    const Tensor<1, 3> center = sum / double(points.size());
    dealii::SymmetricTensor<2, 3> spread;
    for (const Point<3> &point : points)
      spread += symmetrize(
        outer_product(point - Point<3>(center), point - Point<3>(center)));
    return principal_axes(spread)[0].second;
  }


  /// The voxels of a person seen along a direction up.
  class Feature
  {
  public:
    Feature(const std::vector<Point<3>> &points, const Tensor<1, 3> &up)
      : points_(points)
      , up_(up)
    {
      for (const Point<3> &point : points)
      {
        lowest_ = std::min(lowest_, up * point);
        highest_ = std::max(highest_, up * point);
      }
      // Any two directions across.
      const unsigned int least = std::abs(up[0]) < 0.7 ? 0 : 1;
      first_ = Point<3>::unit_vector(least);
      first_ -= (first_ * up) * up;
      first_ /= first_.norm();
      second_ = cross_product_3d(up, first_);
    }

    /// Mean place across of what is between two parts of the height.
    Tensor<1, 3> middle(const double from, const double to) const
    {
      Tensor<1, 3> sum;
      double n = 0.;
      for (const Point<3> &point : points_)
        if (is_between(point, from, to))
        {
          sum += point - (up_ * point) * up_;
          n += 1.;
        }
      return n > 0. ? sum / n : sum;
    }

    /// Unit vector of the least width between two parts of the height.
    Tensor<1, 3> thin_direction(const double from, const double to) const
    {
      const Tensor<1, 3> center = middle(from, to);
      double uu = 0., uv = 0., vv = 0.;
      for (const Point<3> &point : points_)
        if (is_between(point, from, to))
        {
          const double u = (point - center) * first_;
          const double v = (point - center) * second_;
          uu += u * u;
          uv += u * v;
          vv += v * v;
        }
      const double wide = 0.5 * std::atan2(2. * uv, uu - vv);
      return -std::sin(wide) * first_ + std::cos(wide) * second_;
    }

    /// Sum of the directions from both ankles to the feet below them [m].
    /// @param lateral unit vector across
    Tensor<1, 3> toes(const Tensor<1, 3> &lateral) const
    {
      constexpr double foot = 0.04, ankle = 0.06, shin = 0.10; // of the height
      const double height = highest_ - lowest_;
      const double middle = this->middle(0.3, 0.6) * lateral;
      Tensor<1, 3> sum;
      for (const double side : {1., -1.})
      {
        const auto is_here = [&](const Point<3> &point) {
          return side * (point * lateral - middle) > 0.;
        };
        double lowest = highest_;
        for (const Point<3> &point : points_)
          if (is_here(point))
            lowest = std::min(lowest, up_ * point);
        std::array<Tensor<1, 3>, 2> places;
        std::array<double, 2> counts{{0., 0.}};
        for (const Point<3> &point : points_)
        {
          const double part = (up_ * point - lowest) / height;
          if (!is_here(point) || part > shin || (part > foot && part < ankle))
            continue;
          places[part > foot ? 1 : 0] += point;
          counts[part > foot ? 1 : 0] += 1.;
        }
        if (counts[0] > 0. && counts[1] > 0.)
          sum += places[0] / counts[0] - places[1] / counts[1];
      }
      return sum - (sum * up_) * up_;
    }

  private:
    bool
    is_between(const Point<3> &point, const double from, const double to) const
    {
      const double part = (up_ * point - lowest_) / (highest_ - lowest_);
      return part >= from && part <= to;
    }

    const std::vector<Point<3>> &points_;
    Tensor<1, 3> up_, first_, second_;
    double lowest_ = std::numeric_limits<double>::max();
    double highest_ = -std::numeric_limits<double>::max();
  };


  /// The thin direction of trunk or hips to which feet point; across it where
  /// arms that are held forward make the trunk appear deeper than wide.
  Tensor<1, 3> forward_by_feet(const Feature &feature, const Tensor<1, 3> &up)
  {
    const Tensor<1, 3> trunk = feature.thin_direction(0.5, 0.8);
    Tensor<1, 3> forward, feet;
    double best = 0.;
    for (const Tensor<1, 3> &direction :
         {trunk, feature.thin_direction(0.5, 0.6), cross_product_3d(up, trunk)})
    {
      const Tensor<1, 3> toes = feature.toes(cross_product_3d(up, direction));
      const double length = direction * toes;
      // The first one unless another is much better.
      constexpr double much = 1.2;
      if (std::abs(length) > (best > 0. ? much : 1.) * best)
      {
        best = std::abs(length);
        forward = length < 0. ? -direction : direction;
        feet = toes;
      }
    }
    if (!(forward * feet > 0.5 * feet.norm()))
      throw InputError("feet and trunk point different ways: a person, and no "
                       "other shape, is wanted, and Body/Surface/Facing, in "
                       "degrees, says which way the person faces");
    return forward;
  }


  Posture find_forward(const std::vector<Point<3>> &points,
                       const Tensor<1, 3> &up,
                       const std::optional<double> facing)
  {
    Posture posture;
    posture.up = up;
    posture.is_standing = up[2] > 1. - 1e-12;
    const Feature feature(points, up);
    const Tensor<1, 3> face =
      feature.middle(0.87, 1.) - feature.middle(0.80, 0.87);
    if (facing && posture.is_standing)
      posture.forward = Tensor<1, 3>(
        {std::cos(*facing * degree), std::sin(*facing * degree), 0.});
    else
      posture.forward = forward_by_feet(feature, up);
    posture.face_agrees = face * posture.forward > 0.;
    return posture;
  }


  /// The axis itself, or the coordinate axis next to it.
  Tensor<1, 3> snapped(const Tensor<1, 3> &axis)
  {
    Tensor<1, 3> result = axis;
    if (std::abs(axis[2]) > std::cos(45. * degree))
      result = Point<3>::unit_vector(2);
    else
      for (unsigned int d = 0; d < 2; ++d)
        if (std::abs(axis[d]) > std::cos(20. * degree))
          result = Point<3>::unit_vector(d);
    return result;
  }
} // namespace


Placement Posture::to_standing() const
{
  return Placement(1., angles_of(rotation_to_standing(*this)), {});
}


Placement Posture::from_standing() const
{
  return Placement(1., angles_of(transpose(rotation_to_standing(*this))), {});
}


Tensor<1, 3> Posture::angles() const
{
  return angles_of(rotation_to_standing(*this)) / degree;
}


double Posture::facing() const
{
  const double angle = std::atan2(forward[1], forward[0]) / degree;
  return std::abs(angle) < 1e-9 ? 0. : angle;
}


PosedPerson find_posture(const Shape &surface,
                         const std::optional<double> facing,
                         const std::optional<double> neck_height)
{
  const auto box = surface.bounding_box();
  double size = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    size = std::max(size, box.side_length(d));
  const LabelGrid grid = fill_shape(surface, size / 150.);
  std::vector<Point<3>> points;
  for (unsigned int k = 0; k < grid.size[2]; ++k)
    for (unsigned int j = 0; j < grid.size[1]; ++j)
      for (unsigned int i = 0; i < grid.size[0]; ++i)
        if (grid.at(i, j, k) != LabelGrid::outside)
          points.push_back(grid.center(i, j, k));
  if (points.empty())
    throw InputError("it has no inside");
  const Tensor<1, 3> axis = snapped(longest_axis(points));
  std::string reason;
  for (const double sign : {1., -1.})
    try
    {
      const Posture posture = find_forward(points, sign * axis, facing);
      return {posture,
              find_regions(PlacedShape(ShapePointer(ShapePointer(), &surface),
                                       posture.to_standing()),
                           neck_height)};
    }
    catch (const InputError &error)
    {
      if (reason.empty())
        reason = error.what();
    }
  throw InputError(reason);
}


std::string direction_name(const Tensor<1, 3> &direction)
{
  for (unsigned int d = 0; d < 3; ++d)
    if (std::abs(direction[d]) > std::cos(2. * degree))
      return std::string(direction[d] > 0. ? "+" : "-") + "xyz"[d];
  return "(" + coordinates(direction, 2) + ")";
}
} // namespace contrecoup
