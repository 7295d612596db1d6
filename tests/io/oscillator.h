// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/io/application/application.h>

#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * A damped oscillator, the smallest solver there is: a mass on a spring,
   * stepped by a fraction of its period, with one cell as field. Its entries
   * make it misbehave in every way that a solver can.
   */
  class Oscillator : public Simulation
  {
  public:
    explicit Oscillator(MPI_Comm communicator);

    static void declare_parameters(dealii::ParameterHandler &prm);
    void parse_parameters(dealii::ParameterHandler &prm);

    CostEstimate estimate() override;
    void setup() override;
    void restore(const std::string &folder) override;
    void save(const std::string &folder) override;
    double time() const override;
    StepReport advance(double largest_step) override;
    bool adapt() override;
    std::vector<NamedValue> history() override;
    std::vector<NamedValue> probes() override;
    std::vector<FieldFile> write_fields(const std::string &folder,
                                        unsigned int index) override;
    std::vector<NamedValue> errors() override;
    std::vector<NamedValue> checks() override;
    std::vector<Assumption> plan() override;
    std::vector<Assumption> audit() override;
    std::pair<std::uint64_t, std::uint64_t> size() const override;

  private:
    bool happens(const std::string &mishap) const;

    MPI_Comm communicator_;
    double mass_ = 1.;
    double stiffness_ = 1.;
    double damping_ = 0.;
    double cells_ = 1.;
    std::string mishap_;
    std::string field_format_;
    int mishap_step_ = 0;
    int mishap_rank_ = -1;

    int step_ = 0;
    double time_ = 0.;
    double position_ = 1.;
    double velocity_ = 0.;
    double lost_ = 0.; ///< energy that the damper took
  };

  /// The application of this solver.
  ApplicationDescription oscillator_application();
} // namespace io
} // namespace contrecoup
