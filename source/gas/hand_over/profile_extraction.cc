// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/hand_over/profile_extraction.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/record/blast_map_transfer.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace contrecoup::gas
{
const std::array<std::string, 5> record_names = {
  {"peak_overpressure", "arrival", "running_impulse", "impulse", "end"}};


namespace
{
  /// Relative difference from the ambient state that counts as a disturbance.
  double smallest_disturbance(const Precision precision)
  {
    return precision == Precision::single_precision ? 1e-6 : 1e-10;
  }

  template <int dim>
  bool is_disturbed(const std::vector<double> &leaf,
                    const unsigned int q,
                    const unsigned int n_points,
                    const std::vector<double> &ambient,
                    const double smallest)
  {
    using C = Component<dim>;
    const double density = ambient[C::density], energy = ambient[C::energy];
    const double momentum = std::sqrt(density * energy);
    const auto differs = [&](const unsigned int c, const double scale) {
      return std::abs(leaf[c * n_points + q] - ambient[c]) > smallest * scale;
    };
    bool result = differs(C::density, density) || differs(C::energy, energy);
    for (unsigned int d = 0; d < dim; ++d)
      result = result || differs(C::momentum + d, momentum);
    return result;
  }


  /// ProfileRaster of subcells of the finest refinement level in a box of whole
  /// leaves.
  template <int dim>
  class ProfileRaster
  {
  public:
    ProfileRaster(const LeafMesh<dim> &mesh,
                  const LeafPoints<dim> &points,
                  const dealii::Point<dim> &lower,
                  const dealii::Point<dim> &upper,
                  const int finest)
      : points_(points)
      , finest_(finest)
    {
      const auto &box = mesh.coarse_mesh();
      origin_ = box.lower_corner();
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double n_leaves = box.coarse_cells(d) * std::pow(2., finest);
        size_[d] = (box.upper_corner()[d] - origin_[d]) / n_leaves;
        // The raster ends at the domain's boundary where the box does.
        first_[d] =
          std::max(0., std::floor((lower[d] - origin_[d]) / size_[d] + 1e-6));
        const double last = std::min(
          n_leaves, std::ceil((upper[d] - origin_[d]) / size_[d] - 1e-6));
        n_leaves_[d] = last - first_[d];
      }
    }

    unsigned int n_cells(const unsigned int direction) const
    {
      return n_leaves_[direction] * points_.n();
    }

    std::size_t n_cells() const
    {
      std::size_t n = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n *= n_cells(d);
      return n;
    }

    std::vector<double> edges(const unsigned int d) const
    {
      std::vector<double> result;
      for (unsigned int i = 0; i < n_leaves_[d]; ++i)
        for (unsigned int k = 0; k < points_.n(); ++k)
          result.push_back(
            origin_[d] + size_[d] * (first_[d] + i + points_.subcell_begin(k)));
      result.push_back(origin_[d] + size_[d] * (first_[d] + n_leaves_[d]));
      return result;
    }

    /// Calls @p function(cell, point) for each point of a leaf of the finest
    /// level that lies in the raster; cell is its raster cell.
    template <typename Function>
    void for_each_cell(const LeafBox<dim> &leaf, const Function &function) const
    {
      std::array<long, dim> place;
      for (unsigned int d = 0; d < dim; ++d)
      {
        place[d] =
          std::lround((leaf.origin[d] - origin_[d]) / size_[d]) - first_[d];
        if (place[d] < 0 || place[d] >= static_cast<long>(n_leaves_[d]))
          return;
      }
      const unsigned int n = dealii::Utilities::pow(points_.n(), dim);
      for (unsigned int q = 0; q < n; ++q)
      {
        const auto index = points_.indices(q);
        std::size_t cell = 0, stride = 1;
        for (unsigned int d = 0; d < dim; ++d)
        {
          cell += stride * (place[d] * points_.n() + index[d]);
          stride *= n_cells(d);
        }
        function(cell, q);
      }
    }

    /// Whether a leaf overlaps the raster.
    bool overlaps(const LeafBox<dim> &leaf) const
    {
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double begin = origin_[d] + size_[d] * first_[d];
        const double end = begin + size_[d] * n_leaves_[d];
        if (leaf.origin[d] > end - 0.5 * size_[d] ||
            leaf.origin[d] + leaf.extents[d] < begin + 0.5 * size_[d])
          return false;
      }
      return true;
    }

    int finest() const
    {
      return finest_;
    }

  private:
    const LeafPoints<dim> &points_;
    const int finest_;
    dealii::Point<dim> origin_;
    dealii::Tensor<1, dim> size_; ///< edge lengths of the finest leaves [m]
    std::array<unsigned int, dim> first_, n_leaves_;
  };


  /// Refines the values of a leaf by @p to_children(values, box) to the finest
  /// level of the raster, and calls @p write(values, box) for each leaf there.
  template <int dim, typename Number, typename Refine, typename Write>
  void for_each_finest(const std::vector<Number> &leaf,
                       const LeafBox<dim> &box,
                       const int level,
                       const ProfileRaster<dim> &raster,
                       const Refine &to_children,
                       const Write &write)
  {
    if (!raster.overlaps(box))
      return;
    if (level == raster.finest())
    {
      write(leaf, box);
      return;
    }
    const auto children = to_children(leaf, box);
    for (unsigned int c = 0; c < children.size(); ++c)
    {
      LeafBox<dim> child;
      child.extents = 0.5 * box.extents;
      child.origin = box.origin;
      for (unsigned int d = 0; d < dim; ++d)
        if ((c >> d) & 1U)
          child.origin[d] += child.extents[d];
      for_each_finest(
        children[c], child, level + 1, raster, to_children, write);
    }
  }


  /// Rows of numbers on the raster. Each cell belongs to one rank, and
  /// shared() adds the zeros of the others.
  using Rows = std::vector<std::vector<double>>;

  Rows shared(Rows rows, const MPI_Comm communicator)
  {
    for (auto &row : rows)
      dealii::Utilities::MPI::sum(row, communicator, row);
    return rows;
  }


  /// Conserved quantities, and last the volumes of the scheme.
  template <int dim>
  Rows state_rows(const LeafMesh<dim> &mesh,
                  const LeafPoints<dim> &points,
                  const GasField &field,
                  const GasMaterial &material,
                  const ProfileRaster<dim> &raster)
  {
    const unsigned int n_points = field.layout().n_points;
    const LeafTransfer<dim> transfer(points, field.layout(), material);
    Rows rows(dim + 4, std::vector<double>(raster.n_cells(), 0.));
    const auto write = [&](const auto &leaf, const LeafBox<dim> &box) {
      raster.for_each_cell(box, [&](const std::size_t cell, unsigned int q) {
        for (unsigned int c = 0; c * n_points < leaf.size(); ++c)
          rows[c][cell] = leaf[c * n_points + q];
        rows.back()[cell] = point_volume(box, points, q);
      });
    };
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      for_each_finest(
        field.leaf(leaf),
        leaf_box(mesh, leaf),
        mesh.cell(leaf)->level(),
        raster,
        [&](const auto &parent, const LeafBox<dim> &box) {
          return transfer.to_children(parent, box);
        },
        write);
    return shared(std::move(rows), mesh.communicator());
  }


  /// The numbers of the maps.
  template <int dim>
  Rows map_rows(const LeafMesh<dim> &mesh,
                const LeafPoints<dim> &points,
                const BlastMaps<dim> &maps,
                const ProfileRaster<dim> &raster)
  {
    const unsigned int n_points = dealii::Utilities::pow(points.n(), dim);
    const BlastMapTransfer<dim> transfer(points);
    Rows rows(BlastMaps<dim>::Record::n_values,
              std::vector<double>(raster.n_cells(), 0.));
    const auto write = [&](const auto &leaf, const LeafBox<dim> &box) {
      raster.for_each_cell(box, [&](const std::size_t cell, unsigned int q) {
        for (unsigned int v = 0; v < rows.size(); ++v)
          rows[v][cell] = leaf[v * n_points + q];
      });
    };
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      for_each_finest(
        maps.leaf(leaf),
        leaf_box(mesh, leaf),
        mesh.cell(leaf)->level(),
        raster,
        [&](const auto &parent, const LeafBox<dim> &) {
          return transfer.to_children(parent);
        },
        write);
    return shared(std::move(rows), mesh.communicator());
  }


  /// Rescales values from the scheme's volumes to those of the raster cells,
  /// where the two differ.
  void correct_volumes(ProfileData &data, const std::vector<double> &volumes)
  {
    const Profile cells(data);
    for (std::size_t cell = 0; cell < volumes.size(); ++cell)
    {
      const double factor = volumes[cell] / cells.volume(cell);
      if (std::abs(factor - 1.) > 1e-11)
        for (auto &values : data.values)
          values[cell] *= factor;
    }
  }
} // namespace


