// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/explosive/charge_volume.h>
#include <contrecoup/gas/octree/leaf_box.h>

#include <cmath>

namespace contrecoup::gas
{
namespace
{
  /// Fractions within this tolerance of 0 or 1 are rounded to 0 or 1.
  constexpr double sliver = 1e-13;

  /// Part of a leaf between two positions in reference coordinates.
  template <int dim>
  struct LeafPart
  {
    dealii::Point<dim> begin, end;

    dealii::Point<dim> center() const
    {
      return dealii::Point<dim>((begin + end) * 0.5);
    }
  };

  template <int dim>
  class LeafCutter
  {
  public:
    LeafCutter(const Charge<dim> &charge,
               const LeafPoints<dim> &points,
               const LeafBox<dim> &box)
      : charge_(charge)
      , points_(points)
      , box_(box)
    {}

    double volume(const LeafPart<dim> &region) const
    {
      if (box_.is_box())
        return points_.volume(
          box_.origin, box_.extents, region.begin, region.end);
      double result = box_.jacobian(region.center());
      for (unsigned int d = 0; d < dim; ++d)
        result *= region.end[d] - region.begin[d];
      return result;
    }

    /// Fraction of the volume of @p region that the charge fills [-].
    double fraction(const LeafPart<dim> &region) const
    {
      const auto corners = charge_.as_box();
      if (corners && box_.is_box())
        return overlap(region, corners->first, corners->second);
      // Size of the smallest parts: an eighth of the region or, if smaller, of
      // the charge; finer in 2-D, where it costs little.
      const unsigned int least = dim == 3 ? 3 : 6, most = 40;
      const double ratio = 2. * radius(region) / charge_.smallest_size();
      const double more = std::max(0., std::ceil(std::log2(ratio)));
      const unsigned int depth =
        least + static_cast<unsigned int>(std::min(more, double(most)));
      double inside = 0., all = 0.;
      add(region, depth, inside, all);
      const double result = inside / all;
      return result < sliver ? 0. : (result > 1. - sliver ? 1. : result);
    }

  private:
    /// Distance from the centre of a region to its farthest corner [m].
    double radius(const LeafPart<dim> &region) const
    {
      const dealii::Point<dim> center = box_.place(region.center());
      double result = 0.;
      for (unsigned int corner = 0; corner < (1U << dim); ++corner)
      {
        dealii::Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = (corner >> d) & 1U ? region.end[d] : region.begin[d];
        result = std::max(result, center.distance(box_.place(x)));
      }
      return result;
    }

    double overlap(const LeafPart<dim> &region,
                   const dealii::Point<dim> &lower,
                   const dealii::Point<dim> &upper) const
    {
      LeafPart<dim> common;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double low = (lower[d] - box_.origin[d]) / box_.extents[d];
        const double high = (upper[d] - box_.origin[d]) / box_.extents[d];
        common.begin[d] = std::max(region.begin[d], low);
        common.end[d] = std::min(region.end[d], high);
        if (!(common.begin[d] < common.end[d]))
          return 0.;
      }
      const double result = volume(common) / volume(region);
      return result < sliver ? 0. : (result > 1. - sliver ? 1. : result);
    }

    void add(const LeafPart<dim> &region,
             const unsigned int depth,
             double &inside,
             double &all) const
    {
      const double distance =
        charge_.signed_distance(box_.place(region.center()));
      const double region_radius = radius(region);
      if (std::abs(distance) < region_radius && depth > 0)
      {
        for (unsigned int child = 0; child < (1U << dim); ++child)
        {
          LeafPart<dim> octant = region;
          const dealii::Point<dim> middle = region.center();
          for (unsigned int d = 0; d < dim; ++d)
            ((child >> d) & 1U ? octant.begin : octant.end)[d] = middle[d];
          add(octant, depth - 1, inside, all);
        }
        return;
      }
      const double fraction =
        0.5 - distance * std::sqrt(double(dim)) / (2. * region_radius);
      const double whole = volume(region);
      inside += whole * std::min(std::max(fraction, 0.), 1.);
      all += whole;
    }

    const Charge<dim> &charge_;
    const LeafPoints<dim> &points_;
    const LeafBox<dim> &box_;
  };

  /// Adds the parts of a leaf to the list, their volume to the first sum, and
  /// the derivative of the volume with respect to lambda to the second.
  template <int dim>
  void add_leaf(const unsigned int leaf,
                const Charge<dim> &charge,
                const LeafPoints<dim> &points,
                const LeafBox<dim> &box,
                ChargeVolume &result,
                std::vector<double> &sums)
  {
    const LeafCutter<dim> cutter(charge, points, box);
    const unsigned int n_points = dealii::Utilities::pow(points.n(), dim);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const auto index = points.indices(q);
      LeafPart<dim> region;
      for (unsigned int d = 0; d < dim; ++d)
      {
        region.begin[d] = points.subcell_begin(index[d]);
        region.end[d] = points.subcell_end(index[d]);
      }
      const double fraction = cutter.fraction(region);
      if (fraction == 0.)
        continue;
      const double volume = point_volume(box, points, q);
      result.contributions.push_back({leaf, q, fraction});
      sums[0] += fraction * volume;
      sums[1] += fraction * (1. - fraction) * volume;
    }
  }
} // namespace


template <int dim>
ChargeVolume charge_volume(const Charge<dim> &charge,
                           const LeafMesh<dim> &mesh,
                           const LeafPoints<dim> &points)
{
  ChargeVolume result;
  std::vector<double> sums(2, 0.);
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const LeafBox<dim> box = leaf_box(mesh, leaf);
    const dealii::Point<dim> center =
      box.origin + dealii::Tensor<1, dim>(box.extents * 0.5);
    if (charge.signed_distance(center) < 0.5 * box.extents.norm())
      add_leaf(leaf, charge, points, box, result, sums);
  }
  dealii::Utilities::MPI::sum(sums, mesh.communicator(), sums);
  result.total = sums[0];
  const auto fraction = charge.fraction_within(mesh.coarse_mesh());
  if (!fraction || !(sums[0] > 0.))
    return result;

  const double exact = *fraction * charge.volume();
  const double missing = exact - sums[0];
  result.is_exact = true;
  // A surface along subcell faces leaves only round-off.
  if (std::abs(missing) < 1e-13 * exact)
    return result;
  const double lambda = missing / sums[1];
  if (!(std::abs(lambda) < 1.))
    throw NumericsError("The mesh cannot resolve a charge of the given volume");
  for (auto &contribution : result.contributions)
    contribution.fraction +=
      lambda * contribution.fraction * (1. - contribution.fraction);
  result.total = exact;
  return result;
}


template ChargeVolume
charge_volume(const Charge<1> &, const LeafMesh<1> &, const LeafPoints<1> &);
template ChargeVolume
charge_volume(const Charge<2> &, const LeafMesh<2> &, const LeafPoints<2> &);
template ChargeVolume
charge_volume(const Charge<3> &, const LeafMesh<3> &, const LeafPoints<3> &);
} // namespace contrecoup::gas
