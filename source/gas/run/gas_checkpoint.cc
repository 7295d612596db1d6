// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/run/gas_checkpoint.h>
#include <contrecoup/io/file/checked_file.h>

#include <deal.II/grid/cell_id.h>

#include <boost/signals2/connection.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace contrecoup::gas
{
namespace
{
  using Id = dealii::CellId::binary_type;

  struct Header
  {
    std::uint64_t dim;
    std::uint64_t n_points;
    std::uint64_t n_components;
    std::uint64_t n_files;
    std::uint64_t n_leaves;
    std::uint64_t n_map_values; ///< of each leaf, single precision

    /// Number of bytes of a leaf's data.
    std::uint64_t leaf_size() const
    {
      return sizeof(double) * n_points * n_components +
             sizeof(float) * n_map_values;
    }
  };

  /// Location of the state of a saved leaf in the files.
  struct Location
  {
    unsigned int file;
    std::uint64_t position; ///< [byte]
  };

  struct IdHash
  {
    std::size_t operator()(const Id &id) const
    {
      std::size_t result = 0;
      for (const auto part : id)
        result = result * 0x9e3779b97f4a7c15ULL + part;
      return result;
    }
  };
  using Locations = std::unordered_map<Id, Location, IdHash>;
  using IdSet = std::unordered_set<Id, IdHash>;

  std::string file_name(const std::string &folder, const unsigned int rank)
  {
    return folder + "/octree." + std::to_string(rank) + ".bin";
  }

  Header read_header(const std::string &file, std::ifstream &stream)
  {
    Header header{};
    stream.open(file, std::ios::binary);
    stream.read(reinterpret_cast<char *>(&header), sizeof(header));
    if (!stream)
      throw InputError("Checkpoint file " + file + " cannot be read");
    return header;
  }

  /// Locations of all saved leaves, from the tables of all files.
  Locations read_tables(const std::string &folder,
                        const unsigned int dim,
                        const LeafLayout &layout,
                        const bool with_maps)
  {
    Locations locations;
    unsigned int n_files = 1;
    for (unsigned int rank = 0; rank < n_files; ++rank)
    {
      std::ifstream stream;
      const Header header = read_header(file_name(folder, rank), stream);
      if (header.dim != dim || header.n_points != layout.n_points ||
          header.n_components != layout.n_components)
        throw InputError("Checkpoint " + folder +
                         " belongs to another scene: dimension, method or "
                         "material differ");
      if (with_maps && header.n_map_values == 0)
        throw InputError("Output/Maps = true: checkpoint " + folder +
                         " holds no maps");
      n_files = header.n_files;
      const std::uint64_t size = header.leaf_size();
      const std::string file = file_name(folder, rank);
      if (std::filesystem::file_size(file) !=
          sizeof(Header) + header.n_leaves * (sizeof(Id) + size))
        throw InputError("Checkpoint file " + file +
                         " is damaged: its size does not fit its leaves");
      std::vector<Id> ids(header.n_leaves);
      stream.read(reinterpret_cast<char *>(ids.data()),
                  ids.size() * sizeof(Id));
      const std::uint64_t start = sizeof(Header) + ids.size() * sizeof(Id);
      for (std::size_t i = 0; i < ids.size(); ++i)
        locations[ids[i]] = {rank, start + i * size};
    }
    return locations;
  }

  /// All ancestors of the saved leaves.
  template <int dim>
  IdSet ancestors_of(const Locations &locations)
  {
    IdSet result;
    for (const auto &[leaf, location] : locations)
    {
      const dealii::CellId id(leaf);
      const auto path = id.get_child_indices();
      std::vector<std::uint8_t> above(path.begin(), path.end());
      while (!above.empty())
      {
        above.pop_back();
        const dealii::CellId parent(id.get_coarse_cell_id(), above);
        if (!result.insert(parent.template to_binary<dim>()).second)
          break;
      }
    }
    return result;
  }

  /// Refines until every owned leaf is one of the saved ones.
  template <int dim>
  void refine_to(LeafMesh<dim> &mesh, const Locations &locations)
  {
    auto &tria = mesh.triangulation();
    const IdSet ancestors = ancestors_of<dim>(locations);
    for (;;)
    {
      // 0: all leaves found, 1: some must be refined, 2: some are unknown
      unsigned int state = 0;
      for (const auto &cell : tria.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          const Id id = cell->id().template to_binary<dim>();
          if (locations.count(id) > 0)
            continue;
          if (ancestors.count(id) > 0)
            cell->set_refine_flag();
          state = std::max(state, ancestors.count(id) > 0 ? 1U : 2U);
        }
      state = dealii::Utilities::MPI::max(state, mesh.communicator());
      const bool is_complete =
        state == 0 && tria.n_global_active_cells() == locations.size();
      if (is_complete)
        return;
      if (state != 1)
        throw InputError("The checkpoint belongs to another mesh: its leaves "
                         "differ");
      tria.execute_coarsening_and_refinement();
      mesh.distribute();
    }
  }

  /// Last leaf of each file in the order of p4est, which is that of the names:
  /// the coarse cell in a name is the number of p4est's tree.
  std::map<unsigned int, dealii::CellId> last_leaves(const Locations &locations)
  {
    std::map<unsigned int, dealii::CellId> last;
    for (const auto &[leaf, location] : locations)
    {
      const dealii::CellId id(leaf);
      const auto entry = last.try_emplace(location.file, id);
      if (entry.first->second < id)
        entry.first->second = id;
    }
    return last;
  }

  /// Gives each rank the leaves that it had, if they were saved by as many
  /// ranks and none had none: then sums over the ranks keep the same last
  /// bits. p4est cuts behind the leaves where the sum of the weights reaches
  /// multiples of its mean over the ranks.
  template <int dim>
  void distribute_as_saved(LeafMesh<dim> &mesh, const Locations &locations)
  {
    if constexpr (dim > 1)
    {
      std::set<dealii::CellId> last;
      for (const auto &[file, id] : last_leaves(locations))
        last.insert(id);
      if (last.size() !=
          dealii::Utilities::MPI::n_mpi_processes(mesh.communicator()))
        return;
      const boost::signals2::scoped_connection weigher =
        mesh.triangulation().signals.weight.connect(
          [&](const typename LeafMesh<dim>::CellIterator &cell, const auto) {
            return last.count(cell->id()) > 0 ? 1U : 0U;
          });
      mesh.distribute();
    }
  }
} // namespace


template <int dim>
void save_leaves(const LeafMesh<dim> &mesh,
                 const GasField &field,
                 const std::string &folder,
                 const BlastMaps<dim> *maps)
{
  const bool with_maps = maps != nullptr && !maps->empty();
  const auto communicator = mesh.communicator();
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(communicator);
  // In 1-D every rank has the whole mesh: the first one writes it.
  if (dim == 1 && dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  io::write_file(file_name(folder, rank), [&](std::ostream &out) {
    const Header header = {
      dim,
      field.layout().n_points,
      field.layout().n_components,
      dealii::Utilities::MPI::n_mpi_processes(communicator),
      mesh.n_owned(),
      with_maps ? maps->n_leaf_values() : 0};
    out.write(reinterpret_cast<const char *>(&header), sizeof(header));
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    {
      const Id id = mesh.cell(leaf)->id().template to_binary<dim>();
      out.write(reinterpret_cast<const char *>(&id), sizeof(id));
    }
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    {
      const auto values = field.leaf(leaf);
      out.write(reinterpret_cast<const char *>(values.data()),
                values.size() * sizeof(double));
      if (!with_maps)
        continue;
      const auto records = maps->leaf(leaf);
      out.write(reinterpret_cast<const char *>(records.data()),
                records.size() * sizeof(float));
    }
  });
}


template <int dim>
void restore_leaves(LeafMesh<dim> &mesh,
                    GasField &field,
                    const LeafLayout &layout,
                    const std::string &folder,
                    BlastMaps<dim> *maps)
{
  const Locations locations = read_tables(folder, dim, layout, maps != nullptr);
  refine_to(mesh, locations);
  mesh.rebuild();
  distribute_as_saved(mesh, locations);
  field.reinit(layout, mesh.n_stored_batches());
  std::vector<float> records;
  if (maps != nullptr)
  {
    maps->reinit(layout.n_points, mesh.n_owned());
    records.resize(maps->n_leaf_values());
  }

  std::map<unsigned int, std::ifstream> streams;
  std::vector<double> values(layout.n_points * layout.n_components);
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const Location location =
      locations.at(mesh.cell(leaf)->id().template to_binary<dim>());
    auto &stream = streams[location.file];
    if (!stream.is_open())
      stream.open(file_name(folder, location.file), std::ios::binary);
    stream.seekg(location.position);
    stream.read(reinterpret_cast<char *>(values.data()),
                values.size() * sizeof(double));
    stream.read(reinterpret_cast<char *>(records.data()),
                records.size() * sizeof(float));
    if (!stream)
      throw InputError("Checkpoint file " + file_name(folder, location.file) +
                       " ends too early");
    field.set_leaf(leaf, values);
    if (maps != nullptr)
      maps->set_leaf(leaf, records);
  }
  field.fill_padding(mesh.n_owned());
}


#define CONTRECOUP_INSTANTIATE(dim)                  \
  template void save_leaves(const LeafMesh<dim> &,   \
                            const GasField &,        \
                            const std::string &,     \
                            const BlastMaps<dim> *); \
  template void restore_leaves(LeafMesh<dim> &,      \
                               GasField &,           \
                               const LeafLayout &,   \
                               const std::string &,  \
                               BlastMaps<dim> *)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
