// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/boundary/surroundings.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace contrecoup::solid
{
namespace
{
  /// Sum of function(node, mass [kg]) over the counted nodes.
  template <typename Real, typename Function>
  double sum_over(const NodeFields<Real> &nodes,
                  const std::vector<unsigned char> &counted,
                  const Function &function)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < counted.size(); ++i)
      if (counted[i] != 0)
        sum += function(i, 1. / double(nodes.inverse_mass_of(i)));
    return sum;
  }
} // namespace


void Surroundings::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Gravity");
    declare_list(prm,
                 "Acceleration",
                 "0, 0, 0",
                 3,
                 3,
                 -1e6,
                 1e6,
                 "m/s^2",
                 "Acceleration of free fall, as 0, 0, -9.81; within the "
                 "milliseconds of a blast it matters little.");
  }
  const Section section(prm, "Ground");
  declare_bool(prm,
               "Active",
               "false",
               "Whether there is rigid frictionless ground below the body.");
  const UsedWith used("Ground/Active = true");
  declare_double(
    prm, "Height", "0", -1e6, 1e6, "m", "z coordinate of the ground.");
  declare_double(prm,
                 "Stiffness",
                 "0.02",
                 1e-6,
                 0.5,
                 "-",
                 "Penalty stiffness of the contact, as a fraction of nodal "
                 "mass times 4 / step^2. Contact changes the energy of the "
                 "nodes that hit the ground by about this fraction; a "
                 "larger value reduces penetration.");
}


void Surroundings::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Gravity");
    gravity_ = read_point<3>(prm, "Acceleration");
    has_gravity_ = gravity_.norm() > 0.;
  }
  const Section section(prm, "Ground");
  has_ground_ = prm.get_bool("Active");
  height_ = read_double(prm, "Height");
  stiffness_fraction_ = read_double(prm, "Stiffness");
}


void Surroundings::set_step(const double step, const double used)
{
  if (has_ground_ && !(used + stiffness_fraction_ <= 1.))
    throw InputError("Ground/Stiffness = " + brief(stiffness_fraction_) +
                     " makes steps unstable; the body itself uses " +
                     brief(used) + ", which leaves at most " +
                     brief(1. - used) +
                     "; a smaller Elements/Step safety leaves more");
  stiffness_ = 4. * stiffness_fraction_ / (step * step);
}


template <typename Real>
double Surroundings::depth(const NodeFields<Real> &nodes,
                           const std::size_t node) const
{
  const Real *coordinates =
    &nodes.position_and_displacement[nodes.position_width * node];
  return height_ - (double(coordinates[2]) + double(coordinates[5]));
}


template <typename Real>
void Surroundings::refuse_buried(const NodeFields<Real> &nodes,
                                 const MPI_Comm communicator) const
{
  namespace mpi = dealii::Utilities::MPI;
  if (!has_ground_)
    return;
  std::pair<double, std::size_t> deepest{0., 0};
  double scale = std::abs(height_);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    deepest = std::max(deepest, {depth(nodes, i), i});
    scale = std::max(
      scale,
      std::abs(
        double(nodes.position_and_displacement[nodes.position_width * i + 2])));
  }
  // Coordinates have rounding errors.
  const double allowed =
    4. * std::numeric_limits<Real>::epsilon() * mpi::max(scale, communicator);
  const double deep = mpi::max(deepest.first, communicator);
  if (!(deep > allowed))
    return;
  const unsigned int mine = mpi::this_mpi_process(communicator);
  const unsigned int first = mpi::min(
    deepest.first == deep ? mine : std::numeric_limits<unsigned int>::max(),
    communicator);
  std::array<double, 2> place{};
  if (mine == first)
    for (unsigned int d = 0; d < 2; ++d)
      place[d] =
        nodes
          .position_and_displacement[nodes.position_width * deepest.second + d];
  MPI_Bcast(place.data(), 2, MPI_DOUBLE, static_cast<int>(first), communicator);
  throw InputError("Ground/Height = " + brief(height_) + " m: the body is " +
                   brief(1e3 * deep) +
                   " mm in the ground at the start, at x = " +
                   brief(place[0], 3) + " m, y = " + brief(place[1], 3) +
                   " m, and would be thrown off; move the body up by that "
                   "much, or the ground down");
}


template <typename Real>
void Surroundings::add_forces(NodeFields<Real> &nodes) const
{
  if (!has_gravity_ && !has_ground_)
    return;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double inverse_mass = nodes.inverse_mass_of(i);
    if (!(inverse_mass > 0.))
      continue;
    Real *force = nodes.force_of(i);
    if (has_gravity_)
      for (unsigned int d = 0; d < 3; ++d)
        force[d] += static_cast<Real>(gravity_[d] / inverse_mass);
    if (has_ground_)
      force[2] += static_cast<Real>(stiffness_ / inverse_mass *
                                    std::max(0., depth(nodes, i)));
  }
}


template <typename Real>
double Surroundings::power(const NodeFields<Real> &nodes,
                           const std::vector<unsigned char> &counted) const
{
  return has_gravity_ ? sum_over(nodes,
                                 counted,
                                 [&](const std::size_t i, const double mass) {
                                   double product = 0.;
                                   for (unsigned int d = 0; d < 3; ++d)
                                     product += gravity_[d] *
                                                double(nodes.velocity_of(i)[d]);
                                   return product * mass;
                                 })
                      : 0.;
}


template <typename Real>
double
Surroundings::contact_energy(const NodeFields<Real> &nodes,
                             const std::vector<unsigned char> &counted) const
{
  return has_ground_
           ? sum_over(nodes,
                      counted,
                      [&](const std::size_t i, const double mass) {
                        const double below = std::max(0., depth(nodes, i));
                        return 0.5 * stiffness_ * below * below * mass;
                      })
           : 0.;
}


template <typename Real>
double
Surroundings::contact_force(const NodeFields<Real> &nodes,
                            const std::vector<unsigned char> &counted) const
{
  return has_ground_ ? sum_over(nodes,
                                counted,
                                [&](const std::size_t i, const double mass) {
                                  return stiffness_ *
                                         std::max(0., depth(nodes, i)) * mass;
                                })
                     : 0.;
}


template void Surroundings::refuse_buried(const NodeFields<double> &,
                                          MPI_Comm) const;
template void Surroundings::refuse_buried(const NodeFields<float> &,
                                          MPI_Comm) const;
template void Surroundings::add_forces(NodeFields<double> &) const;
template void Surroundings::add_forces(NodeFields<float> &) const;
template double Surroundings::power(const NodeFields<double> &,
                                    const std::vector<unsigned char> &) const;
template double Surroundings::power(const NodeFields<float> &,
                                    const std::vector<unsigned char> &) const;
template double
Surroundings::contact_energy(const NodeFields<double> &,
                             const std::vector<unsigned char> &) const;
template double
Surroundings::contact_energy(const NodeFields<float> &,
                             const std::vector<unsigned char> &) const;
template double
Surroundings::contact_force(const NodeFields<double> &,
                            const std::vector<unsigned char> &) const;
template double
Surroundings::contact_force(const NodeFields<float> &,
                            const std::vector<unsigned char> &) const;
} // namespace contrecoup::solid
