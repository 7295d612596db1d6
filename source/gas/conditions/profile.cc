// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/conditions/profile.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
namespace
{
  using boost::math::double_constants::pi;

  /// Largest number of rows of the table: density, two components of momentum,
  /// energy, products, variation.
  constexpr unsigned int most_rows = 6;

  [[noreturn]] void refuse(const std::string &what)
  {
    throw InputError("The profile " + what);
  }
} // namespace


Profile::Profile(ProfileData data)
  : data_(std::move(data))
{
  check();
  n_cells_ = {{static_cast<unsigned int>(data_.edges[0].size() - 1), 1}};
  if (n_directions() == 2)
    n_cells_[1] = static_cast<unsigned int>(data_.edges[1].size() - 1);
  sum_up();
}


void Profile::check() const
{
  const bool has_axis = data_.geometry == Geometry::axisymmetric;
  if (data_.geometry == Geometry::plane)
    refuse("must be spherical, cylindrical or axisymmetric");
  if (data_.edges.size() != (has_axis ? 2u : 1u) ||
      data_.domain_begin.size() != data_.edges.size() ||
      data_.domain_end.size() != data_.edges.size())
    refuse("needs edges of cells for each of its directions");
  std::size_t n = 1;
  for (const auto &edges : data_.edges)
  {
    if (edges.size() < 2)
      refuse("has no cells");
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
      if (!(edges[i] < edges[i + 1]))
        refuse("has edges of cells that do not increase");
    n *= edges.size() - 1;
  }
  if (data_.edges[0][0] < 0.)
    refuse("has a negative radius");
  if (!(data_.ambient[0] > 0. && data_.ambient[1] > 0.))
    refuse("has an ambient state without mass or energy");
  if (data_.values.size() != n_components())
    refuse("has not " + std::to_string(n_components()) + " quantities");
  for (const auto &values : data_.values)
  {
    if (values.size() != n)
      refuse("has quantities that are not given in each of its cells");
    for (const double value : values)
      if (!std::isfinite(value))
        refuse("has a number that is not finite");
  }
  const auto &density = data_.values[0];
  const auto &energy = data_.values[n_components() - 2];
  for (std::size_t i = 0; i < n; ++i)
    if (!(density[i] > 0. && energy[i] > 0.))
      refuse("has a cell without mass or energy");
}


bool Profile::is_cut(const unsigned int direction, const bool upper) const
{
  const double raster = upper ? end(direction) : begin(direction);
  if (direction == 0 && !upper && raster == 0.)
    return false;
  const double domain =
    upper ? data_.domain_end[direction] : data_.domain_begin[direction];
  return std::abs(raster - domain) <=
         1e-9 * (end(direction) - begin(direction));
}


double Profile::volume(const unsigned int cell) const
{
  const unsigned int i = cell % n_cells_[0], j = cell / n_cells_[0];
  const double a = data_.edges[0][i], b = data_.edges[0][i + 1];
  if (data_.geometry == Geometry::spherical)
    return 4. / 3. * pi * (b - a) * (a * a + a * b + b * b);
  const double ring = pi * (b - a) * (a + b);
  return n_directions() == 1
           ? ring
           : ring * (data_.edges[1][j + 1] - data_.edges[1][j]);
}


std::vector<double> Profile::variations() const
{
  const unsigned int n = n_cells_[0] * n_cells_[1];
  const unsigned int energy = n_components() - 2;
  const auto width = [&](const unsigned int d, const unsigned int k) {
    return data_.edges[d][k + 1] - data_.edges[d][k];
  };
  std::vector<double> result(n, 0.);
  for (unsigned int cell = 0; cell < n; ++cell)
  {
    const std::array<unsigned int, 2> place = {
      {cell % n_cells_[0], cell / n_cells_[0]}};
    for (unsigned int d = 0; d < n_directions(); ++d)
    {
      const unsigned int stride = d == 0 ? 1 : n_cells_[0];
      const bool is_last = place[d] + 1 == n_cells_[d];
      if (is_last && is_cut(d, true))
        continue;
      const double density =
        is_last ? data_.ambient[0] : data_.values[0][cell + stride];
      const double other =
        is_last ? data_.ambient[1] : data_.values[energy][cell + stride];
      const double jump =
        std::abs(std::log(density / data_.values[0][cell])) +
        std::abs(std::log(other / data_.values[energy][cell]));
      const double half = is_last ? 1. : 0.5;
      result[cell] += half * jump / width(d, place[d]);
      if (!is_last)
        result[cell + stride] += half * jump / width(d, place[d] + 1);
    }
  }
  return result;
}