template <int dim>
std::pair<dealii::Point<dim>, dealii::Point<dim>>
disturbed_box(const LeafMesh<dim> &mesh,
              const LeafPoints<dim> &points,
              const GasField &field,
              const std::vector<double> &ambient)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> outermost(2 * dim, -infinity); // -lower, upper
  const unsigned int n_points = field.layout().n_points;
  const double smallest = smallest_disturbance(field.layout().precision);
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const auto values = field.leaf(leaf);
    const LeafBox<dim> box = leaf_box(mesh, leaf);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      if (!is_disturbed<dim>(values, q, n_points, ambient, smallest))
        continue;
      const auto index = points.indices(q);
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double begin =
          box.origin[d] + box.extents[d] * points.subcell_begin(index[d]);
        const double end =
          box.origin[d] + box.extents[d] * points.subcell_end(index[d]);
        outermost[2 * d] = std::max(outermost[2 * d], -begin);
        outermost[2 * d + 1] = std::max(outermost[2 * d + 1], end);
      }
    }
  }
  dealii::Utilities::MPI::max(outermost, mesh.communicator(), outermost);
  std::pair<dealii::Point<dim>, dealii::Point<dim>> result;
  for (unsigned int d = 0; d < dim; ++d)
  {
    result.first[d] = -outermost[2 * d];
    result.second[d] = outermost[2 * d + 1];
  }
  return result;
}


