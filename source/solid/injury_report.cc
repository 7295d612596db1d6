// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/numerics/head_injury.h>
#include <contrecoup/solid/injury_report.h>
#include <contrecoup/solid/solid_probes.h>
#include <contrecoup/solid/tissue_measures.h>

#include <deal.II/base/symmetric_tensor.h>

#include <filesystem>
#include <sstream>
#include <unordered_map>

namespace contrecoup::solid
{
namespace
{
  using dealii::Point;
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  constexpr std::uint32_t none = -1;

  template <typename Value>
  void put(std::ostream &out, const std::vector<Value> &values)
  {
    const std::uint64_t size = values.size();
    out.write(reinterpret_cast<const char *>(&size), sizeof(size));
    out.write(reinterpret_cast<const char *>(values.data()),
              static_cast<std::streamsize>(size * sizeof(Value)));
  }

  template <typename Value>
  void take(std::istream &in, std::vector<Value> &values)
  {
    std::uint64_t size = 0;
    in.read(reinterpret_cast<char *>(&size), sizeof(size));
    values.resize(in ? size : 0);
    in.read(reinterpret_cast<char *>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(Value)));
  }

  std::string file_of(const std::string &folder, const unsigned int rank)
  {
    return folder + "/injury." + std::to_string(rank) + ".bin";
  }
} // namespace


template <typename Real>
void InjuryReport<Real>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  declare_bool(prm,
               "Active",
               "false",
               "Whether strains and pressures of the brain, motion of the "
               "head and pressure on the chest are followed for injury.csv.");
  declare_selection(prm,
                    "Pressure",
                    "averaged",
                    peak_pressure_names(),
                    "In the brain: that of each element, or its average over "
                    "the corners and the elements around these, which removes "
                    "pressures that alternate from element to element and a "
                    "tenth of waves as short as ten elements.");
  declare_integer(prm,
                  "Every steps",
                  "10",
                  1,
                  1000000,
                  "Steps from one look at the body to the next; peaks between "
                  "are missed.");
  ChestInjury::declare_parameters(prm);
}


template <typename Real>
void InjuryReport<Real>::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  active_ = prm.get_bool("Active");
  averaged_ = prm.get("Pressure") == peak_pressure_names()[0];
  interval_ = read_unsigned(prm, "Every steps");
  chest_.parse_parameters(prm);
}


template <typename Real>
void InjuryReport<Real>::reinit(const SolidBody<Real> &body)
{
  const SolidMesh &mesh = body.mesh();
  brain_ = static_cast<unsigned int>(
    std::find(mesh.tissues.begin(), mesh.tissues.end(), Tissue::brain) -
    mesh.tissues.begin());
  average_.reinit(mesh, body.exchange(), brain_);
  piece_of_cell_.assign(mesh.cells.size(), none);
  pieces_.clear();
  for (const std::uint32_t cell : average_.cells())
  {
    piece_of_cell_[cell] = static_cast<std::uint32_t>(pieces_.size());
    BrainPiece piece;
    piece.cell = mesh.global_cell[cell];
    piece.volume = average_.volumes()[pieces_.size()];
    pieces_.push_back(piece);
  }
  chest_wall_.reinit(
    mesh, chest_.place(), chest_.radius(), body.communicator());
  last_time_ = body.time();
}


template <typename Real>
void InjuryReport<Real>::follow(const SolidBody<Real> &body)
{
  if (++n_steps_ % interval_ != 0)
    return;
  follow_brain(body, body.time() - last_time_);
  last_time_ = body.time();
  follow_head(body);
  chest_.follow(body.time(),
                body.loads().pressure_near(chest_.place(), body.communicator()),
                chest_wall_.inward_velocity(body.nodes()));
}


template <typename Real>
void InjuryReport<Real>::follow_brain(const SolidBody<Real> &body,
                                      const double span)
{
  std::vector<double> pressures(pieces_.size());
  body.elements().visit(
    body.nodes(),
    body.times(),
    [&](const std::uint32_t cell, const ElementValues &element) {
      const std::uint32_t i = piece_of_cell_[cell];
      pressures[i] = pressure_of(element.stress);
      pieces_[i].peak_strain =
        raised_to_principal(pieces_[i].peak_strain, element.strain);
    },
    brain_);
  const std::vector<double> averages = average_.average(pressures);
  for (std::size_t i = 0; i < pieces_.size(); ++i)
  {
    BrainPiece &piece = pieces_[i];
    const double weight = span * piece.volume;
    const double pressure = averaged_ ? averages[i] : pressures[i];
    piece.take_pressure(pressure);
    sums_.cavitation_dose += pressure < cavitation_pressure ? weight : 0.;
    const double rest = pressures[i] - averages[i];
    sums_.rough += weight * rest * rest;
    sums_.smooth += weight * averages[i] * averages[i];
  }
}