void Profile::sum_up()
{
  const unsigned int n = n_cells_[0] * n_cells_[1], nc = n_components();
  std::vector<double> ambient(nc, 0.);
  ambient[0] = data_.ambient[0];
  ambient[nc - 2] = data_.ambient[1];
  ambient[nc - 1] = data_.ambient[2];

  totals_.assign(nc, 0.);
  for (unsigned int cell = 0; cell < n; ++cell)
    for (unsigned int c = 0; c < nc; ++c)
      totals_[c] += volume(cell) * (data_.values[c][cell] - ambient[c]);

  const std::vector<double> variation = variations();
  const unsigned int rows = nc + 1, line = n_cells_[0] + 1;
  table_.assign(std::size_t(rows) * line * (n_cells_[1] + 1), 0.);
  const auto corner = [&](const unsigned int i, const unsigned int j) {
    return table_.data() + (std::size_t(j) * line + i) * rows;
  };
  for (unsigned int j = 0; j < n_cells_[1]; ++j)
  {
    const double height =
      n_directions() == 2 ? data_.edges[1][j + 1] - data_.edges[1][j] : 1.;
    std::vector<double> sum(rows, 0.);
    for (unsigned int i = 0; i < n_cells_[0]; ++i)
    {
      const unsigned int cell = i + n_cells_[0] * j;
      const double area = height * (data_.edges[0][i + 1] - data_.edges[0][i]);
      for (unsigned int c = 0; c < rows; ++c)
      {
        sum[c] += area * (c < nc ? data_.values[c][cell] - ambient[c]
                                 : variation[cell]);
        corner(i + 1, j + 1)[c] = corner(i + 1, j)[c] + sum[c];
      }
    }
  }
}


unsigned int Profile::index(const unsigned int direction,
                            const double place) const
{
  const auto &edges = data_.edges[direction];
  // First guess: most profiles have equal cells.
  const double fraction =
    (place - edges.front()) / (edges.back() - edges.front());
  const double last = static_cast<double>(edges.size() - 2);
  const auto guess = static_cast<unsigned int>(
    std::min(std::max(fraction * (last + 1.), 0.), last));
  if (edges[guess] <= place && place < edges[guess + 1])
    return guess;
  const auto above =
    std::upper_bound(edges.begin() + 1, edges.end() - 1, place);
  return static_cast<unsigned int>(above - edges.begin() - 1);
}


double Profile::cell_width(const unsigned int direction,
                           const double place) const
{
  const unsigned int i = index(direction, place);
  return data_.edges[direction][i + 1] - data_.edges[direction][i];
}


void Profile::integral(const std::array<double, 2> &place,
                       const unsigned int begin,
                       const unsigned int end,
                       double *sums) const
{
  const unsigned int rows = n_components() + 1, line = n_cells_[0] + 1;
  const auto fraction = [&](const unsigned int d, const unsigned int i) {
    const double low = data_.edges[d][i], high = data_.edges[d][i + 1];
    return (std::min(std::max(place[d], low), high) - low) / (high - low);
  };
  const unsigned int i = index(0, place[0]);
  const double s = fraction(0, i);
  if (n_directions() == 1)
  {
    const double *low = table_.data() + (std::size_t(line) + i) * rows;
    for (unsigned int c = begin; c < end; ++c)
      sums[c] = (1. - s) * low[c] + s * low[c + rows];
    return;
  }
  const unsigned int j = index(1, place[1]);
  const double t = fraction(1, j);
  const double *low = table_.data() + (std::size_t(j) * line + i) * rows;
  const double *high = low + std::size_t(line) * rows;
  for (unsigned int c = begin; c < end; ++c)
    sums[c] = (1. - t) * ((1. - s) * low[c] + s * low[c + rows]) +
              t * ((1. - s) * high[c] + s * high[c + rows]);
}


void Profile::mean(const std::array<double, 2> &lower,
                   const std::array<double, 2> &upper,
                   double *means) const
{
  const unsigned int nc = n_components();
  std::fill(means, means + nc, 0.);
  std::array<double, 2> a{}, b{};
  double size = 1.;
  for (unsigned int d = 0; d < n_directions(); ++d)
  {
    a[d] = std::max(lower[d], data_.domain_begin[d]);
    b[d] = std::min(upper[d], data_.domain_end[d]);
    if (!(a[d] < b[d]))
      return;
    size *= b[d] - a[d];
  }
  std::array<double, most_rows> sums{};
  const auto add = [&](const std::array<double, 2> &place, const double sign) {
    integral(place, 0, nc, sums.data());
    for (unsigned int c = 0; c < nc; ++c)
      means[c] += sign * sums[c] / size;
  };
  add(b, 1.);
  add({{a[0], b[1]}}, -1.);
  if (n_directions() == 2)
  {
    add({{b[0], a[1]}}, -1.);
    add(a, 1.);
  }
}


double Profile::variation(const std::array<double, 2> &lower,
                          const std::array<double, 2> &upper) const
{
  const unsigned int row = n_components();
  std::array<double, most_rows> sums{};
  const auto at = [&](const double x, const double z) {
    integral({{x, z}}, row, row + 1, sums.data());
    return sums[row];
  };
  if (n_directions() == 1)
    return at(upper[0], 0.) - at(lower[0], 0.);
  const double sum = at(upper[0], upper[1]) - at(lower[0], upper[1]) -
                     at(upper[0], lower[1]) + at(lower[0], lower[1]);
  // Variation across the window: mean variation per length times the longer
  // edge of the window.
  return sum / std::min(upper[0] - lower[0], upper[1] - lower[1]);
}


double Profile::map_value(const std::string &name,
                          const std::array<double, 2> &place,
                          const double beyond) const
{
  const auto &values = data_.maps.at(name);
  unsigned int cell = 0;
  for (unsigned int d = 0; d < n_directions(); ++d)
  {
    if (place[d] < begin(d) || place[d] > end(d))
      return beyond;
    cell += index(d, place[d]) * (d == 0 ? 1 : n_cells_[0]);
  }
  return values[cell];
}
} // namespace contrecoup::gas
