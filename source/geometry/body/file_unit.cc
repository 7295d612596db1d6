// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/file_unit.h>

#include <algorithm>

namespace contrecoup
{
namespace
{
  const std::vector<std::pair<std::string, double>> &units()
  {
    static const std::vector<std::pair<std::string, double>> table{
      {"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"inch", 0.0254}};
    return table;
  }
} // namespace


void FileUnit::declare_parameters(dealii::ParameterHandler &prm)
{
  std::vector<std::string> names;
  for (const auto &[name, length] : units())
    names.push_back(name);
  declare_selection(prm, "Unit", "m", names, "Length of a 1 in the file.");
  declare_double(prm,
                 "Largest size",
                 "5",
                 1e-6,
                 1e6,
                 "m",
                 "Longest edge of the bounding box, including the scale of "
                 "Body, above which the body is refused because Unit is "
                 "probably wrong.");
}

void FileUnit::parse_parameters(dealii::ParameterHandler &prm,
                                const std::string &section)
{
  section_ = section;
  for (const auto &[name, length] : units())
    if (name == prm.get("Unit"))
      length_ = length;
  largest_size_ = read_double(prm, "Largest size");
}

void FileUnit::require_size(const std::string &where,
                            const dealii::BoundingBox<3> &box,
                            const bool is_person) const
{
  // Limits for a person with organs, and for other bodies.
  constexpr double smallest_person = 0.3, largest_person = 2.6;
  double size = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    size = std::max(size, box.side_length(d));
  const double smallest = is_person ? smallest_person : 0.;
  const double largest =
    is_person ? std::min(largest_size_, largest_person) : largest_size_;
  if (size >= smallest && size <= largest)
    return;
  // A head may be scanned alone.
  constexpr double smallest_likely = 0.1;
  std::vector<std::string> better;
  for (const auto &[name, length] : units())
  {
    const double other = size * length / length_;
    if (length != length_ && other >= std::max(smallest, smallest_likely) &&
        other <= std::min(largest, largest_person))
      better.push_back(section_ + "/Unit = " + name + " would make it " +
                       brief(other) + " m");
  }
  throw InputError(
    where + "its box is " + brief(box.side_length(0)) + " x " +
    brief(box.side_length(1)) + " x " + brief(box.side_length(2)) + " m, " +
    (is_person ? "that of a person is " + brief(smallest) + " to " +
                   brief(largest) + " m long"
               : section_ + "/Largest size allows " + brief(largest) + " m") +
    (better.empty() ? "; " + section_ + "/Unit or Body/Scale changes it"
                    : "; " + join(better, ", ")));
}
} // namespace contrecoup
