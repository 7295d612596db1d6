// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/timers.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <cmath>

namespace contrecoup::solid
{
namespace
{
  /// Limit of Lanczos iterations; the largest frequency needs far fewer.
  constexpr unsigned int most_iterations = 200;

  /// Relative uncertainty of the frequency at which iterations stop.
  constexpr double tolerance = 2e-3;

  /// Pseudo-random number in [-1, 1] of a node and direction.
  double pseudo_random(const std::uint64_t node, const unsigned int direction)
  {
    std::uint64_t x = (3 * node + direction + 1) * 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x ^= x >> 27;
    return static_cast<double>(x >> 11) / 4503599627370496. - 1.;
  }

  /// Largest eigenvalue of a symmetric tridiagonal matrix by bisection with
  /// Sturm sequences, and the last entry of its unit eigenvector.
  std::pair<double, double>
  largest_eigenvalue(const std::vector<double> &diagonal,
                     const std::vector<double> &off)
  {
    const std::size_t n = diagonal.size();
    double low = diagonal[0], high = diagonal[0];
    for (std::size_t i = 0; i < n; ++i)
    {
      const double radius =
        (i > 0 ? off[i - 1] : 0.) + (i + 1 < n ? off[i] : 0.);
      low = std::max(low, diagonal[i]);
      high = std::max(high, diagonal[i] + radius);
    }
    for (unsigned int iteration = 0; iteration < 100; ++iteration)
    {
      const double middle = 0.5 * (low + high);
      bool above = false; // whether an eigenvalue exceeds the midpoint
      double pivot = middle - diagonal[0];
      for (std::size_t i = 1; i < n && !above; ++i)
      {
        above = pivot <= 0.;
        pivot = middle - diagonal[i] - off[i - 1] * off[i - 1] / pivot;
      }
      (above || pivot <= 0. ? low : high) = middle;
    }
    // The rows of the matrix give the eigenvector from its first entry.
    std::vector<double> v(n, 1.);
    double square = 1.;
    for (std::size_t i = 0; i + 1 < n; ++i)
    {
      const double left = i > 0 ? off[i - 1] * v[i - 1] : 0.;
      v[i + 1] = ((high - diagonal[i]) * v[i] - left) / off[i];
      square += v[i + 1] * v[i + 1];
    }
    return {high, std::abs(v.back()) / std::sqrt(square)};
  }
} // namespace


template <typename Real>
double SolidBody<Real>::lanczos_step(double &before, double &next)
{
  // Displacements hold the current Lanczos vector, velocities the previous.
  operator_.add_linear_forces(nodes_);
  gather_hanging(nodes_.force.data(), 3, nodes_.width);
  exchange_.add(nodes_.force.data(), 3, nodes_.width);
  supports_.zero_supported_forces(nodes_);
  double product = 0.;
  for (std::size_t i = 0; i < counted_.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      product -= counted_[i] * double(nodes_.force_of(i)[d]) *
                 double(nodes_.displacement_of(i)[d]);
  const double alpha = dealii::Utilities::MPI::sum(product, communicator_);
  double square = 0.;
  for (std::size_t i = 0; i < counted_.size(); ++i)
  {
    const double inverse_mass = nodes_.inverse_mass_of(i);
    for (unsigned int d = 0; d < 3; ++d)
    {
      Real &now = nodes_.displacement_of(i)[d];
      Real &old = nodes_.velocity_of(i)[d];
      Real &force = nodes_.force_of(i)[d];
      const double w = -inverse_mass * double(force) - alpha * double(now) -
                       before * double(old);
      force = Real();
      old = now;
      now = static_cast<Real>(w);
      if (counted_[i] != 0)
        square += w * w / inverse_mass;
    }
  }
  next = std::sqrt(dealii::Utilities::MPI::sum(square, communicator_));
  if (next > 0.)
    for (std::size_t i = 0; i < counted_.size(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        nodes_.displacement_of(i)[d] /= static_cast<Real>(next);
  before = next;
  // Hanging nodes follow their masters and have no part in the sums.
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
    for (unsigned int d = 0; d < 3; ++d)
    {
      Real value{};
      for (std::size_t i = 0; i < one.masters.size(); ++i)
        value += static_cast<Real>(one.weights[i]) *
                 nodes_.displacement_of(one.masters[i])[d];
      nodes_.displacement_of(one.node)[d] = value;
    }
  return alpha;
}


template <typename Real>
double SolidBody<Real>::largest_square_frequency(double &uncertainty,
                                                 unsigned int &n)
{
  double square = 0.;
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      nodes_.force_of(i)[d] =
        static_cast<Real>(pseudo_random(mesh_.global_node[i], d));
  supports_.zero_supported_forces(nodes_);
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double value = nodes_.force_of(i)[d];
      nodes_.force_of(i)[d] = Real();
      nodes_.displacement_of(i)[d] = static_cast<Real>(value);
      if (counted_[i] != 0)
        square += value * value / double(nodes_.inverse_mass_of(i));
    }
  square = dealii::Utilities::MPI::sum(square, communicator_);
  uncertainty = 0.;
  if (!(square > 0.))
    return 0.;
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      nodes_.displacement_of(i)[d] /= static_cast<Real>(std::sqrt(square));
  move_hanging();

  std::vector<double> diagonal, off;
  double before = 0., result = 0.;
  for (n = 1; n <= most_iterations; ++n)
  {
    double next = 0.;
    diagonal.push_back(lanczos_step(before, next));
    const auto [value, last] = largest_eigenvalue(diagonal, off);
    result = value;
    // An eigenvalue lies within this bound of the computed value.
    uncertainty = 0.5 * next * last / value;
    if (!(next > 1e-12 * value) || (n > 5 && uncertainty < tolerance))
      break;
    off.push_back(next);
  }
  n = std::min(n, most_iterations);
  return result;
}


template <typename Real>
StableStep SolidBody<Real>::find_stable_step()
{
  const TimerScope timer("step size");
  StableStep stable_step;
  const double square =
    largest_square_frequency(stable_step.uncertainty, stable_step.iterations);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
    {
      nodes_.displacement_of(i)[d] = Real();
      nodes_.velocity_of(i)[d] = Real();
      nodes_.force_of(i)[d] = Real();
    }
  find_weakest_element(stable_step);
  stable_step.body_step =
    square > 0. ? 2. / (std::sqrt(square) * (1. + stable_step.uncertainty))
                : stable_step.element_step;
  return stable_step;
}


template <typename Real>
void SolidBody<Real>::find_weakest_element(StableStep &stable_step)
{
  double largest = 0.;
  std::vector<double> squares(mesh_.tissues.size(), 0.);
  std::uint32_t weakest = 0;
  for (std::uint32_t i = 0; i < mesh_.elements.size(); ++i)
  {
    HexVectors<double> x;
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        x[c][d] = mesh_.nodes[mesh_.elements[i][c]][d];
    const HexGeometry<double> geometry = hex_geometry(to_modes(x));
    const SolidMaterial &material = operator_.materials()[mesh_.tissue[i]];
    const double square = element_square_frequency(geometry, material);
    squares[mesh_.tissue[i]] = std::max(squares[mesh_.tissue[i]], square);
    if (square > largest)
    {
      largest = square;
      weakest = i;
    }
  }
  struct
  {
    double value;
    int rank;
  } mine, all;
  mine.value = largest;
  mine.rank = dealii::Utilities::MPI::this_mpi_process(communicator_);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator_);
  std::array<double, 5> numbers{};
  if (all.rank == mine.rank && !mesh_.elements.empty())
  {
    dealii::Point<3> centre;
    for (const std::uint32_t node : mesh_.elements[weakest])
      centre += mesh_.nodes[node] / 8.;
    numbers = {{double(mesh_.global_element[weakest]),
                double(mesh_.tissues[mesh_.tissue[weakest]]),
                centre[0],
                centre[1],
                centre[2]}};
  }
  MPI_Bcast(numbers.data(), 5, MPI_DOUBLE, all.rank, communicator_);
  dealii::Utilities::MPI::max(squares, communicator_, squares);
  element_steps_.clear();
  for (const double square : squares)
    element_steps_.push_back(2. / std::sqrt(square));
  stable_step.element_step = 2. / std::sqrt(all.value);
  stable_step.element = static_cast<std::uint32_t>(numbers[0]);
  stable_step.tissue = static_cast<Tissue>(static_cast<int>(numbers[1]));
  stable_step.center = dealii::Point<3>(numbers[2], numbers[3], numbers[4]);
}


template class SolidBody<double>;
template class SolidBody<float>;
} // namespace contrecoup::solid
