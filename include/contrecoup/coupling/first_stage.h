// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/stage_parameters.h>
#include <contrecoup/gas/run/gas_simulation.h>

#include <memory>

namespace contrecoup::coupling
{
/**
 * The beginning of a blast in fewer dimensions, as the scene sees it. All
 * functions are collective.
 * @tparam dim dimensions of the scene
 */
template <int dim>
class FirstStage
{
public:
  virtual ~FirstStage() = default;

  /// The solver of the stage.
  virtual Simulation &simulation() = 0;

  /// The stage's history as that of the scene: totals over the scene's
  /// domain, to which @p ambient is what gas at rest would contribute
  /// [kg, J, kg of products].
  virtual std::vector<NamedValue>
  history(const std::array<double, 3> &ambient) = 0;

  /// The gas at the places of the scene's gauges.
  virtual std::vector<gas::GasState<dim>> gauges() = 0;

  /// The blast as the stage's plan knows it before its first step.
  struct Blast
  {
    double energy = 0.; ///< in full space [J], 0 if unknown
    double height = 0.; ///< of its centre if the stage is axisymmetric [m]
    double non_ideal_part = 0.; ///< see gas::ModellingPlan
  };
  virtual Blast blast() = 0;

  /// Distance of the outermost disturbance from centre or axis [m].
  virtual double front() = 0;

  /// Whether there is explosive that has not burned yet.
  virtual bool is_burning() const = 0;

  /// Whether it has the number of dimensions in which it hands over, so that
  /// there is a profile().
  virtual bool is_ready() const = 0;

  /// The state as a profile.
  virtual gas::ProfileData profile() = 0;
};


/**
 * The first stage that the parameters ask for.
 * @param scene all entries; @p declare declares them
 * @param gauges places of the scene's gauges
 */
template <int dim>
std::unique_ptr<FirstStage<dim>>
make_first_stage(const ParameterHandler &scene,
                 const std::function<void(ParameterHandler &)> &declare,
                 const StageParameters &parameters,
                 const StagePlan<dim> &plan,
                 const std::vector<dealii::Point<dim>> &gauges,
                 const MPI_Comm communicator);
} // namespace contrecoup::coupling
