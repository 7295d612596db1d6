// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "oscillator.h"

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/field_output.h>

#include <cmath>
#include <csignal>
#include <new>
#include <sstream>

namespace contrecoup
{
namespace io
{
  Oscillator::Oscillator(const MPI_Comm communicator)
    : communicator_(communicator)
  {}

  void Oscillator::declare_parameters(ParameterHandler &prm)
  {
    {
      Section section(prm, "Output");
      declare_field_format(prm);
    }
    {
      Section section(prm, "Oscillator");
      declare_double(
        prm, "Mass", "1", 1e-300, unbounded, "kg", "The mass that swings.");
      declare_double(prm,
                     "Stiffness",
                     "1",
                     0.,
                     unbounded,
                     "N/m",
                     "Stiffness of the spring.");
      declare_double(prm,
                     "Damping",
                     "0.1",
                     0.,
                     unbounded,
                     "kg/s",
                     "Force of the damper over velocity.");
      declare_double(prm,
                     "Cells",
                     "1",
                     1.,
                     1e30,
                     "-",
                     "Cells that the cost estimate pretends to have.");
    }
    Section section(prm, "Mishap");
    declare_selection(prm,
                      "Kind",
                      "none",
                      {"none",
                       "numerics",
                       "input",
                       "memory",
                       "signal",
                       "not a number",
                       "no progress",
                       "deal.II",
                       "warning",
                       "far away"},
                      "What goes wrong.");
    declare_integer(prm,
                    "Step",
                    "0",
                    0,
                    1000000,
                    "Step in which it goes wrong; 0: in setup.");
    declare_integer(
      prm, "Rank", "-1", -1, 1000, "Rank on which it goes wrong; -1: on all.");
  }

  void Oscillator::parse_parameters(ParameterHandler &prm)
  {
    {
      Section section(prm, "Output");
      field_format_ = prm.get("Field format");
    }
    {
      Section section(prm, "Oscillator");
      mass_ = read_double(prm, "Mass");
      stiffness_ = read_double(prm, "Stiffness");
      damping_ = read_double(prm, "Damping");
      cells_ = read_double(prm, "Cells");
    }
    Section section(prm, "Mishap");
    mishap_ = prm.get("Kind");
    mishap_step_ = read_integer(prm, "Step");
    mishap_rank_ = read_integer(prm, "Rank");
  }

  CostEstimate Oscillator::estimate()
  {
    return {cells_, 2. * cells_, 1000., 16. * cells_, 1e-6 * cells_, 0., ""};
  }

  bool Oscillator::happens(const std::string &mishap) const
  {
    const int rank =
      static_cast<int>(dealii::Utilities::MPI::this_mpi_process(communicator_));
    return mishap_ == mishap && step_ == mishap_step_ &&
           (mishap_rank_ < 0 || mishap_rank_ == rank);
  }

  void Oscillator::setup()
  {
    if (happens("input"))
      throw InputError("the spring is\nbroken");
  }

  void Oscillator::restore(const std::string &folder)
  {
    std::istringstream input(read_file(folder + "/oscillator.bin"));
    input >> step_ >> time_ >> position_ >> velocity_ >> lost_;
  }

  void Oscillator::save(const std::string &folder)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
      write_file(folder + "/oscillator.bin", [&](std::ostream &out) {
        out.precision(17);
        out << step_ << ' ' << time_ << ' ' << position_ << ' ' << velocity_
            << ' ' << lost_ << '\n'
            << std::string(100000, '#');
      });
  }

  double Oscillator::time() const
  {
    return time_;
  }

  StepReport Oscillator::advance(const double largest_step)
  {
    ++step_;
    if (happens("numerics"))
      throw NumericsError("the mass left the room");
    if (happens("memory"))
      throw std::bad_alloc();
    if (happens("deal.II"))
      AssertThrow(false, dealii::ExcMessage("an assertion"));
    if (happens("signal"))
      std::raise(SIGTERM);
    if (happens("warning"))
      log_line("WARNING: the spring creaks");
    if (happens("not a number"))
      position_ = std::nan("");
    if (happens("no progress"))
      return {0., 0., 1};

    // The step depends on the state, as in a real solver.
    const double period = 2. * M_PI * std::sqrt(mass_ / stiffness_);
    const double dt =
      std::min(largest_step, period / (100. + 20. * position_ * position_));
    const double force = -stiffness_ * position_ - damping_ * velocity_;
    lost_ += dt * damping_ * velocity_ * velocity_;
    velocity_ += dt * force / mass_;
    position_ += dt * velocity_;
    time_ += dt;
    return {dt, 2., 0};
  }

  bool Oscillator::adapt()
  {
    return false;
  }

  std::vector<NamedValue> Oscillator::history()
  {
    return {{"mass", "kg", mass_, true},
            {"position", "m", position_},
            {"energy",
             "J",
             0.5 * mass_ * velocity_ * velocity_ +
               0.5 * stiffness_ * position_ * position_ + lost_,
             true}};
  }

  std::vector<NamedValue> Oscillator::probes()
  {
    return {{"mass position", "m", position_},
            {"mass velocity", "m/s", velocity_}};
  }

  std::vector<FieldFile> Oscillator::write_fields(const std::string &folder,
                                                  const unsigned int index)
  {
    FieldOutput<2> output({{"position", "m"}, {"velocity", "m/s", true}});
    if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
    {
      auto patch = output.make_patch(2);
      for (unsigned int v = 0; v < 4; ++v)
        patch.vertices[v] = dealii::Point<2>(v % 2, v / 2);
      for (unsigned int point = 0; point < 9; ++point)
      {
        patch.data(0, point) = static_cast<float>(position_);
        patch.data(1, point) = static_cast<float>(velocity_);
        patch.data(2, point) = 0.F;
      }
      output.add_patch(std::move(patch));
    }
    return {
      {"",
       output.write(
         field_format_, folder, "oscillator", index, time_, communicator_)}};
  }

  std::vector<NamedValue> Oscillator::errors()
  {
    const double rate = 0.5 * damping_ / mass_;
    const double frequency = std::sqrt(stiffness_ / mass_ - rate * rate);
    const double exact = std::exp(-rate * time_) *
                         (std::cos(frequency * time_) +
                          rate / frequency * std::sin(frequency * time_));
    return {{"position", "m", std::abs(position_ - exact)}};
  }

  std::vector<NamedValue> Oscillator::checks()
  {
    return {{"largest_angle", "-", std::nan("")}};
  }

  std::vector<Assumption> Oscillator::plan()
  {
    Assumption weight;
    weight.name = "weight";
    weight.decision = "left out";
    weight.quantity = "position of the mass";
    weight.unit = "m";
    weight.value = position_;
    if (mishap_ == "far away")
      weight.limit = 0.999;
    return {weight};
  }

  std::vector<Assumption> Oscillator::audit()
  {
    return plan();
  }

  std::pair<std::uint64_t, std::uint64_t> Oscillator::size() const
  {
    return {1, 2};
  }

  ApplicationDescription oscillator_application()
  {
    return {"oscillator",
            "A mass on a spring.",
            Oscillator::declare_parameters,
            [](ParameterHandler &prm, const MPI_Comm communicator) {
              auto oscillator = std::make_unique<Oscillator>(communicator);
              oscillator->parse_parameters(prm);
              return oscillator;
            },
            {"Mishap/"},
            {},
            {},
            [](const ParameterHandler &) { return field_files("oscillator"); }};
  }
} // namespace io
} // namespace contrecoup