template <typename Real>
void InjuryReport<Real>::follow_head(const SolidBody<Real> &body)
{
  // Moments of the brain, each of its elements a mass in its middle.
  std::vector<double> sums(16, 0.);
  const SolidMesh &mesh = body.mesh();
  for (std::size_t i = 0; i < pieces_.size(); ++i)
  {
    const double mass = pieces_[i].volume;
    Tensor<1, 3> place, velocity;
    for (const std::uint32_t node : mesh.cells[average_.cells()[i]])
      for (unsigned int d = 0; d < 3; ++d)
      {
        place[d] += (mesh.nodes[node][d] +
                     double(body.nodes().displacement_of(node)[d])) /
                    8.;
        velocity[d] += double(body.nodes().velocity_of(node)[d]) / 8.;
      }
    const Tensor<1, 3> spin = cross_product_3d(place, velocity);
    sums[0] += mass;
    for (unsigned int d = 0; d < 3; ++d)
    {
      sums[1 + d] += mass * place[d];
      sums[4 + d] += mass * velocity[d];
      sums[7 + d] += mass * spin[d];
      sums[10 + d] += mass * place[d] * place[d];
      sums[13 + d] += mass * place[d] * place[(d + 1) % 3];
    }
  }
  dealii::Utilities::MPI::sum(sums, body.communicator(), sums);
  if (!(sums[0] > 0.))
    return;
  for (unsigned int i = 1; i < sums.size(); ++i)
    sums[i] /= sums[0];
  const Tensor<1, 3> centre = Point<3>(sums[1], sums[2], sums[3]);
  const Tensor<1, 3> velocity = Point<3>(sums[4], sums[5], sums[6]);
  const Tensor<1, 3> spin =
    Point<3>(sums[7], sums[8], sums[9]) - cross_product_3d(centre, velocity);
  SymmetricTensor<2, 3> inertia;
  double square = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int e = (d + 1) % 3;
    const double own = sums[10 + d] - centre[d] * centre[d];
    square += own;
    inertia[d][d] = -own;
    inertia[d][e] = -(sums[13 + d] - centre[d] * centre[e]);
  }
  for (unsigned int d = 0; d < 3; ++d)
    inertia[d][d] += square;
  const Tensor<1, 3> rate = invert(inertia) * spin;
  for (unsigned int d = 0; d < 3; ++d)
    largest_spin_[d] = std::max(largest_spin_[d], std::abs(rate[d]));
  times_.push_back(body.time());
  speeds_.push_back({{velocity[0], velocity[1], velocity[2]}});
}


template <typename Real>
std::vector<InjuryMeasure>
InjuryReport<Real>::measures(const SolidBody<Real> &body) const
{
  std::vector<InjuryMeasure> list;
  add_brain(body, list);
  add_head(list);
  const auto &tissues = body.mesh().tissues;
  if (std::find(tissues.begin(), tissues.end(), Tissue::lung) != tissues.end())
    for (const InjuryMeasure &measure : chest_.measures())
      list.push_back(measure);
  return list;
}


template <typename Real>
void InjuryReport<Real>::add_brain(const SolidBody<Real> &body,
                                   std::vector<InjuryMeasure> &list) const
{
  for (const InjuryMeasure &measure :
       brain_measures(pieces_, sums_, body.communicator()))
    list.push_back(measure);
}


template <typename Real>
void InjuryReport<Real>::add_head(std::vector<InjuryMeasure> &list) const
{
  if (times_.size() < 2)
    return;
  list.push_back(
    head_motion_measure(times_,
                        speeds_,
                        "the mean motion of the brain; made for impacts, not "
                        "blasts"));
  list.push_back({{"injury_bric", "-", brain_injury_criterion(largest_spin_)},
                  "1.0: half of injuries of degree 4 (Takhounts et al. 2013)",
                  "of the mean turning of the brain"});
}


template <typename Real>
void InjuryReport<Real>::save(const SolidBody<Real> &body,
                              const std::string &folder) const
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(body.communicator());
  io::write_file(file_of(folder, rank), [&](std::ostream &out) {
    put(out,
        std::vector<double>{double(n_steps_),
                            last_time_,
                            sums_.cavitation_dose,
                            sums_.rough,
                            sums_.smooth,
                            largest_spin_[0],
                            largest_spin_[1],
                            largest_spin_[2]});
    put(out, pieces_);
    put(out, times_);
    put(out, speeds_);
    put(out, chest_.times());
    put(out, chest_.pressures());
    put(out, chest_.wall_velocities());
  });
}


template <typename Real>
void InjuryReport<Real>::restore(const SolidBody<Real> &body,
                                 const std::string &folder)
{
  reinit(body);
  std::unordered_map<std::uint32_t, std::size_t> here;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    here[pieces_[i].cell] = i;
  const unsigned int own =
    dealii::Utilities::MPI::this_mpi_process(body.communicator());
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(body.communicator());
  for (unsigned int rank = 0; std::filesystem::exists(file_of(folder, rank));
       ++rank)
  {
    std::istringstream in(io::read_file(file_of(folder, rank)));
    std::vector<double> numbers;
    std::vector<BrainPiece> pieces;
    take(in, numbers);
    take(in, pieces);
    take(in, times_);
    take(in, speeds_);
    std::array<std::vector<double>, 3> chest;
    for (std::vector<double> &values : chest)
      take(in, values);
    if (!in || numbers.size() != 8)
      throw InputError("Checkpoint file " + file_of(folder, rank) +
                       " belongs to another scene");
    chest_.restore(
      std::move(chest[0]), std::move(chest[1]), std::move(chest[2]));
    n_steps_ = static_cast<std::uint64_t>(numbers[0]);
    last_time_ = numbers[1];
    // The sums of a rank go on at the rank of the same number, so that a run on
    // as many ranks as before adds in the same order.
    if (rank % n_ranks == own)
    {
      sums_.cavitation_dose += numbers[2];
      sums_.rough += numbers[3];
      sums_.smooth += numbers[4];
    }
    largest_spin_ = {{numbers[5], numbers[6], numbers[7]}};
    for (const BrainPiece &piece : pieces)
      if (here.count(piece.cell) > 0)
        pieces_[here[piece.cell]] = piece;
  }
}


template class InjuryReport<double>;
template class InjuryReport<float>;
} // namespace contrecoup::solid
