// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/organ_check.h>
#include <contrecoup/geometry/mesh/hex_quality.h>
#include <contrecoup/materials/own_tissues.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
namespace coupling
{
  /// Row of the quality table: a part, a tissue, or the whole body.
  struct ReportRow
  {
    std::string kind; ///< part, tissue, body
    std::string name;
    std::string tissue; ///< empty for the body
    HexQuality quality;
    double mass = 0.;            ///< [kg]
    double time_step = 0.;       ///< [s]
    unsigned int components = 0; ///< face-connected components
  };

  /// Quality report of a mesh.
  struct BodyReport
  {
    std::vector<ReportRow> rows; ///< parts, then tissues, then the body
    std::vector<OrganCheck> checks;
    dealii::Point<3> center_of_gravity; ///< [m]
    dealii::Point<3> lower_corner;      ///< bounding box of the nodes [m]
    dealii::Point<3> upper_corner;
    /// Projected area of the facets, see make_report() [m^2]
    double surface_area = 0.;
    /// Of the facets on the three planes of coordinates, summed [m^2]
    double surface_projections = 0.;

    const ReportRow &body() const
    {
      return rows.back();
    }
  };

  /**
   * Computes the quality report of a mesh.
   *
   * The stable time step of an element is 2 / omega with omega^2 = max(12 K, 8
   * G_0) / (rho L^2), L = characteristic_length(): exact for a single cube
   * with one integration point, an estimate for others.
   *
   * The surface area is the sum of the facet areas projected onto the normal
   * of the true surface, so that a staircase surface is not overestimated.
   * @param grid from which the mesh was made; null for a mesh of one's own
   * @param tissue_set one of tissue_set_names()
   * @param own_tissues new ones and changes of those of the set
   * @throws InputError for a tissue without properties
   */
  BodyReport make_report(const HexMesh &mesh,
                         const LabelGrid *grid,
                         const Shape &surface,
                         const std::vector<OrganReference> &references,
                         const std::string &tissue_set,
                         const OwnTissues &own_tissues);

  /// Figures of the fit of inserted organs by their names in summary.json, with
  /// the limits that they should meet; empty without such organs.
  std::map<std::string, double> organ_fit_figures(const Body &body);

  /// Report as text, one string per line.
  std::vector<std::string> to_lines(const BodyReport &report);

  /// Content of quality.csv.
  std::string to_csv(const BodyReport &report);
} // namespace coupling
} // namespace contrecoup
