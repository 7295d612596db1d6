// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/solid/boundary/analytic_blast.h>
#include <contrecoup/solid/boundary/recorded_loads.h>
#include <contrecoup/solid/boundary/surface_loads.h>

#include <limits>
#include <set>

namespace contrecoup::solid
{
namespace
{
  using dealii::Point;
  using dealii::Tensor;

  /// Integral over a bilinear facet of each node's shape function times the
  /// normal [m^2].
  std::array<Tensor<1, 3>, 4>
  nodal_areas(const std::array<Point<3>, 4> &corners)
  {
    constexpr double signs[4][2] = {{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}};
    const double gauss = std::sqrt(1. / 3.);
    std::array<Tensor<1, 3>, 4> areas;
    for (const auto &point : signs)
    {
      const double s = gauss * point[0], t = gauss * point[1];
      Tensor<1, 3> along_s, along_t;
      for (unsigned int v = 0; v < 4; ++v)
      {
        along_s += 0.25 * signs[v][0] * (1. + signs[v][1] * t) * corners[v];
        along_t += 0.25 * signs[v][1] * (1. + signs[v][0] * s) * corners[v];
      }
      const Tensor<1, 3> normal = cross_product_3d(along_s, along_t);
      for (unsigned int v = 0; v < 4; ++v)
        areas[v] +=
          0.25 * (1. + signs[v][0] * s) * (1. + signs[v][1] * t) * normal;
    }
    return areas;
  }

  std::array<Point<3>, 4> corners_of(const SolidMesh &mesh,
                                     const HexMesh::Facet &facet)
  {
    std::array<Point<3>, 4> corners;
    for (unsigned int v = 0; v < 4; ++v)
      corners[v] = mesh.nodes[facet.nodes[v]];
    return corners;
  }

  Point<3> middle_of(const std::array<Point<3>, 4> &corners)
  {
    return Point<3>((corners[0] + corners[1] + corners[2] + corners[3]) / 4.);
  }
} // namespace


void SurfaceLoads::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Loads");
  {
    const Section recorded(prm, "Recorded");
    RecordedLoads::declare_parameters(prm);
  }
  const Section load(prm, "Load *");
  std::vector<std::string> kinds = AnalyticBlast::kinds;
  kinds.insert(kinds.begin(), "expression");
  declare_selection(prm,
                    "Kind",
                    "expression",
                    kinds,
                    "Pressure from the expression, from a pulse of one "
                    "shape spreading from a charge, or from TNT tables.");
  declare_string(prm,
                 "Where",
                 "1",
                 selecting("muParser expression of x, y, z that is true at the "
                           "centres of the loaded boundary facets."));
  declare_string(
    prm,
    "Pressure",
    "0",
    used_with("Kind = expression",
              "[Pa] Overpressure as a muParser expression of x, y, z, t "
              "and pi; positive values push inwards."));
  AnalyticBlast::declare_parameters(prm);
}


void SurfaceLoads::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Loads");
    const Section recorded(prm, "Recorded");
    if (const auto history = RecordedLoads::parse_parameters(prm))
      loads_.push_back({"recorded",
                        Expression("Loads/Recorded", "1"),
                        Expression("Loads/Recorded", "0"),
                        history});
  }
  for (const std::string &name : item_names(prm, "Loads/Load"))
  {
    const Section section(prm, "Loads");
    const Section load(prm, "Load " + name);
    const std::string path = "Loads/Load " + name;
    const std::string kind = prm.get("Kind");
    loads_.push_back({name,
                      Expression(path + "/Where", prm.get("Where")),
                      Expression(path + "/Pressure", prm.get("Pressure")),
                      kind == "expression"
                        ? nullptr
                        : AnalyticBlast::parse_parameters(prm, kind, path)});
    // Refuse a value that is not finite before the mesh is built.
    const Load &parsed = loads_.back();
    if (!parsed.history && !parsed.pressure.depends_on_place())
      parsed.pressure.value(Point<3>());
  }
}


void SurfaceLoads::reinit(const SolidMesh &mesh, const MPI_Comm communicator)
{
  facets_.clear();
  nodes_.clear();
  entry_of_node_.assign(mesh.nodes.size(), no_index);
  std::vector<std::array<Point<3>, 4>> surface;
  for (const auto &facet : mesh.boundary)
    surface.push_back(corners_of(mesh, facet));
  for (unsigned int load = 0; load < loads_.size(); ++load)
  {
    const std::size_t first = facets_.size();
    add_facets(mesh, load);
    if (!loads_[load].history)
      continue;
    std::vector<Point<3>> middles;
    std::vector<Tensor<1, 3>> areas;
    for (std::size_t i = first; i < facets_.size(); ++i)
    {
      middles.push_back(facets_[i].middle);
      Tensor<1, 3> area;
      for (const Tensor<1, 3> &one : facets_[i].area)
        area += one;
      areas.push_back(area);
    }
    loads_[load].history->set_surface(surface, communicator);
    loads_[load].history->reinit(middles, areas, communicator);
  }
  forces_.assign(nodes_.size(), Tensor<1, 3>());
}


