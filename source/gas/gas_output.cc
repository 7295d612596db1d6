// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/gas_measures.h>
#include <contrecoup/gas/gas_output.h>
#include <contrecoup/gas/point_sampler.h>
#include <contrecoup/io/field_output.h>
#include <contrecoup/io/numpy.h>

#include <deal.II/base/geometry_info.h>

#include <iomanip>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  const std::string axis_names = "xyz";

  /// One rank writes 1-D meshes, which all ranks hold.
  template <int dim>
  bool is_writer()
  {
    return dim > 1 ||
           dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  /// For each of the equidistant points of a leaf, m a side, which points of
  /// the scheme it takes and with what weights.
  template <int dim>
  std::vector<std::vector<std::pair<unsigned int, double>>>
  output_stencils(const LeafPoints<dim> &points, const unsigned int m)
  {
    std::vector<std::vector<double>> line;
    for (unsigned int i = 0; i < m; ++i)
      line.push_back(points.interpolation(double(i) / (m - 1)));
    const unsigned int n_points = dealii::Utilities::pow(points.n(), dim);
    std::vector<std::vector<std::pair<unsigned int, double>>> stencils(
      dealii::Utilities::pow(m, dim));
    for (unsigned int o = 0; o < stencils.size(); ++o)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const auto index = points.indices(q);
        double weight = 1.;
        unsigned int rest = o;
        for (unsigned int d = 0; d < dim; ++d)
        {
          weight *= line[rest % m][index[d]];
          rest /= m;
        }
        if (weight != 0.)
          stencils[o].emplace_back(q, weight);
      }
    return stencils;
  }
} // namespace


template <int dim>
void GasOutput<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Pictures");
  declare_string(prm,
                 "Planes",
                 "",
                 "Planes \"y = 0, z = 0.5\" [m] on which pressure and "
                 "density are sampled for pictures at every field output; "
                 "in 2-D \"all\" takes the whole domain.");
  declare_integer(prm,
                  "Resolution",
                  "256",
                  2,
                  4096,
                  "Samples along the longer side of a picture.");
}


template <int dim>
void GasOutput<dim>::parse_parameters(ParameterHandler &prm,
                                      const CoarseMesh<dim> &mesh)
{
  const Section section(prm, "Pictures");
  resolution_ = read_unsigned(prm, "Resolution");
  planes_.clear();
  const std::string text = prm.get("Planes");
  for (const auto &item : dealii::Utilities::split_string_list(text))
  {
    const std::string where = "Pictures/Planes = \"" + text + "\": ";
    if (dim == 1 || !mesh.is_axis_aligned())
      throw InputError(where + "only boxes in 2-D and 3-D have planes");
    if (dim == 2)
    {
      if (item != "all")
        throw InputError(where + "write \"all\" in 2-D");
      planes_.push_back({2, 0.});
      continue;
    }
    const auto words = dealii::Utilities::split_string_list(item, '=');
    const auto axis =
      words.size() == 2 ? axis_names.find(words[0]) : std::string::npos;
    double position = 0.;
    try
    {
      position = dealii::Utilities::string_to_double(words.back());
    }
    catch (const std::exception &)
    {
      throw InputError(where + "write \"y = 0\"");
    }
    if (axis == std::string::npos || words[0].size() != 1 ||
        position < mesh.lower_corner()[axis] ||
        position > mesh.upper_corner()[axis])
      throw InputError(where + "write \"y = 0\" with x, y or z and a "
                               "place within the domain");
    planes_.push_back({static_cast<unsigned int>(axis), position});
  }
}


template <int dim>
std::string GasOutput<dim>::write(const std::string &folder,
                                  const unsigned int index,
                                  const double time,
                                  const LeafMesh<dim> &mesh,
                                  const LeafPoints<dim> &points,
                                  const GasField &field,
                                  const GasMaterial &material) const
{
  for (const Plane &plane : planes_)
    write_plane(plane, folder, index, time, mesh, points, field, material);
  return write_leaves(folder, index, mesh, points, field, material);
}


