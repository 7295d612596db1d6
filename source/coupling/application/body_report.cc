// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/body_report.h>
#include <contrecoup/geometry/mesh/hex_components.h>

#include <iomanip>
#include <sstream>

namespace contrecoup
{
namespace coupling
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    /// Stable time step of an element of this length, see make_report() [s].
    double stable_step(const SolidMaterial &tissue, const double length)
    {
      const double stiffness =
        std::max(12. * tissue.bulk_modulus, 8. * tissue.instantaneous_shear);
      return 2. * length * std::sqrt(tissue.density / stiffness);
    }

    ReportRow part_row(const BodyPart &part,
                       const HexQuality &quality,
                       const unsigned int components,
                       const SolidMaterial &tissue)
    {
      ReportRow row;
      row.kind = "part";
      row.name = part.name;
      row.tissue = name_of(part.tissue);
      row.quality = quality;
      row.mass = tissue.density * quality.volume;
      row.time_step = stable_step(tissue, quality.shortest_length);
      row.components = components;
      return row;
    }

    void add(ReportRow &sum, const ReportRow &row)
    {
      sum.time_step = sum.quality.n_cells == 0
                        ? row.time_step
                        : std::min(sum.time_step, row.time_step);
      sum.quality = sum.quality + row.quality;
      sum.mass += row.mass;
    }

    /// Number of face-connected components of the parts, or of the tissues.
    std::array<unsigned int, 256> components_of(const HexMesh &mesh,
                                                const LabelGrid *grid,
                                                const bool by_tissue)
    {
      const auto relabel = [&](std::vector<unsigned char> labels) {
        for (unsigned char &label : labels)
          if (by_tissue && label != LabelGrid::outside)
            label = static_cast<unsigned char>(mesh.parts[label].tissue);
        return labels;
      };
      if (grid == nullptr)
        return count_components(mesh, relabel(mesh.part));
      LabelGrid labelled = *grid;
      labelled.labels = relabel(grid->labels);
      return count_components(labelled);
    }

    void add_rows(const HexMesh &mesh,
                  const LabelGrid *grid,
                  const std::string &tissue_set,
                  const OwnTissues &own_tissues,
                  BodyReport &report)
    {
      const auto part_components = components_of(mesh, grid, false);
      const auto tissue_components = components_of(mesh, grid, true);
      const std::vector<HexQuality> qualities = measure_quality(mesh);
      std::vector<ReportRow> tissues(tissue_names().size());
      ReportRow body;
      for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        if (qualities[i].n_cells > 0)
        {
          report.rows.push_back(
            part_row(mesh.parts[i],
                     qualities[i],
                     part_components[i],
                     find_solid_material(
                       tissue_set, mesh.parts[i].tissue, own_tissues)));
          const ReportRow &row = report.rows.back();
          add(tissues[static_cast<std::size_t>(mesh.parts[i].tissue)], row);
          add(body, row);
          report.center_of_gravity += Tensor<1, 3>(row.quality.first_moment) *
                                      (row.mass / row.quality.volume);
        }
      for (std::size_t i = 0; i < tissues.size(); ++i)
        if (tissues[i].quality.n_cells > 0)
        {
          tissues[i].kind = "tissue";
          tissues[i].name = tissues[i].tissue = tissue_names()[i];
          tissues[i].components = tissue_components[i];
          report.rows.push_back(tissues[i]);
        }
      body.kind = body.name = "body";
      body.components = part_components[LabelGrid::outside];
      report.rows.push_back(body);
      report.center_of_gravity /= body.mass;
    }

    std::string fixed(const double value, const int width, const int digits)
    {
      std::ostringstream out;
      out << std::fixed << std::setprecision(digits) << std::setw(width)
          << value;
      return out.str();
    }

