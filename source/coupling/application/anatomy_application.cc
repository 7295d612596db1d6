// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/new_tissues.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/base/system/remark_line.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/coupling/application/anatomy_application.h>
#include <contrecoup/coupling/application/anatomy_parameters.h>
#include <contrecoup/coupling/application/body_report.h>
#include <contrecoup/geometry/mesh/mesh_pieces.h>
#include <contrecoup/geometry/mesh/stray_cells.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/io/application/check_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/hex_mesh_files.h>
#include <contrecoup/io/output/folder_claim.h>
#include <contrecoup/io/output/pictures.h>
#include <contrecoup/io/run/plan_table.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <optional>

namespace contrecoup
{
namespace coupling
{
  namespace
  {
    /// Builds the mesh of one body and writes it to a folder.
    class AnatomyRun
    {
    public:
      /// @param warnings of the entries, for check() and execute()
      AnatomyRun(const AnatomyParameters &parameters,
                 const std::string &folder,
                 const std::vector<std::string> &warnings)
        : parameters_(parameters)
        , folder_(folder)
        , warnings_(warnings)
        , begin_(std::chrono::steady_clock::now())
        , body_(parameters.body.create())
        , surface_(body_->surface())
      {
        if (body_->own_mesh() &&
            (parameters.levels > 0 || parameters.smoothing.iterations > 0))
          throw InputError("Mesh/Coarsening levels and Mesh/Smoothing "
                           "iterations need a body that is meshed here; "
                           "Body/Kind = mesh has its own hexahedra");
        require_parts(parameters.own_tissues, *body_);
      }

      /// Logs what would be built and returns the cost estimate.
      CostEstimate check() const
      {
        const CostEstimate cost = estimate();
        show_line("anatomy would mesh the " + parameters_.body.kind() + " of " +
                  std::to_string(body_->parts().size()) + " part(s), " +
                  told_box() + ",");
        show_line(
          (body_->own_mesh()
             ? std::string("  in its own hexahedra")
             : "  in hexahedra of " + brief(parameters_.element_size) + " m") +
          " on 1 rank, with output in " + folder_ + ":");
        for (const std::string &line : io::cost_lines({{"anatomy", cost}}))
          show_line(line);
        for (const std::string &remark : body_->remarks())
          show_line(remark_line(remark));
        tell_changes();
        warn();
        show_line("The parameters are valid.");
        return cost;
      }

      /// Builds the mesh and writes it to the folder of @p claim.
      void execute(const std::string &parameter_text, io::FolderClaim &claim)
      {
        const BodyReport report = build();
        // From here on only the disk can fail: old results may be removed.
        SignalGuard::require_no_stop();
        claim.begin();
        start(parameter_text);
        show_line("meshed the " + parameters_.body.kind() + ", " + told_box() +
                  ", with " + std::to_string(mesh_.cells.size()) +
                  " hexahedra and " + std::to_string(mesh_.nodes.size()) +
                  " nodes in " + duration(meshed_));
        for (const std::string &remark : body_->remarks())
          show_line(remark_line(remark));
        tell_changes();
        for (const std::string &line : strays_)
          log_line(remark_line(line));
        if (!mesh_.hanging_nodes.empty())
          log_line("  " + std::to_string(mesh_.hanging_nodes.size()) +
                   " nodes hang between larger elements");
        if (smoothing_.n_moved > 0)
          log_line("  smoothed " + std::to_string(smoothing_.n_moved) +
                   " nodes of surfaces and interfaces by at most " +
                   brief(1e3 * smoothing_.largest_displacement, 3) + " mm; " +
                   std::to_string(smoothing_.n_held_back) +
                   " nodes were held back for the shape of elements");
        for (const std::string &line : to_lines(report))
          log_line(line);
        if (const std::string line = organ_warning(report.checks);
            !line.empty())
          log_line(line);
        warn_of_pieces(report);
        write(report);
        const bool is_drawn =
          !parameters_.draw ||
          io::draw("anatomy", folder_, "pictures", "pictures");
        claim.set_status("finished");
        if (!is_drawn)
          SignalGuard::require_no_stop();
      }

