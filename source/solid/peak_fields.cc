// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/solid/peak_fields.h>
#include <contrecoup/solid/solid_probes.h>

#include <filesystem>
#include <sstream>
#include <unordered_map>

namespace contrecoup::solid
{
namespace
{
  /// The peaks of an element in a checkpoint.
  struct Record
  {
    std::uint32_t cell; ///< in the whole mesh
    std::array<float, 4> peaks;
  };

  std::string file_of(const std::string &folder, const unsigned int rank)
  {
    return folder + "/peaks." + std::to_string(rank) + ".bin";
  }
} // namespace


template <typename Real>
const std::array<std::string, PeakFields<Real>::n_fields>
  PeakFields<Real>::names{{"highest_pressure",
                           "lowest_pressure",
                           "largest_von_mises_stress",
                           "largest_principal_strain"}};


template <typename Real>
void PeakFields<Real>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Peaks");
  declare_bool(prm,
               "Active",
               "false",
               "Whether fields hold what each element went through: highest "
               "and lowest pressure, largest von Mises stress and principal "
               "strain, each by element and not averaged.");
  declare_integer(prm,
                  "Every steps",
                  "10",
                  1,
                  1000000,
                  "Steps from one look at the elements to the next; peaks "
                  "between are missed.");
}


template <typename Real>
void PeakFields<Real>::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Peaks");
  active_ = prm.get_bool("Active");
  interval_ = read_unsigned(prm, "Every steps");
}


template <typename Real>
void PeakFields<Real>::reinit(const SolidBody<Real> &body)
{
  for (std::vector<float> &field : fields_)
    field.assign(body.mesh().cells.size(), 0.F);
  n_steps_ = 0;
}


template <typename Real>
void PeakFields<Real>::follow(const SolidBody<Real> &body)
{
  if (++n_steps_ % interval_ != 0)
    return;
  body.elements().visit(
    body.nodes(),
    body.times(),
    [&](const std::uint32_t cell, const ElementValues &element) {
      const auto pressure = static_cast<float>(pressure_of(element.stress));
      const auto raise = [cell](std::vector<float> &field, const double value) {
        field[cell] = std::max(field[cell], static_cast<float>(value));
      };
      raise(fields_[0], pressure);
      fields_[1][cell] = std::min(fields_[1][cell], pressure);
      raise(fields_[2], von_mises(element.stress));
      raise(fields_[3], largest_principal(element.strain));
    });
}


template <typename Real>
void PeakFields<Real>::save(const SolidBody<Real> &body,
                            const std::string &folder) const
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(body.communicator());
  std::vector<Record> records;
  for (std::size_t i = 0; i < fields_[0].size(); ++i)
    records.push_back(
      {body.mesh().global_cell[i],
       {{fields_[0][i], fields_[1][i], fields_[2][i], fields_[3][i]}}});
  io::write_file(file_of(folder, rank), [&](std::ostream &out) {
    const std::uint64_t size = records.size();
    out.write(reinterpret_cast<const char *>(&n_steps_), sizeof(n_steps_));
    out.write(reinterpret_cast<const char *>(&size), sizeof(size));
    out.write(reinterpret_cast<const char *>(records.data()),
              static_cast<std::streamsize>(size * sizeof(Record)));
  });
}


template <typename Real>
void PeakFields<Real>::restore(const SolidBody<Real> &body,
                               const std::string &folder)
{
  reinit(body);
  std::unordered_map<std::uint32_t, std::size_t> here;
  for (std::size_t i = 0; i < body.mesh().cells.size(); ++i)
    here[body.mesh().global_cell[i]] = i;
  for (unsigned int rank = 0; std::filesystem::exists(file_of(folder, rank));
       ++rank)
  {
    std::istringstream in(io::read_file(file_of(folder, rank)));
    std::uint64_t size = 0;
    in.read(reinterpret_cast<char *>(&n_steps_), sizeof(n_steps_));
    in.read(reinterpret_cast<char *>(&size), sizeof(size));
    for (std::uint64_t i = 0; in && i < size; ++i)
    {
      Record record;
      in.read(reinterpret_cast<char *>(&record), sizeof(record));
      const auto found = here.find(record.cell);
      if (found != here.end())
        for (unsigned int k = 0; k < n_fields; ++k)
          fields_[k][found->second] = record.peaks[k];
    }
    if (!in)
      throw InputError("Checkpoint file " + file_of(folder, rank) +
                       " belongs to another scene");
  }
}


template class PeakFields<double>;
template class PeakFields<float>;
} // namespace contrecoup::solid
