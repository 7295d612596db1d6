// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head_measures.h>
#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/io/checked_file.h>

#include <filesystem>
#include <sstream>
#include <unordered_map>

namespace contrecoup::ale
{
namespace
{
  constexpr unsigned int width = AleState::width;

  template <typename Value>
  void put(std::ostream &out, const std::vector<Value> &values)
  {
    const std::uint64_t size = values.size();
    out.write(reinterpret_cast<const char *>(&size), sizeof(size));
    out.write(reinterpret_cast<const char *>(values.data()),
              static_cast<std::streamsize>(size * sizeof(Value)));
  }

  /// @throws InputError for a list that is longer than the rest of the file
  template <typename Value>
  void take(std::istream &in, const std::string &file, std::vector<Value> &list)
  {
    std::uint64_t size = 0;
    in.read(reinterpret_cast<char *>(&size), sizeof(size));
    const auto rest = static_cast<std::uint64_t>(
      std::max<std::streamsize>(in.rdbuf()->in_avail(), 0));
    if (!in || size > rest / sizeof(Value))
      throw InputError("Checkpoint file " + file + " ends too early");
    list.resize(size);
    in.read(reinterpret_cast<char *>(list.data()),
            static_cast<std::streamsize>(size * sizeof(Value)));
  }

  std::string file_of(const std::string &folder, const unsigned int rank)
  {
    return folder + "/injury." + std::to_string(rank) + ".bin";
  }
} // namespace


void HeadMeasures::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  declare_string(prm,
                 "Brain",
                 "brain",
                 "Region whose strains and pressures are followed for "
                 "injury.csv, if there is one of this name.");
  declare_string(prm,
                 "Skull",
                 "skull",
                 "Region whose mean motion is followed for injury.csv, if "
                 "there is one of this name.");
  declare_integer(prm,
                  "Every steps",
                  "10",
                  1,
                  1000000,
                  "Steps from one look at the head to the next; peaks between "
                  "are missed.");
}


void HeadMeasures::parse_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Injury");
    brain_name_ = prm.get("Brain");
    skull_name_ = prm.get("Skull");
    interval_ = read_unsigned(prm, "Every steps");
  }
  const Section section(prm, "Mesh");
  if (prm.get("Kind") == "layered head")
    for (unsigned int d = 0; d < 3; ++d)
      is_mirrored_[d] =
        prm.get("Symmetry planes").find("xyz"[d]) != std::string::npos;
}


unsigned int HeadMeasures::find(const std::vector<Region> &regions,
                                const std::string &entry,
                                const std::string &name)
{
  for (unsigned int i = 0; i < regions.size(); ++i)
    if (regions[i].name == name)
    {
      if (regions[i].solid() == nullptr)
        throw InputError("Injury/" + entry + ": region \"" + name +
                         "\" is a fluid");
      return i;
    }
  return none;
}


void HeadMeasures::reinit(const HexSpace &space,
                          const LagrangeStep &lagrange,
                          const AleState &state,
                          const std::vector<Region> &regions)
{
  brain_ = find(regions, "Brain", brain_name_);
  skull_ = find(regions, "Skull", skull_name_);
  cells_.clear();
  pieces_.clear();
  for (std::uint32_t c = 0; c < space.n_own_cells(); ++c)
    if (space.region(c) == brain_)
    {
      cells_.push_back(c);
      solid::BrainPiece piece;
      piece.cell = space.cell_number(c);
      piece.volume = lagrange.values(state, c).volume;
      pieces_.push_back(piece);
    }
}


void HeadMeasures::follow(const HexSpace &space,
                          const LagrangeStep &lagrange,
                          const AleState &state)
{
  if (!active() || n_calls_++ % interval_ != 0)
    return;
  follow_brain(lagrange, state, state.time - last_time_);
  last_time_ = state.time;
  if (skull_ != none)
    follow_skull(space, state);
}


void HeadMeasures::follow_brain(const LagrangeStep &lagrange,
                                const AleState &state,
                                const double span)
{
  for (std::size_t i = 0; i < pieces_.size(); ++i)
  {
    const CellValues values = lagrange.values(state, cells_[i]);
    solid::BrainPiece &piece = pieces_[i];
    piece.peak_strain = std::max(piece.peak_strain, values.principal_strain);
    piece.take_pressure(values.pressure);
    if (values.pressure < solid::cavitation_pressure)
      sums_.cavitation_dose += span * piece.volume;
  }
}


void HeadMeasures::follow_skull(const HexSpace &space, const AleState &state)
{
  // Mass and momentum.
  std::vector<double> sums(4, 0.);
  for (std::size_t c = 0; c < space.n_own_cells(); ++c)
    if (space.region(c) == skull_)
    {
      sums[0] += state.mass[c];
      for (const std::uint32_t node : space.cell(c))
        for (unsigned int d = 0; d < 3; ++d)
          sums[1 + d] +=
            0.125 * state.mass[c] * state.velocity[width * node + d];
    }
  dealii::Utilities::MPI::sum(sums, space.communicator(), sums);
  std::array<double, 3> velocity{};
  for (unsigned int d = 0; d < 3; ++d)
    velocity[d] = is_mirrored_[d] ? 0. : sums[1 + d] / sums[0];
  times_.push_back(state.time);
  speeds_.push_back(velocity);
}


std::vector<solid::InjuryMeasure>
HeadMeasures::measures(const MPI_Comm communicator) const
{
  auto list = solid::brain_measures(pieces_, sums_, communicator);
  for (solid::InjuryMeasure &measure : list)
    if (measure.value.unit == "Pa")
      measure.limits += "; of single cells";
  if (times_.size() > 1)
    list.push_back(solid::head_motion_measure(
      times_,
      speeds_,
      "the mean motion of the skull, until the end of the run"));
  return list;
}


void HeadMeasures::save(const std::string &folder,
                        const MPI_Comm communicator) const
{
  if (!active())
    return;
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(communicator);
  io::write_file(file_of(folder, rank), [&](std::ostream &out) {
    put(
      out,
      std::vector<double>{double(n_calls_), last_time_, sums_.cavitation_dose});
    put(out, pieces_);
    put(out, times_);
    put(out, speeds_);
  });
}


void HeadMeasures::restore(const std::string &folder,
                           const MPI_Comm communicator)
{
  if (!active())
    return;
  std::unordered_map<std::uint32_t, std::size_t> here;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    here[pieces_[i].cell] = i;
  const unsigned int own =
    dealii::Utilities::MPI::this_mpi_process(communicator);
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(communicator);
  unsigned int rank = 0;
  do
  {
    const std::string file = file_of(folder, rank);
    std::istringstream in(io::read_file(file));
    std::vector<double> numbers;
    std::vector<solid::BrainPiece> pieces;
    take(in, file, numbers);
    take(in, file, pieces);
    take(in, file, times_);
    take(in, file, speeds_);
    if (numbers.size() != 3 || times_.size() != speeds_.size())
      throw InputError("Checkpoint file " + file + " belongs to another scene");
    n_calls_ = static_cast<std::uint64_t>(numbers[0]);
    last_time_ = numbers[1];
    // The sums of a rank go on at the rank of the same number, so that a run on
    // as many ranks as before adds in the same order.
    if (rank % n_ranks == own)
      sums_.cavitation_dose += numbers[2];
    for (const solid::BrainPiece &piece : pieces)
      if (here.count(piece.cell) > 0)
        pieces_[here[piece.cell]] = piece;
  } while (std::filesystem::exists(file_of(folder, ++rank)));
}
} // namespace contrecoup::ale