    private:
      /// Builds the mesh from a grid, or takes that of the body.
      BodyReport build()
      {
        std::optional<LabelGrid> grid;
        if (const auto own = body_->own_mesh())
          mesh_ = *own;
        else
        {
          grid = make_grid(surface_->bounding_box(), parameters_.element_size);
          body_->fill(*grid);
          strays_ = join_strays(body_->parts(), *grid);
          SignalGuard::require_no_stop();
          mesh_ = make_hex_mesh(*grid, body_->parts(), parameters_.levels);
        }
        require_elements(!mesh_.cells.empty());
        if (parameters_.smoothing.iterations > 0)
          smoothing_ = smooth(mesh_, parameters_.smoothing);
        meshed_ = seconds();
        return make_report(mesh_,
                           grid ? &*grid : nullptr,
                           *surface_,
                           parameters_.body.references(),
                           parameters_.tissue_set,
                           parameters_.own_tissues);
      }

      /// Tells each tissue whose density, and so its mass, is not the set's.
      void tell_changes() const
      {
        for (const Tissue tissue : parameters_.own_tissues.tissues())
          show_line("  changed: " + name_of(tissue) + " with " +
                    parameters_.own_tissues.changes_in_words(
                      tissue,
                      is_new(tissue) ? SolidMaterial()
                                     : find_solid_material(
                                         parameters_.tissue_set, tissue, {})));
      }

      /// Tells of a body in pieces, and of layers; see layer_pieces_line().
      void warn_of_pieces(const BodyReport &report) const
      {
        // Hexahedra of one's own bring the warning as a remark.
        if (const std::string line =
              pieces_warning("the body", report.body().components);
            !line.empty() && !body_->own_mesh())
          log_line(line);
        for (const BodyLayer &layer : parameters_.layers)
        {
          unsigned int n_pieces = 0;
          for (const ReportRow &row : report.rows)
            if (row.kind == "part" && row.name == layer.part)
              n_pieces = row.components;
          if (const std::string line = layer_pieces_line(
                layer, n_pieces, parameters_.element_size, "Mesh/Element size");
              !line.empty())
            log_line(remark_line(line));
        }
      }

      std::string path(const std::string &name) const
      {
        return folder_ + "/" + name;
      }

      double seconds() const
      {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                             begin_)
          .count();
      }

      void require_elements(const bool has_some) const
      {
        if (!has_some)
          throw InputError(
            "Mesh/Element size = " + brief(parameters_.element_size) +
            " m: no element has its centre in the body, " + told_box());
      }

      /// Size of the mesh: that of the body's own hexahedra, counted in the
      /// grid that would be meshed, or extrapolated from a coarser one if that
      /// grid is large.
      HexMeshSize estimate_size(const double n_cubes) const
      {
        if (const auto own = body_->own_mesh())
          return {double(own->cells.size()), double(own->boundary.size())};
        constexpr double most_cubes = 1e7;
        const double coarsening = std::max(1., std::cbrt(n_cubes / most_cubes));
        LabelGrid grid = make_grid(surface_->bounding_box(),
                                   coarsening * parameters_.element_size);
        body_->fill(grid);
        HexMeshSize size = count_hexahedra(grid, parameters_.levels);
        if (coarsening == 1.)
          return size;
        // There are as many largest cubes as the volume holds, and as many
        // others as the surfaces and interfaces need.
        const double area = coarsening * coarsening;
        const double largest = count_hexahedra(grid, 0).cells *
                               std::ldexp(1., -3 * int(parameters_.levels));
        size.cells = area * (size.cells + largest * (coarsening - 1.));
        size.facets *= area;
        return size;
      }

      /// Bytes on disk, as measured for the phantom with elements of 3.5 to 10
      /// mm: smoothed positions compress less. Pictures colour each part.
      double estimate_output(const HexMeshSize &size) const
      {
        const bool is_smooth = parameters_.smoothing.iterations > 0;
        double bytes = 2e4 + (is_smooth ? 51. : 20.) * size.cells;
        if (parameters_.write_surface)
          bytes += (is_smooth ? 143. : 124.) * size.facets;
        if (parameters_.levels > 0)
          bytes += 12. * size.cells;
        if (parameters_.write_gmsh)
          bytes += 116. * size.cells;
        if (parameters_.distance_spacing > 0.)
        {
          auto box = surface_->bounding_box();
          box.extend(4. * parameters_.distance_spacing);
          bytes +=
            4.7 * box.volume() / std::pow(parameters_.distance_spacing, 3);
        }
        if (parameters_.draw)
          bytes += 8e4 + 9e3 * body_->parts().size();
        return bytes;
      }

