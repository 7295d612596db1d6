// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/deal_ii/releases.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/field_output.h>

#include <deal.II/base/utilities.h>
#include <deal.II/grid/reference_cell.h>

#include <sstream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    const char *const vtu = "vtu";
    const char *const hdf5 = "hdf5";

    /// Copies a VTU file of deal.II, whose attribute "units" ParaView does not
    /// read, and adds the units as VTK's own key after the numbers.
    void label_units(std::istream &vtu, std::ostream &out)
    {
      const std::string mark = " units=\"", end = "</DataArray>";
      std::string unit;
      for (std::string line; std::getline(vtu, line);)
      {
        const std::size_t begin = line.find(mark);
        if (begin != std::string::npos)
        {
          const std::size_t first = begin + mark.size();
          unit = line.substr(first, line.find('"', first) - first);
        }
        const std::size_t close = line.find(end);
        if (close != std::string::npos && !unit.empty())
        {
          line.insert(close,
                      "<InformationKey name=\"UNITS_LABEL\" "
                      "location=\"vtkDataArray\">" +
                        unit + "</InformationKey>");
          unit.clear();
        }
        out << line << '\n';
      }
    }

    std::string numbered(const std::string &stem, const unsigned int index)
    {
      return stem + "_" + dealii::Utilities::int_to_string(index, 4);
    }
  } // namespace

  void declare_field_format(dealii::ParameterHandler &prm)
  {
    declare_selection(prm,
                      "Field format",
                      vtu,
                      {vtu, hdf5},
                      "File format of fields: VTU pieces with a .pvd "
                      "collection, or one HDF5 file with an XDMF file per "
                      "output (2-D and 3-D).");
  }

  template <int dim, int spacedim>
  FieldOutput<dim, spacedim>::FieldOutput(const std::vector<FieldName> &names)
    : names_(names)
  {
    dealii::DataOutBase::VtkFlags flags;
    flags.compression_level = fastest_compression;
    flags.print_date_and_time = false;
    for (const FieldName &name : names)
      if (!name.unit.empty())
        flags.physical_units[name.name] = name.unit;
    this->set_flags(flags);
  }

  template <int dim, int spacedim>
  unsigned int FieldOutput<dim, spacedim>::n_components() const
  {
    unsigned int n = 0;
    for (const FieldName &name : names_)
      n += name.is_vector ? spacedim : 1;
    return n;
  }

  template <int dim, int spacedim>
  typename FieldOutput<dim, spacedim>::Patch
  FieldOutput<dim, spacedim>::make_patch(const unsigned int n_subdivisions,
                                         const bool has_points) const
  {
    Patch patch;
    patch.points_are_available = has_points;
    if constexpr (dim > 0)
      patch.n_subdivisions = n_subdivisions;
    patch.data.reinit(n_components() + (has_points ? spacedim : 0),
                      dealii::Utilities::fixed_power<dim>(n_subdivisions + 1));
    return patch;
  }

  template <int dim, int spacedim>
  void FieldOutput<dim, spacedim>::add_patch(Patch &&patch)
  {
    patch.patch_index = static_cast<unsigned int>(patches_.size());
    if constexpr (dim > 0)
      patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>();
    patches_.push_back(std::move(patch));
  }

  template <int dim, int spacedim>
  std::string FieldOutput<dim, spacedim>::write(const std::string &format,
                                                const std::string &folder,
                                                const std::string &stem,
                                                const unsigned int index,
                                                const double time,
                                                const MPI_Comm communicator)
  {
    if (format == hdf5)
      return write_hdf5(folder, stem, index, time, communicator);
    return write_vtu(folder, stem, index, communicator);
  }

  template <int dim, int spacedim>
  std::string FieldOutput<dim, spacedim>::write_vtu(const std::string &folder,
                                                    const std::string &stem,
                                                    const unsigned int index,
                                                    const MPI_Comm communicator)
  {
    namespace MPI = dealii::Utilities::MPI;
    const unsigned int n = MPI::n_mpi_processes(communicator);
    const unsigned int rank = MPI::this_mpi_process(communicator);
    const std::string name = numbered(stem, index);
    const auto piece = [&](const unsigned int of_rank) {
      const std::string number =
        n > 1 ? "." + dealii::Utilities::int_to_string(of_rank, 4) : "";
      return name + number + ".vtu";
    };
    // No communication from here on: a rank with a full disk must not block
    // the others.
    const auto n_patches =
      gather_arrays(communicator, std::vector<std::size_t>{patches_.size()});
    // A rank without patches writes no piece.
    if (!patches_.empty() || n == 1)
    {
      std::stringstream vtu;
      dealii::DataOutInterface<dim, spacedim>::write_vtu(vtu);
      write_file(folder + "/" + piece(rank),
                 [&](std::ostream &out) { label_units(vtu, out); });
    }
    if (n == 1)
      return piece(0);
    if (rank == 0)
    {
      std::vector<std::string> pieces;
      for (unsigned int r = 0; r < n; ++r)
        if (n_patches[r][0] > 0)
          pieces.push_back(piece(r));
      write_file(folder + "/" + name + ".pvtu", [&](std::ostream &out) {
        this->write_pvtu_record(out, pieces);
      });
    }
    return name + ".pvtu";
  }

  template <int dim, int spacedim>
  std::string
  FieldOutput<dim, spacedim>::write_hdf5(const std::string &folder,
                                         const std::string &stem,
                                         const unsigned int index,
                                         const double time,
                                         const MPI_Comm communicator)
  {
    const std::string name = numbered(stem, index);
    if constexpr (dim < 2)
      throw InputError(
        "\"Field format\" cannot be \"hdf5\" of points or in one dimension; "
        "allowed: vtu");
    else
    {
      // deal.II 9.4 requires patches on every writing rank.
      MPI_Comm writers;
      MPI_Comm_split(communicator, patches_.empty() ? 1 : 0, 0, &writers);
      if (!patches_.empty())
        write_hdf5_files(folder, name, time, writers);
      MPI_Comm_free(&writers);
    }
    return name + ".xdmf";
  }

  template <int dim, int spacedim>
  void FieldOutput<dim, spacedim>::write_hdf5_files(const std::string &folder,
                                                    const std::string &name,
                                                    const double time,
                                                    const MPI_Comm writers)
  {
    const std::string file = folder + "/" + name;
    try
    {
      dealii::DataOutBase::DataOutFilter filter(
        dealii::DataOutBase::DataOutFilterFlags(false, true));
      this->write_filtered_data(filter);
      this->write_hdf5_parallel(filter, file + ".h5", writers);
      const auto entry =
        this->create_xdmf_entry(filter, name + ".h5", time, writers);
      this->write_xdmf_file({entry}, file + ".xdmf", writers);
    }
    catch (const dealii::ExceptionBase &error)
    {
      remove_quietly(file + ".h5");
      remove_quietly(file + ".xdmf");
      throw SystemError("cannot write \"" + file +
                        ".h5\": is the disk full? (" + error.get_exc_name() +
                        ")");
    }
  }

  template <int dim, int spacedim>
  const std::vector<typename FieldOutput<dim, spacedim>::Patch> &
  FieldOutput<dim, spacedim>::get_patches() const
  {
    return patches_;
  }

  template <int dim, int spacedim>
  std::vector<std::string> FieldOutput<dim, spacedim>::get_dataset_names() const
  {
    std::vector<std::string> components;
    for (const FieldName &name : names_)
      components.insert(
        components.end(), name.is_vector ? spacedim : 1, name.name);
    return components;
  }

  template <int dim, int spacedim>
  std::vector<typename FieldOutput<dim, spacedim>::Range>
  FieldOutput<dim, spacedim>::get_nonscalar_data_ranges() const
  {
    namespace Interpretation = dealii::DataComponentInterpretation;
    std::vector<Range> ranges;
    unsigned int component = 0;
    for (const FieldName &name : names_)
    {
      if (name.is_vector)
        ranges.emplace_back(component,
                            component + spacedim - 1,
                            name.name,
                            Interpretation::component_is_part_of_vector);
      component += name.is_vector ? spacedim : 1;
    }
    return ranges;
  }

  template class FieldOutput<0, 3>;
  template class FieldOutput<1>;
  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace io
} // namespace contrecoup