void SurfaceLoads::add_selections(const SolidMesh &mesh,
                                  Selections &selections) const
{
  for (const Load &load : loads_)
  {
    std::uint64_t count = 0;
    for (const HexMesh::Facet &facet : mesh.boundary)
      if (load.where.value(middle_of(corners_of(mesh, facet))) != 0.)
        ++count;
    selections.add("Loads/Load " + load.name + "/Where",
                   load.where.text(),
                   "facet of the body's surface",
                   count);
  }
}


void SurfaceLoads::warn_of_times(const double end_time) const
{
  for (const Load &load : loads_)
    if (load.history)
    {
      const std::string warning = load.history->warning(end_time);
      if (!warning.empty())
        log_line("WARNING: " + warning);
    }
}


void SurfaceLoads::add_facets(const SolidMesh &mesh, const unsigned int load)
{
  std::size_t number = 0;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const auto corners = corners_of(mesh, mesh.boundary[i]);
    const Point<3> middle = middle_of(corners);
    if (loads_[load].where.value(middle) == 0.)
      continue;
    Facet facet{i, number++, load, middle, {}, nodal_areas(corners), 0.};
    for (unsigned int v = 0; v < 4; ++v)
    {
      std::uint32_t &entry = entry_of_node_[mesh.boundary[i].nodes[v]];
      if (entry == no_index)
      {
        entry = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(mesh.boundary[i].nodes[v]);
      }
      facet.entry[v] = entry;
    }
    facets_.push_back(facet);
  }
}


void SurfaceLoads::set_time(const double time)
{
  for (Tensor<1, 3> &force : forces_)
    force = Tensor<1, 3>();
  std::vector<double> everywhere;
  for (const Load &load : loads_)
  {
    if (load.history)
      load.history->set_time(time);
    everywhere.push_back(load.history || load.pressure.depends_on_place()
                           ? 0.
                           : load.pressure.value(Point<3>(), time));
  }
  for (Facet &facet : facets_)
  {
    const Load &load = loads_[facet.load];
    const double pressure = load.history ? load.history->pressure(facet.number)
                            : load.pressure.depends_on_place()
                              ? load.pressure.value(facet.middle, time)
                              : everywhere[facet.load];
    facet.pressure =
      load.history ? pressure / load.history->correction() : pressure;
    for (unsigned int v = 0; v < 4; ++v)
      forces_[facet.entry[v]] -= pressure * facet.area[v];
  }
}


template <typename Real>
void SurfaceLoads::add_forces(NodeFields<Real> &nodes) const
{
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      nodes.force_of(nodes_[i])[d] += static_cast<Real>(forces_[i][d]);
}


template <typename Real>
double SurfaceLoads::power(const NodeFields<Real> &nodes) const
{
  double sum = 0.;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      sum += forces_[i][d] * double(nodes.velocity_of(nodes_[i])[d]);
  return sum;
}


std::uint64_t SurfaceLoads::n_loaded_facets(const MPI_Comm communicator) const
{
  return dealii::Utilities::MPI::sum(std::uint64_t(facets_.size()),
                                     communicator);
}


std::vector<NamedValue> SurfaceLoads::check_values() const
{
  std::vector<NamedValue> values;
  for (const Load &load : loads_)
    if (load.history)
      for (const NamedValue &value : load.history->check_values())
        values.push_back(value);
  return values;
}


double SurfaceLoads::pressure_near(const Point<3> &point,
                                   const MPI_Comm communicator) const
{
  double nearest = std::numeric_limits<double>::max();
  for (const Facet &facet : facets_)
    nearest = std::min(nearest, facet.middle.distance(point));
  nearest = dealii::Utilities::MPI::min(nearest, communicator);
  // Average over equally near facets, as next to a symmetry plane; add several
  // loads on one facet.
  std::vector<double> sums(2, 0.);
  std::set<std::size_t> numbers;
  for (const Facet &facet : facets_)
    if (facet.middle.distance(point) <= nearest * (1. + 1e-6))
    {
      sums[0] += facet.pressure;
      numbers.insert(facet.boundary);
    }
  sums[1] = static_cast<double>(numbers.size());
  dealii::Utilities::MPI::sum(sums, communicator, sums);
  return sums[1] > 0. ? sums[0] / sums[1] : 0.;
}


Tensor<1, 3> SurfaceLoads::total() const
{
  Tensor<1, 3> sum;
  for (const Tensor<1, 3> &force : forces_)
    sum += force;
  return sum;
}


template void SurfaceLoads::add_forces(NodeFields<double> &) const;
template void SurfaceLoads::add_forces(NodeFields<float> &) const;
template double SurfaceLoads::power(const NodeFields<double> &) const;
template double SurfaceLoads::power(const NodeFields<float> &) const;
} // namespace contrecoup::solid