      CostEstimate estimate() const
      {
        const double n_cubes =
          body_->own_mesh()
            ? 0.
            : make_grid(surface_->bounding_box(), parameters_.element_size)
                .labels.size();
        const HexMeshSize size = estimate_size(n_cubes);
        require_elements(size.cells > 0.);
        CostEstimate cost;
        cost.cells = size.cells;
        // Taken so far, then for writing, labels and node numbers, and cells.
        const double per_cell = (parameters_.levels > 0 ? 265. : 135.) +
                                (parameters_.smoothing.iterations ? 30. : 0.);
        cost.memory = peak_memory(MPI_COMM_SELF) + 3e6 + 5. * n_cubes +
                      per_cell * cost.cells;
        cost.seconds = 1. + (parameters_.draw ? 4. : 0.) + 3e-6 * cost.cells;
        cost.output = estimate_output(size);
        return cost;
      }

      /// Extents of the body as text.
      std::string told_box() const
      {
        const auto box = own_box(*surface_);
        return brief(box.side_length(0)) + " x " + brief(box.side_length(1)) +
               " x " + brief(box.side_length(2)) + " m";
      }

      void start(const std::string &parameter_text) const
      {
        write_text("parameters.prm", parameter_text);
        Log::instance().open(path("log.txt"), false);
        show_line("anatomy " + version() + " (" + git_revision() + ")");
        warn();
      }

      void warn() const
      {
        for (const std::string &line : warnings_)
          show_line(line);
      }

      void write_text(const std::string &name, const std::string &text) const
      {
        io::write_file(path(name), [&](std::ostream &out) { out << text; });
      }

      void write(const BodyReport &report) const
      {
        write_text("quality.csv", to_csv(report));
        std::string parts = "part,name,tissue,tissue name\n";
        for (std::size_t i = 0; i < mesh_.parts.size(); ++i)
          parts += std::to_string(i) + "," + mesh_.parts[i].name + "," +
                   std::to_string(int(mesh_.parts[i].tissue)) + "," +
                   name_of(mesh_.parts[i].tissue) + "\n";
        write_text("parts.csv", parts);
        io::write_vtu(mesh_, path("mesh.vtu"));
        if (parameters_.write_surface)
        {
          io::write_surface_vtu(mesh_, *surface_, path("surface.vtu"));
          io::write_surface_stl(mesh_, path("surface.stl"));
        }
        if (!mesh_.hanging_nodes.empty())
          io::write_hanging_nodes(mesh_, path("hanging_nodes.csv"));
        if (parameters_.write_gmsh)
          io::write_msh(mesh_, path("mesh.msh"));
        if (parameters_.distance_spacing > 0.)
          io::write_distance(*surface_,
                             parameters_.distance_spacing,
                             4. * parameters_.distance_spacing,
                             path("distance.vti"));
        write_summary(report);
        show_line("results in " + folder_ + " after " + duration(seconds()));
        Log::instance().check();
      }

      /// Volumes of organs, and those that they should have [m^3].
      static io::Json organs_of(const BodyReport &report)
      {
        io::Json organs = io::Json::array();
        for (const OrganCheck &check : report.checks)
          organs.push_back({{"name", check.reference.name},
                            {"volume", check.volume},
                            {"reference_volume", check.reference.volume},
                            {"source", check.reference.source}});
        return organs;
      }

      void write_summary(const BodyReport &report) const
      {
        const ReportRow &body = report.body();
        io::Json errors = io::Json::object();
        unsigned int n_held = 0;
        for (const OrganCheck &check : report.checks)
        {
          std::string name = check.reference.name;
          std::replace(name.begin(), name.end(), ' ', '_');
          errors[name + "_volume"] = check.difference();
          n_held += check.holds() ? 1 : 0;
        }
        if (parameters_.body.kind() == "phantom" && !report.checks.empty())
          errors["mass"] = body.mass / parameters_.body.reference_mass() - 1.;
        io::Json summary = {
          {"application", "anatomy"},
          {"format", io::formats::summary.number},
          {"version", version()},
          {"git_revision", git_revision()},
          {"status", "finished"},
          {"wall_seconds", seconds()},
          {"cells", mesh_.cells.size()},
          {"nodes", mesh_.nodes.size()},
          {"hanging_nodes", mesh_.hanging_nodes.size()},
          {"facets", mesh_.boundary.size()},
          {"parts", body_->parts().size()},
          {"connected_components", body.components},
          {"volume", body.quality.volume},
          {"mass", body.mass},
          {"surface_area", report.surface_area},
          {"surface_projections", report.surface_projections},
          {"center_of_gravity",
           {report.center_of_gravity[0],
            report.center_of_gravity[1],
            report.center_of_gravity[2]}},
          {"height", report.upper_corner[2] - report.lower_corner[2]},
          {"smallest_scaled_jacobian", body.quality.smallest_scaled_jacobian},
          {"mean_scaled_jacobian", body.quality.mean_scaled_jacobian},
          {"shortest_edge", body.quality.shortest_edge},
          {"time_step", body.time_step},
          {"errors", errors},
          {"references_held", n_held},
          {"warnings", Log::instance().warnings()},
          {"performance",
           {{"wall_seconds", seconds()},
            {"peak_memory_bytes", peak_memory(MPI_COMM_SELF)}}}};
        summary["organs"] = organs_of(report);
        const auto fit = organ_fit_figures(*body_);
        if (!fit.empty())
          summary["organ_fit"] = fit;
        write_text("summary.json", summary.dump(2) + "\n");
      }

