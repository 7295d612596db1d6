// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>

#include <string>

namespace contrecoup
{
/// Length unit of a file with a body, and the largest size by which a wrong
/// unit is found.
class FileUnit
{
public:
  /// Declares the entries Unit and Largest size in the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads them. @param section path of the subsection, for error messages
  void parse_parameters(dealii::ParameterHandler &prm,
                        const std::string &section);

  /// Length of a 1 in the file [m].
  double length() const
  {
    return length_;
  }

  /**
   * @param where begin of the error message
   * @param box of the body with its final scale [m]
   * @param is_person whether it must have the size of a person
   * @throws InputError for a size that suggests another unit
   */
  void require_size(const std::string &where,
                    const dealii::BoundingBox<3> &box,
                    bool is_person = false) const;

private:
  std::string section_;
  double length_ = 1.;
  double largest_size_ = 5.; ///< [m]
};
} // namespace contrecoup