template <int dim>
ProfileData extract_profile(const LeafMesh<dim> &mesh,
                            const LeafPoints<dim> &points,
                            const GasField &field,
                            const GasMaterial &material,
                            const GasState<dim> &ambient,
                            const BlastMaps<dim> &maps)
{
  using C = Component<dim>;
  const auto &box = mesh.coarse_mesh();
  if (dim == 3 || box.geometry() == Geometry::plane)
    throw InputError("Output/Profile file: only domains with spherical, "
                     "cylindrical or axisymmetric geometry have a profile");
  const auto state = conserved_state(ambient, material, dim + 3);
  auto [lower, upper] = disturbed_box(mesh, points, field, state);
  if (!(lower[0] < upper[0]))
    throw InputError("The profile is empty: the gas is undisturbed");
  // The raster includes the centre even where the gas has come to rest.
  lower[0] = box.lower_corner()[0];
  int finest = 0;
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    finest = std::max(finest, mesh.cell(leaf)->level());
  finest = dealii::Utilities::MPI::max(finest, mesh.communicator());

  const ProfileRaster<dim> raster(mesh, points, lower, upper, finest);
  ProfileData data;
  data.geometry = box.geometry();
  data.ambient = {{state[C::density], state[C::energy], state[C::products]}};
  data.ambient_pressure = ambient.pressure;
  for (unsigned int d = 0; d < dim; ++d)
  {
    data.domain_begin.push_back(box.lower_corner()[d]);
    data.domain_end.push_back(box.upper_corner()[d]);
    data.edges.push_back(raster.edges(d));
  }
  data.values = state_rows(mesh, points, field, material, raster);
  const std::vector<double> volumes = std::move(data.values.back());
  data.values.pop_back();
  correct_volumes(data, volumes);
  if (!maps.empty())
  {
    Rows rows = map_rows(mesh, points, maps, raster);
    for (unsigned int v = 0; v < rows.size(); ++v)
      data.maps[record_names[v]] = std::move(rows[v]);
  }
  return data;
}


#define CONTRECOUP_INSTANTIATE(dim)                                         \
  template std::pair<dealii::Point<dim>, dealii::Point<dim>> disturbed_box( \
    const LeafMesh<dim> &,                                                  \
    const LeafPoints<dim> &,                                                \
    const GasField &,                                                       \
    const std::vector<double> &);                                           \
  template ProfileData extract_profile(const LeafMesh<dim> &,               \
                                       const LeafPoints<dim> &,             \
                                       const GasField &,                    \
                                       const GasMaterial &,                 \
                                       const GasState<dim> &,               \
                                       const BlastMaps<dim> &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