      AnatomyParameters parameters_;
      std::string folder_;
      std::vector<std::string> warnings_;
      std::chrono::steady_clock::time_point begin_;
      BodyPointer body_;
      ShapePointer surface_;
      HexMesh mesh_;
      std::vector<std::string> strays_; ///< what became of stray cubes
      SmoothingReport smoothing_;
      double meshed_ = 0.; ///< when the mesh was ready [s]
    };

    std::vector<std::string> find_warnings(const io::CommandLine &command,
                                           const dealii::ParameterHandler &prm,
                                           const AnatomyParameters &parameters)
    {
      std::vector<std::string> lines =
        find_unused(prm, io::assignments_of(command, prm));
      for (const std::string &line :
           thin_layer_lines(parameters.layers,
                            parameters.element_size,
                            AnatomyParameters::usual_element_size,
                            "Mesh/Element size"))
        lines.push_back(remark_line(line));
      // A run looks at the mesh; see warn_of_pieces().
      if (command.check)
        for (const std::string &line : uncertain_layer_lines(
               parameters.layers, parameters.element_size, "Mesh/Element size"))
          lines.push_back(line);
      return lines;
    }

    void
    execute(const io::CommandLine &command,
            dealii::ParameterHandler &prm,
            const std::function<void(const CostEstimate &)> &on_cost_estimate)
    {
      if (command.resume)
        throw InputError("--resume: anatomy has no steps to go on with; run "
                         "it again");
      AnatomyParameters parameters;
      parameters.parse_parameters(prm);
      const std::vector<std::string> warnings =
        on_cost_estimate ? std::vector<std::string>()
                         : find_warnings(command, prm, parameters);
      const std::string &folder = command.output_folder;
      if (command.check)
      {
        const CostEstimate cost =
          AnatomyRun(parameters, folder, warnings).check();
        if (on_cost_estimate)
          on_cost_estimate(cost);
        else
        {
          std::vector<std::string> outputs = io::file_outputs(anatomy_files());
          outputs.emplace_back("*");
          io::write_check_file({"anatomy", cost, outputs});
        }
        return;
      }
      io::FolderClaim claim(folder,
                            "anatomy",
                            anatomy_files(),
                            io::make_run_input(parameter_values(prm)));
      if (!claim.may_proceed(command, {}))
        return;
      AnatomyRun(parameters, folder, warnings)
        .execute("# anatomy " + version() + " (" + git_revision() +
                   "): every entry as used\n\n" + parameter_text(prm, false),
                 claim);
    }
  } // namespace

  io::FileNames anatomy_files()
  {
    return io::FileNames{{"parameters.prm",
                          "mesh.vtu",
                          "mesh.msh",
                          "hanging_nodes.csv",
                          "surface.vtu",
                          "surface.stl",
                          "distance.vti",
                          "quality.csv",
                          "parts.csv",
                          "summary.json"},
                         {"log.txt"}} +
           io::picture_files({"body.png", "cuts.png", "quality.png"});
  }

  io::ToolDescription anatomy_application(
    const std::function<void(const CostEstimate &)> &on_cost_estimate)
  {
    return {"anatomy",
            "Makes a body for blasts: hexahedra by tissue, their surface and "
            "their quality, from a human phantom, a simple shape, a surface or "
            "medical images.",
            AnatomyParameters::declare_parameters,
            [on_cost_estimate](const io::CommandLine &command,
                               dealii::ParameterHandler &prm) {
              execute(command, prm, on_cost_estimate);
            }};
  }
} // namespace coupling
} // namespace contrecoup
