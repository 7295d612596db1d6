// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/octree/lattice.h>
#include <contrecoup/gas/run/gas_output.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/point_sampler.h>
#include <contrecoup/io/output/field_output.h>

#include <deal.II/base/geometry_info.h>

#include <limits>

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

  /// Interpolation from the points of a leaf to its equidistant output points,
  /// m per direction: indices and weights.
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
    {
      const auto place = lattice_indices<dim>(o, m);
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const auto index = points.indices(q);
        double weight = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          weight *= line[place[d]][index[d]];
        if (weight != 0.)
          stencils[o].emplace_back(q, weight);
      }
    }
    return stencils;
  }

  /// Sets the positions of the output points of a leaf, the last rows of its
  /// data; see io::FieldOutput::make_patch().
  template <int dim>
  void set_points(const LeafBox<dim> &box,
                  typename io::FieldOutput<dim>::Patch &patch)
  {
    const unsigned int n = patch.n_subdivisions;
    const unsigned int first_row = patch.data.n_rows() - dim;
    for (unsigned int o = 0; o < patch.data.n_cols(); ++o)
    {
      dealii::Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = double(lattice_indices<dim>(o, n + 1)[d]) / n;
      const dealii::Point<dim> place = box.place(x);
      for (unsigned int d = 0; d < dim; ++d)
        patch.data(first_row + d, o) = place[d];
    }
  }

  /// Samples at the centres of the pixels of a picture, with the given
  /// resolution along its longer side.
  template <int dim>
  struct Raster
  {
    Raster(const CoarseMesh<dim> &mesh,
           const unsigned int direction,
           const double position,
           const unsigned int resolution)
    {
      const auto &lower = mesh.lower_corner();
      const auto &upper = mesh.upper_corner();
      const unsigned int a = direction == 0 ? 1 : 0;
      const unsigned int b = direction == 2 ? 1 : 2;
      const double longer = std::max(upper[a] - lower[a], upper[b] - lower[b]);
      for (unsigned int i = 0; i < 2; ++i)
      {
        const unsigned int d = i == 0 ? a : b;
        const double n = resolution * (upper[d] - lower[d]) / longer;
        samples.axes[i] = d;
        samples.n_points[i] = std::max(2., std::round(n));
        const double half = 0.5 * (upper[d] - lower[d]) / samples.n_points[i];
        samples.lower[d] = lower[d] + half;
        samples.upper[d] = upper[d] - half;
      }
      if (dim == 3)
        samples.lower[direction] = samples.upper[direction] = position;
      for (std::size_t j = 0; j < samples.n_points[1]; ++j)
        for (std::size_t i = 0; i < samples.n_points[0]; ++i)
        {
          dealii::Point<dim> place;
          if (dim == 3)
            place[direction % dim] = position;
          place[a] = samples.lower[a] + (samples.upper[a] - samples.lower[a]) *
                                          i / (samples.n_points[0] - 1);
          place[b] = samples.lower[b] + (samples.upper[b] - samples.lower[b]) *
                                          j / (samples.n_points[1] - 1);
          places.push_back(place);
        }
    }

    io::PlaneSamples samples; ///< without fields
    std::vector<dealii::Point<dim>> places;
  };

  /// Open fraction of the point of a leaf at a position.
  double
  open_fraction(const GasField &field,
                const unsigned int leaf,
                const std::vector<std::pair<unsigned int, double>> &stencil)
  {
    double result = 0.;
    for (const auto &[q, weight] : stencil)
      result += weight * field.open_fraction(leaf, q);
    return result;
  }

  /// Value of pictures inside a body.
  constexpr double no_gas = std::numeric_limits<double>::quiet_NaN();

  /// Open fraction of the point that contains each sample.
  template <int dim>
  std::vector<double> open_fractions(const PointSampler<dim> &sampler,
                                     const GasField &field)
  {
    return sampler.nearest(
      1, [&](const unsigned int leaf, const unsigned int q, double *to) {
        *to = field.open_fraction(leaf, q);
      });
  }

  /// Values of map_fields at point @p q of a leaf.
  template <int dim>
  std::array<double, 5> mapped(const BlastMaps<dim> &maps,
                               const unsigned int leaf,
                               const unsigned int q,
                               const double time)
  {
    return map_field_values(maps.record(leaf, q).measures(time), time);
  }
} // namespace