template <int dim>
std::string GasOutput<dim>::write_leaves(const std::string &folder,
                                         const unsigned int index,
                                         const LeafMesh<dim> &mesh,
                                         const LeafPoints<dim> &points,
                                         const GasField &field,
                                         const GasMaterial &material) const
{
  std::vector<io::FieldName> names = {{"density", "kg/m^3"},
                                      {"velocity", "m/s", true},
                                      {"pressure", "Pa"},
                                      {"sensor", "-"},
                                      {"level", "-"}};
  if (material.has_products())
    names.push_back({"products", "-"});
  if (shows_burned_)
    names.push_back({"burned", "-"});
  io::FieldOutput<dim> output(names);
  const LeafLayout &layout = field.layout();
  const unsigned int n = std::max(1U, layout.n - 1);
  const unsigned int n_output = dealii::Utilities::pow(n + 1, dim);
  const auto stencils = output_stencils(points, n + 1);

  for (unsigned int leaf = 0; is_writer<dim>() && leaf < mesh.n_owned(); ++leaf)
  {
    auto patch = output.make_patch(n);
    const auto values = field.leaf(leaf);
    for (const unsigned int v : dealii::GeometryInfo<dim>::vertex_indices())
      patch.vertices[v] = mesh.cell(leaf)->vertex(v);
    for (unsigned int o = 0; o < n_output; ++o)
    {
      std::vector<double> u(layout.n_components, 0.);
      for (const auto &[q, weight] : stencils[o])
        for (unsigned int c = 0; c < layout.n_components; ++c)
          u[c] += weight * values[c * layout.n_points + q];
      auto state = primitive_state<dim>(u.data(), material);
      double burned = 0.;
      for (const auto &[q, weight] : stencils[o])
        burned += weight * field.burned(leaf, q);
      state.pressure = field.exerted_pressure(state.pressure, burned);
      unsigned int row = 0;
      patch.data(row++, o) = state.density;
      for (unsigned int d = 0; d < dim; ++d)
        patch.data(row++, o) = state.velocity[d];
      patch.data(row++, o) = state.pressure;
      patch.data(row++, o) = field.sensor()[leaf];
      patch.data(row++, o) = mesh.cell(leaf)->level();
      if (material.has_products())
        patch.data(row++, o) = state.products;
      if (shows_burned_)
        patch.data(row++, o) = burned;
    }
    output.add_patch(std::move(patch));
  }
  if (!is_writer<dim>())
    return "";
  return output.write_vtu(folder, "fields", index, mesh.communicator());
}


template <int dim>
void GasOutput<dim>::write_plane(const Plane &plane,
                                 const std::string &folder,
                                 const unsigned int index,
                                 const double time,
                                 const LeafMesh<dim> &mesh,
                                 const LeafPoints<dim> &points,
                                 const GasField &field,
                                 const GasMaterial &material) const
{
  if constexpr (dim > 1)
  {
    const auto &lower = mesh.coarse_mesh().lower_corner();
    const auto &upper = mesh.coarse_mesh().upper_corner();
    const unsigned int a = plane.direction == 0 ? 1 : 0;
    const unsigned int b = plane.direction == 2 ? 1 : 2;
    const double longer = std::max(upper[a] - lower[a], upper[b] - lower[b]);
    io::PlaneSamples samples;
    samples.time = time;
    for (unsigned int i = 0; i < 2; ++i)
    {
      const unsigned int d = i == 0 ? a : b;
      const double n = resolution_ * (upper[d] - lower[d]) / longer;
      samples.axes[i] = axis_names.substr(d, 1);
      samples.n_points[i] = std::max(2., std::round(n));
      // Samples stand in the middle of the picture's cells.
      const double half = 0.5 * (upper[d] - lower[d]) / samples.n_points[i];
      samples.lower[i] = lower[d] + half;
      samples.upper[i] = upper[d] - half;
    }
    std::vector<dealii::Point<dim>> places;
    for (std::size_t j = 0; j < samples.n_points[1]; ++j)
      for (std::size_t i = 0; i < samples.n_points[0]; ++i)
      {
        dealii::Point<dim> place;
        if (dim == 3)
          place[plane.direction % dim] = plane.position;
        place[a] = samples.lower[0] + (samples.upper[0] - samples.lower[0]) *
                                        i / (samples.n_points[0] - 1);
        place[b] = samples.lower[1] + (samples.upper[1] - samples.lower[1]) *
                                        j / (samples.n_points[1] - 1);
        places.push_back(place);
      }
    PointSampler<dim> sampler;
    sampler.reinit(places, mesh, points);
    const auto states = sampler.sample(field, material);
    if (dealii::Utilities::MPI::this_mpi_process(mesh.communicator()) != 0)
      return;

    const std::string suffix =
      dim == 2 ? ""
               : "_" + axis_names.substr(plane.direction, 1) + "_" +
                   std::to_string(&plane - planes_.data());
    for (const std::string quantity : {"pressure", "density"})
    {
      samples.quantity = quantity;
      samples.unit = quantity == "pressure" ? "Pa" : "kg/m^3";
      samples.values.clear();
      for (const auto &state : states)
        samples.values.push_back(quantity == "pressure" ? state.pressure
                                                        : state.density);
      std::ostringstream name;
      name << folder << "/plane" << suffix << "_" << quantity << "_"
           << std::setw(4) << std::setfill('0') << index;
      io::write_plane(name.str(), samples);
    }
  }
}


template class GasOutput<1>;
template class GasOutput<2>;
template class GasOutput<3>;
} // namespace contrecoup::gas
