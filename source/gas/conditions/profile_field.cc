// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/conditions/profile_file.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <cmath>

namespace contrecoup::gas
{
namespace
{
  /// Relative tolerance of positions, as a fraction of the domain.
  constexpr double same_place = 1e-9;

  template <int dim>
  GasState<dim> read_background(ParameterHandler &prm,
                                const GasMaterial &material)
  {
    const Section section(prm, "Background");
    return read_state<dim>(prm, material, "Initial state/Background");
  }

  std::shared_ptr<const Profile> read_file(ParameterHandler &prm)
  {
    const Section section(prm, "Profile");
    const UsedWith used("Initial state/Kind = profile");
    const std::string file = prm.get("File");
    if (file.empty())
      throw InputError("Initial state/Profile/File: Kind = profile needs the "
                       "name of a file");
    return std::make_shared<const Profile>(read_profile(file));
  }

  template <int dim>
  dealii::Point<dim> read_centre(ParameterHandler &prm)
  {
    const Section section(prm, "Profile");
    return dealii::Point<dim>(
      read_vector<dim>(prm, "Centre", "Initial state/Profile"));
  }
} // namespace


template <int dim>
void ProfileField<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Profile");
  declare_file(prm,
               "File",
               "",
               "A profile, HDF5 or .csv, that a spherical, cylindrical or "
               "axisymmetric run wrote (Output/Profile file).");
  declare_list(prm,
               "Centre",
               "0, 0, 0",
               1,
               3,
               -bounds::length,
               bounds::length,
               "m",
               "Position of the profile's centre or of the origin of its "
               "axis; axes are along z, in axisymmetric domains along y.");
}


template <int dim>
ProfileField<dim>::ProfileField(ParameterHandler &prm,
                                const GasMaterial &material,
                                const Geometry geometry)
  : ProfileField(read_file(prm),
                 read_centre<dim>(prm),
                 read_background<dim>(prm, material),
                 material,
                 geometry)
{}


template <int dim>
ProfileField<dim>::ProfileField(std::shared_ptr<const Profile> profile,
                                const dealii::Point<dim> &centre,
                                const GasState<dim> &background,
                                const GasMaterial &material,
                                const Geometry geometry)
  : profile_(std::move(profile))
  , centre_(centre)
  , background_(background)
  , material_(material)
  , ambient_(conserved_state(background, material, dim + 3))
  , is_axisymmetric_target_(geometry == Geometry::axisymmetric)
{
  if (profile_->data().geometry != Geometry::spherical)
    n_radial_ = is_axisymmetric_target_ ? 1 : std::min(dim, 2);
  check(geometry);
}


template <int dim>
void ProfileField<dim>::check(const Geometry geometry) const
{
  const Geometry own = profile_->data().geometry;
  const bool fits = own == Geometry::spherical
                      ? geometry == Geometry::spherical ||
                          geometry == Geometry::axisymmetric ||
                          (geometry == Geometry::plane && dim == 3)
                    : own == Geometry::cylindrical
                      ? geometry == Geometry::cylindrical ||
                          (geometry == Geometry::plane && dim > 1)
                      : geometry == Geometry::axisymmetric ||
                          (geometry == Geometry::plane && dim == 3);
  if (!fits)
    throw InputError("Initial state/Profile: spherical profiles go with "
                     "spherical, axisymmetric and 3-D domains, cylindrical "
                     "ones with cylindrical, plane 2-D and 3-D domains, "
                     "axisymmetric ones with axisymmetric and 3-D domains");
  if (geometry != Geometry::plane && centre_[0] != 0.)
    throw InputError("Initial state/Profile/Centre: the first coordinate is "
                     "the radius in this domain and must be 0");
  if (background_.velocity.norm() > 0.)
    throw InputError("Initial state/Background: a profile needs gas at rest "
                     "around it");
  const auto &data = profile_->data();
  const std::array<double, 3> mine = {
    {ambient_[0], ambient_[dim + 1], ambient_[dim + 2]}};
  for (unsigned int i = 0; i < 3; ++i)
    if (std::abs(mine[i] - data.ambient[i]) >
        1e-6 * (i == 2 ? mine[0] : std::abs(mine[i])))
      throw InputError("Initial state/Background has another state than the "
                       "gas around the profile, whose density is " +
                       brief(data.ambient[0], 8) + " kg/m^3 and pressure " +
                       brief(data.ambient_pressure, 8) +
                       " Pa, or another material");
}


