// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/table_profile.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  /// Values of one line; empty if a word is not a finite number.
  std::vector<double> read_numbers(const std::string &line)
  {
    std::vector<double> numbers;
    for (const std::string &word : split(line, ','))
    {
      std::size_t used = 0;
      double number = 0.;
      try
      {
        number = std::stod(word, &used);
      }
      catch (const std::exception &)
      {
        return {};
      }
      if (used != word.size() || !std::isfinite(number))
        return {};
      numbers.push_back(number);
    }
    return numbers;
  }
} // namespace


TableProfile::TableProfile(const std::string &file)
{
  std::istringstream stream(read_text("Reference/Table", file));
  std::string line;
  unsigned int line_number = 0;
  bool header_seen = false;
  while (std::getline(stream, line))
  {
    ++line_number;
    line = trim(line);
    if (line.empty() || line[0] == '#')
      continue;
    const std::vector<double> numbers = read_numbers(line);
    if (numbers.empty() && !header_seen && positions_.empty())
    {
      header_seen = true;
      continue;
    }
    if (numbers.size() < 4 || numbers.size() > 5 || !(numbers[1] > 0.) ||
        (!positions_.empty() && !(numbers[0] > positions_.back())))
      throw InputError(file + ", line " + std::to_string(line_number) +
                       ": needs 4 or 5 numbers: position (increasing), "
                       "density (above 0), velocity, pressure, products");
    GasState<1> state;
    state.density = numbers[1];
    state.velocity[0] = numbers[2];
    state.pressure = numbers[3];
    state.products = (numbers.size() == 5) ? numbers[4] : 0.;
    positions_.push_back(numbers[0]);
    states_.push_back(state);
  }
  if (positions_.size() < 2)
    throw InputError("Reference/Table = " + file +
                     ": needs at least 2 lines of numbers");
}


GasState<1> TableProfile::value(const double position) const
{
  if (position <= positions_.front())
    return states_.front();
  if (position >= positions_.back())
    return states_.back();

  const std::size_t above =
    std::upper_bound(positions_.begin(), positions_.end(), position) -
    positions_.begin();
  const double t = (position - positions_[above - 1]) /
                   (positions_[above] - positions_[above - 1]);
  const GasState<1> &left = states_[above - 1], &right = states_[above];
  return {(1. - t) * left.density + t * right.density,
          (1. - t) * left.velocity + t * right.velocity,
          (1. - t) * left.pressure + t * right.pressure,
          (1. - t) * left.products + t * right.products};
}


double TableProfile::begin() const
{
  return positions_.front();
}


double TableProfile::end() const
{
  return positions_.back();
}
} // namespace contrecoup::gas