template <int dim>
void GasOutput<dim>::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Output");
    declare_bool(prm,
                 "Pictures",
                 "false",
                 "Whether a finished run draws its history, probes, planes, "
                 "maps and loads in the folder pictures.");
    declare_bool(
      prm,
      "Volume fields",
      "true",
      used_with("Output/Fields = true",
                "Whether field outputs include the gas in the whole domain, "
                "for ParaView, besides planes and probes; some 30 bytes per "
                "cell and output."));
  }
  const Section section(prm, "Pictures");
  declare_string(
    prm,
    "Planes",
    "",
    selecting("Planes \"y = 0, z = 0.5\" [m] on which pressure and "
              "density are sampled for pictures at every field output; "
              "in 2-D \"all\" takes the whole domain."));
  declare_integer(prm,
                  "Resolution",
                  "256",
                  2,
                  4096,
                  used_with("Pictures/Planes not empty",
                            "Samples along the longer side of a picture."));
}


template <int dim>
void GasOutput<dim>::parse_parameters(ParameterHandler &prm,
                                      const CoarseMesh<dim> &mesh)
{
  {
    const Section section(prm, "Output");
    wants_volume_ = prm.get_bool("Volume fields");
  }
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
std::vector<FieldFile> GasOutput<dim>::write(const GasSnapshot<dim> &gas,
                                             const BlastMaps<dim> &maps,
                                             const Target &target) const
{
  // Collective, hence before the first rank writes files, which may fail.
  std::vector<PlaneFiles> planes;
  for (const Plane &plane : planes_)
    planes.push_back(sample_plane(plane, gas, maps, target));
  std::vector<FieldFile> files;
  if (wants_volume_)
    files.push_back({"gas", write_leaves(gas, maps, target)});
  const bool writes =
    dealii::Utilities::MPI::this_mpi_process(gas.mesh.communicator()) == 0;
  for (const PlaneFiles &plane : planes)
  {
    files.push_back(plane.file);
    if (writes)
      io::write_plane(target.folder + "/" + plane.file.file, plane.gas);
    if (writes && !plane.maps.fields.empty())
      io::write_plane(target.folder + "/" + plane.stem + "_maps.vti",
                      plane.maps);
  }
  return files;
}


template <int dim>
std::vector<io::FieldName>
GasOutput<dim>::field_names(const GasSnapshot<dim> &gas,
                            const bool has_maps) const
{
  std::vector<io::FieldName> names = {{"density", "kg/m^3"},
                                      {"velocity", "m/s", true},
                                      {"pressure", "Pa"},
                                      {"sensor", "-"},
                                      {"level", "-"}};
  if (gas.scene.material.has_products())
    names.push_back({"products", "-"});
  if (!gas.scene.charges.empty())
    names.push_back({"burned", "-"});
  if (has_maps)
    for (const auto &[name, unit] : map_fields)
      names.push_back({name, unit});
  if (gas.field.open_fractions() != nullptr)
    names.push_back({"open_fraction", "-"});
  return names;
}


template <int dim>
std::string GasOutput<dim>::write_leaves(const GasSnapshot<dim> &gas,
                                         const BlastMaps<dim> &maps,
                                         const Target &target) const
{
  io::FieldOutput<dim> output(field_names(gas, !maps.empty()));
  const LeafLayout &layout = gas.field.layout();
  const unsigned int n = std::max(1U, layout.n - 1);
  const unsigned int n_output = dealii::Utilities::pow(n + 1, dim);
  const auto stencils = output_stencils(gas.scene.points, n + 1);

  for (unsigned int leaf = 0; is_writer<dim>() && leaf < gas.mesh.n_owned();
       ++leaf)
  {
    const LeafBox<dim> box = leaf_box(gas.mesh, leaf);
    auto patch = output.make_patch(n, box.curved_shapes != nullptr);
    const auto values = gas.field.leaf(leaf);
    for (const unsigned int v : dealii::GeometryInfo<dim>::vertex_indices())
      patch.vertices[v] = gas.mesh.cell(leaf)->vertex(v);
    for (unsigned int o = 0; o < n_output; ++o)
    {
      std::vector<double> u(layout.n_components, 0.);
      for (const auto &[q, weight] : stencils[o])
        for (unsigned int c = 0; c < layout.n_components; ++c)
          u[c] += weight * values[c * layout.n_points + q];
      auto state = primitive_state<dim>(u.data(), gas.scene.material);
      double burned = 0.;
      for (const auto &[q, weight] : stencils[o])
        burned += weight * gas.field.burned(leaf, q);
      state.pressure = gas.field.exerted_pressure(state.pressure, burned);
      unsigned int row = 0;
      patch.data(row++, o) = state.density;
      for (unsigned int d = 0; d < dim; ++d)
        patch.data(row++, o) = state.velocity[d];
      patch.data(row++, o) = state.pressure;
      patch.data(row++, o) = gas.field.sensor_of(leaf);
      patch.data(row++, o) = gas.mesh.cell(leaf)->level();
      if (gas.scene.material.has_products())
        patch.data(row++, o) = state.products;
      if (!gas.scene.charges.empty())
        patch.data(row++, o) = burned;
      // Maps are not interpolated: as many output points as points, or one.
      if (!maps.empty())
        for (const double value :
             mapped(maps, leaf, layout.n > 1 ? o : 0, gas.time))
          patch.data(row++, o) = value;
      if (gas.field.open_fractions() != nullptr)
        patch.data(row++, o) = open_fraction(gas.field, leaf, stencils[o]);
    }
    if (patch.points_are_available)
      set_points(box, patch);
    output.add_patch(std::move(patch));
  }
  if (!is_writer<dim>())
    return "";
  return output.write_vtu(
    target.folder, "fields", target.index, gas.mesh.communicator());
}


template <int dim>
typename GasOutput<dim>::PlaneFiles
GasOutput<dim>::sample_plane(const Plane &plane,
                             const GasSnapshot<dim> &gas,
                             const BlastMaps<dim> &maps,
                             const Target &target) const
{
  if constexpr (dim > 1)
  {
    Raster<dim> raster(
      gas.mesh.coarse_mesh(), plane.direction, plane.position, resolution_);
    PointSampler<dim> sampler;
    sampler.reinit(raster.places, gas.mesh, gas.scene.points);
    const auto states = sampler.sample(gas.field, gas.scene.material);
    const unsigned int n_maps = maps.empty() ? 0 : map_fields.size();
    std::vector<double> records;
    if (n_maps > 0)
      records = sampler.nearest(
        n_maps, [&](const unsigned int leaf, const unsigned int q, double *to) {
          const auto values = mapped(maps, leaf, q, gas.time);
          std::copy_n(values.begin(), n_maps, to);
        });
    const std::vector<double> open = open_fractions(sampler, gas.field);

    const std::string axis = axis_names.substr(plane.direction, 1);
    const std::string stem =
      dim == 2
        ? "plane"
        : "plane_" + axis + "_" + std::to_string(&plane - planes_.data());
    PlaneFiles result;
    result.stem = stem;
    result.file = {
      dim == 2 ? "plane" : "plane " + axis + " = " + brief(plane.position),
      stem + "_" + dealii::Utilities::int_to_string(target.index, 4) + ".vti"};
    if (dealii::Utilities::MPI::this_mpi_process(gas.mesh.communicator()) != 0)
      return result;
    raster.samples.time = gas.time;
    result.gas = result.maps = raster.samples;
    const auto add = [&](io::PlaneSamples &samples,
                         const std::string &name,
                         const std::string &unit,
                         const std::function<double(std::size_t)> &value) {
      std::vector<double> values;
      for (std::size_t i = 0; i < states.size(); ++i)
        values.push_back(open[i] > 0. ? value(i) : no_gas);
      samples.fields.push_back({name, unit, std::move(values)});
    };
    add(result.gas, "pressure", "Pa", [&](const auto i) {
      return states[i].pressure;
    });
    add(result.gas, "density", "kg/m^3", [&](const auto i) {
      return states[i].density;
    });
    for (unsigned int k = 0; k < n_maps; ++k)
      add(result.maps,
          map_fields[k].first,
          map_fields[k].second,
          [&](const auto i) { return records[i * n_maps + k]; });
    return result;
  }
  else
    throw std::logic_error("planes need two dimensions");
}


template class GasOutput<1>;
template class GasOutput<2>;
template class GasOutput<3>;
} // namespace contrecoup::gas
