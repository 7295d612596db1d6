// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Declares "Field format" in the current subsection: vtu or hdf5.
  void declare_field_format(dealii::ParameterHandler &prm);

  /// A field: a scalar, or a vector of spacedim components.
  struct FieldName
  {
    std::string name;
    std::string unit;
    bool is_vector = false;
  };

  /**
   * Writes fields that a solver stores in patches: one patch per octree leaf
   * with n_subdivisions cells per direction, hence (n_subdivisions + 1)^dim
   * points, x fastest. Each patch has 2^dim vertices in deal.II's order and
   * `data(component, point)`. A vector takes spacedim consecutive components.
   * Patches of dim 0 are points in space. Adjacent patches share no points, so
   * jumps stay visible.
   *
   *   @code
   *     io::FieldOutput<dim> output({{"density", "kg/m^3"},
   *                                  {"velocity", "m/s", true}});
   *     for (...)
   *       output.add_patch(std::move(patch));
   *     return output.write_vtu(folder, "fields", index, communicator);
   *   @endcode
   */
  template <int dim, int spacedim = dim>
  class FieldOutput : public dealii::DataOutInterface<dim, spacedim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim, spacedim>;

    explicit FieldOutput(const std::vector<FieldName> &names);

    /// Number of components of all fields: rows of Patch::data.
    unsigned int n_components() const;

    /// Creates a patch of the right size; set its vertices and data. With
    /// @p has_points, set the spacedim coordinates of all points [m] instead of
    /// the vertices, in the rows of data after those of the fields.
    Patch make_patch(unsigned int n_subdivisions,
                     bool has_points = false) const;

    /// Adds a patch; neighbours and patch index need not be set.
    void add_patch(Patch &&patch);

    /// Calls write_vtu() or write_hdf5(), depending on @p format, the value of
    /// "Field format".
    std::string write(const std::string &format,
                      const std::string &folder,
                      const std::string &stem,
                      unsigned int index,
                      double time,
                      MPI_Comm communicator);

    /**
     * Writes `stem_0012.0003.vtu`, one piece per rank with patches, and
     * `stem_0012.pvtu`; on a single rank `stem_0012.vtu` only. Arrays have
     * their units, for ParaView and for others. Collective.
     * @return name of the file to open, without folder
     * @throws SystemError when the disk is full; the piece is then removed
     */
    std::string write_vtu(const std::string &folder,
                          const std::string &stem,
                          unsigned int index,
                          MPI_Comm communicator);

    /**
     * Writes `stem_0012.h5` (double precision) and `stem_0012.xdmf`, for dim 2
     * and 3. Collective. Returns the name of the XDMF file.
     * @param time simulated time in the XDMF file [s]
     * @throws InputError for dim 0 and 1
     * @throws SystemError when the disk is full
     */
    std::string write_hdf5(const std::string &folder,
                           const std::string &stem,
                           unsigned int index,
                           double time,
                           MPI_Comm communicator);

  protected:
    const std::vector<Patch> &get_patches() const override;
    std::vector<std::string> get_dataset_names() const override;

    using Range = std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>;
    std::vector<Range> get_nonscalar_data_ranges() const override;

  private:
    void write_hdf5_files(const std::string &folder,
                          const std::string &name,
                          double time,
                          MPI_Comm writers);

    std::vector<FieldName> names_;
    std::vector<Patch> patches_;
  };
} // namespace io
} // namespace contrecoup