template <int dim>
typename ProfileField<dim>::Window ProfileField<dim>::window(
  const dealii::Point<dim> &place,
  const std::array<dealii::Tensor<1, dim>, dim> &edges) const
{
  Window result;
  dealii::Tensor<1, dim> radial = place - centre_;
  for (unsigned int d = n_radial_; d < dim; ++d)
    radial[d] = 0.;
  result.place[0] = radial.norm();
  if (result.place[0] > 0.)
    result.direction[0] = radial / result.place[0];
  if (profile_->n_directions() == 2)
  {
    result.place[1] = place[dim - 1] - centre_[dim - 1];
    result.direction[1][dim - 1] = 1.;
  }
  for (unsigned int i = 0; i < profile_->n_directions(); ++i)
  {
    double square = 0.;
    for (const auto &edge : edges)
    {
      const double along = result.direction[i] * edge;
      square += along * along;
      result.half_extent[i] += 0.5 * std::abs(along);
    }
    result.width[i] = std::sqrt(square);
  }
  // Points off the radius through the centre are farther from the profile's
  // centre: second-order correction of the mean distance.
  double beside = 0.;
  for (auto edge : edges)
  {
    for (unsigned int d = n_radial_; d < dim; ++d)
      edge[d] = 0.;
    const double along = result.direction[0] * edge;
    beside += (edge.norm_square() - along * along) / 12.;
  }
  if (result.place[0] > 0.)
    result.place[0] +=
      std::min(beside / (2. * result.place[0]), 0.5 * result.width[0]);
  return result;
}


template <int dim>
bool ProfileField<dim>::is_beyond(const Window &window,
                                  const double distance) const
{
  for (unsigned int i = 0; i < profile_->n_directions(); ++i)
    if (window.place[i] - window.half_extent[i] > profile_->end(i) + distance ||
        window.place[i] + window.half_extent[i] < profile_->begin(i) - distance)
      return true;
  return false;
}


template <int dim>
double ProfileField<dim>::variation(const Window &window) const
{
  std::array<double, 2> lower{}, upper{};
  for (unsigned int i = 0; i < profile_->n_directions(); ++i)
  {
    lower[i] = window.place[i] - window.half_extent[i];
    upper[i] = window.place[i] + window.half_extent[i];
    if (!(lower[i] < upper[i]))
      return 0.;
  }
  return profile_->variation(lower, upper);
}


template <int dim>
void ProfileField<dim>::mean(const Window &window,
                             std::vector<double> &excess) const
{
  std::array<double, 2> lower{}, upper{};
  const unsigned int n = profile_->n_directions();
  for (unsigned int i = 0; i < n; ++i)
  {
    const double half =
      0.5 * std::max(window.width[i], profile_->cell_width(i, window.place[i]));
    lower[i] = window.place[i] - half;
    upper[i] = window.place[i] + half;
  }
  std::array<double, 5> means;
  profile_->mean(lower, upper, means.data());
  excess.assign(dim + 3, 0.);
  excess[0] = means[0];
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int d = 0; d < dim; ++d)
      excess[1 + d] += means[1 + i] * window.direction[i][d];
  excess[dim + 1] = means[n + 1];
  excess[dim + 2] = means[n + 2];
}


template <int dim>
GasState<dim> ProfileField<dim>::value(const dealii::Point<dim> &point) const
{
  const Window here = window(point, {});
  if (is_beyond(here))
    return background_;
  std::vector<double> u;
  mean(here, u);
  for (unsigned int c = 0; c < u.size(); ++c)
    u[c] += ambient_[c];
  return primitive_state<dim>(u.data(), material_);
}


template <int dim>
std::optional<double>
ProfileField<dim>::fraction_within(const dealii::Point<dim> &lower,
                                   const dealii::Point<dim> &upper) const
{
  double fraction = 1.;
  const double radius = profile_->end(0);
  for (unsigned int i = 0; i < profile_->n_directions(); ++i)
    if (profile_->is_cut(i, true) || (i == 0 && profile_->is_cut(i, false)))
      return {};
  for (unsigned int d = 0; d < n_radial_; ++d)
  {
    const double below = centre_[d] - lower[d], above = upper[d] - centre_[d];
    const double tolerance = same_place * (upper[d] - lower[d]);
    if (d == 0 && (dim == 1 || is_axisymmetric_target_))
    {
      if (below > tolerance || below < -tolerance || above < radius)
        return {};
      continue;
    }
    if (std::min(below, above) < -tolerance || std::max(below, above) < radius)
      return {};
    if (std::min(below, above) <= tolerance)
      fraction *= 0.5;
    else if (std::min(below, above) < radius)
      return {};
  }
  if (profile_->n_directions() == 2)
  {
    const double tolerance = same_place * (upper[dim - 1] - lower[dim - 1]);
    const double low = centre_[dim - 1] + profile_->begin(1) - lower[dim - 1];
    const double high = upper[dim - 1] - centre_[dim - 1] - profile_->end(1);
    const bool closed_below = profile_->is_cut(1, false)
                                ? std::abs(low) <= tolerance
                                : low >= -tolerance;
    if (!closed_below || high < -tolerance)
      return {};
  }
  return fraction;
}


template <int dim>
std::array<double, 3>
ProfileField<dim>::totals(const double fraction,
                          const dealii::Point<dim> &lower,
                          const dealii::Point<dim> &upper) const
{
  const auto &sums = profile_->totals();
  const unsigned int n = profile_->n_directions();
  double factor = fraction;
  if (profile_->data().geometry == Geometry::cylindrical && dim == 3)
    factor *= upper[dim - 1] - lower[dim - 1];
  return {{factor * sums[0], factor * sums[n + 1], factor * sums[n + 2]}};
}


template class ProfileField<1>;
template class ProfileField<2>;
template class ProfileField<3>;
} // namespace contrecoup::gas