    std::string padded(const std::string &text, const int width)
    {
      std::ostringstream out;
      out << std::left << std::setw(width) << text;
      return out.str();
    }
  } // namespace


  BodyReport make_report(const HexMesh &mesh,
                         const LabelGrid *grid,
                         const Shape &surface,
                         const std::vector<OrganReference> &references,
                         const std::string &tissue_set,
                         const OwnTissues &own_tissues)
  {
    BodyReport report;
    add_rows(mesh, grid, tissue_set, own_tissues, report);
    const dealii::BoundingBox<3> box(mesh.nodes);
    report.lower_corner = box.get_boundary_points().first;
    report.upper_corner = box.get_boundary_points().second;
    for (const HexMesh::Facet &facet : mesh.boundary)
    {
      const auto area = mesh.area_vector(facet);
      report.surface_area += area * surface.normal(mesh.center(facet));
      for (unsigned int d = 0; d < 3; ++d)
        report.surface_projections += std::abs(area[d]);
    }
    report.checks = check_organs(mesh, references);
    return report;
  }


  std::map<std::string, double> organ_fit_figures(const Body &body)
  {
    if (!body.organ_fit())
      return {};
    const OrganFit &fit = *body.organ_fit();
    return {{"inside", fit.inside},
            {"inside_at_least", OrganFit::least_inside},
            {"brain_cover", fit.brain_cover},
            {"lung_cover", fit.lung_cover},
            {"cover_at_least", OrganFit::least_cover},
            {"checks_held", fit.holds() ? 1. : 0.}};
  }

  std::vector<std::string> to_lines(const BodyReport &report)
  {
    std::vector<std::string> lines{
      "                           elements  volume    mass  scaled Jacobian  "
      "edge    step  pieces",
      "                                      litre      kg   least   mean    "
      "  mm      µs"};
    std::string kind;
    for (const ReportRow &row : report.rows)
    {
      if (row.kind != kind)
        lines.push_back(row.kind == "body" ? "whole body" : row.kind + "s");
      kind = row.kind;
      std::ostringstream count;
      count << std::setw(9) << row.quality.n_cells;
      lines.push_back(
        "  " + padded(row.name, 23) + count.str() +
        fixed(1e3 * row.quality.volume, 9, 3) + fixed(row.mass, 8, 3) +
        fixed(row.quality.smallest_scaled_jacobian, 8, 3) +
        fixed(row.quality.mean_scaled_jacobian, 8, 3) +
        fixed(1e3 * row.quality.shortest_edge, 8, 2) +
        fixed(1e6 * row.time_step, 8, 3) + fixed(row.components, 8, 0));
    }
    const Point<3> extent(report.upper_corner - report.lower_corner);
    lines.push_back("extents " + brief(extent[0]) + " x " + brief(extent[1]) +
                    " x " + brief(extent[2]) + " m, surface " +
                    brief(report.surface_area) + " m^2, centre of gravity at " +
                    coordinates(report.center_of_gravity) + " m");
    for (const OrganCheck &check : report.checks)
      lines.push_back(
        padded(check.reference.name, 12) + fixed(1e3 * check.volume, 8, 3) +
        " litre, " + fixed(1e3 * check.reference.volume, 7, 3) + " in " +
        check.reference.source + ": " + fixed(100. * check.difference(), 5, 1) +
        " %" +
        (check.holds()
           ? ""
           : ", more than the " + brief(100. * check.reference.tolerance, 2) +
               " % aimed at"));
    return lines;
  }


  std::string to_csv(const BodyReport &report)
  {
    std::string text =
      "kind,name,tissue,elements,volume [m^3],mass [kg],smallest scaled "
      "Jacobian,mean scaled Jacobian,shortest edge [m],longest edge [m],time "
      "step [s],connected components\n";
    for (const ReportRow &row : report.rows)
      text += join({row.kind,
                    row.name,
                    row.tissue,
                    std::to_string(row.quality.n_cells),
                    exact(row.quality.volume),
                    exact(row.mass),
                    exact(row.quality.smallest_scaled_jacobian),
                    exact(row.quality.mean_scaled_jacobian),
                    exact(row.quality.shortest_edge),
                    exact(row.quality.longest_edge),
                    exact(row.time_step),
                    std::to_string(row.components)},
                   ",") +
              "\n";
    return text;
  }
} // namespace coupling
} // namespace contrecoup
