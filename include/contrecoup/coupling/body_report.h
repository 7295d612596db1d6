// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>
#include <contrecoup/geometry/hex_quality.h>
#include <contrecoup/geometry/phantom.h>

#include <string>
#include <vector>

namespace contrecoup
{
namespace coupling
{
  /// One line of the quality table: a part, a tissue, or the whole body.
  struct ReportRow
  {
    std::string kind; ///< part, tissue, body
    std::string name;
    std::string tissue; ///< empty for the body
    HexQuality quality;
    double mass = 0.;            ///< [kg]
    double time_step = 0.;       ///< [s]
    unsigned int components = 0; ///< pieces connected through faces
  };

  /// What the literature says of an organ, and what the mesh has.
  struct OrganCheck
  {
    OrganReference reference;
    double volume = 0.; ///< of the mesh [m^3]

    double difference() const
    {
      return volume / reference.volume - 1.;
    }
    bool holds() const
    {
      return std::abs(difference()) <= reference.tolerance;
    }
  };

  /// What a mesh amounts to.
  struct BodyReport
  {
    std::vector<ReportRow> rows; ///< parts, then tissues, then the body
    std::vector<OrganCheck> checks;
    dealii::Point<3> center_of_gravity; ///< [m]
    dealii::Point<3> lower_corner;      ///< of the box around the nodes [m]
    dealii::Point<3> upper_corner;
    double surface_area = 0.; ///< facets seen along the normals [m^2]

    const ReportRow &body() const
    {
      return rows.back();
    }
  };

  /**
   * Measures a mesh.
   *
   * The time step of an element is 2 / omega with omega^2 =
   * max(12 K, 8 G_0) / (rho L^2), L = characteristic_length(): exact for a
   * lone cube that is integrated at one point, an estimate for others.
   *
   * The area counts each facet by its component along the normal of the true
   * surface, so that stairs do not add to it.
   * @param tissue_set one of tissue_set_names()
   * @throws InputError for a tissue without properties
   */
  BodyReport make_report(const HexMesh &mesh,
                         const LabelGrid &grid,
                         const Shape &surface,
                         const std::vector<OrganReference> &references,
                         const std::string &tissue_set);

  /// The table for people, one string for each line.
  std::vector<std::string> to_lines(const BodyReport &report);

  /// quality.csv.
  std::string to_csv(const BodyReport &report);
} // namespace coupling
} // namespace contrecoup
