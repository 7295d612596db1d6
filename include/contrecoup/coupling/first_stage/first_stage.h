// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/first_stage/first_stage_parameters.h>
#include <contrecoup/gas/run/gas_simulation.h>

#include <functional>
#include <memory>

namespace contrecoup::coupling
{
/**
 * First stage of a blast, computed in fewer dimensions, as the scene sees it.
 * All functions are collective.
 * @tparam dim number of dimensions of the scene
 */
template <int dim>
class FirstStage
{
public:
  virtual ~FirstStage() = default;

  /// Solver of the first stage.
  virtual Simulation &simulation() = 0;

  /// History of the stage converted to that of the scene: totals over the
  /// scene's domain.
  /// @param ambient totals of the scene's domain filled with gas at rest [kg,
  /// J, kg of products]
  virtual std::vector<NamedValue>
  history(const std::array<double, 3> &ambient) = 0;

  /// Calls @p take with the number and the state of each of the positions that
  /// lies in the domain of the stage; the gas at the others is still at rest.
  virtual void for_each_place(
    const std::function<void(std::size_t, const gas::GasState<dim> &)>
      &take) = 0;

  /// Blast as predicted by the stage's plan, before its first step.
  struct Blast
  {
    double energy = 0.; ///< energy in full space [J], 0 if unknown
    /// Height of the centre if the stage is axisymmetric [m]
    double height = 0.;
    double non_ideal_fraction = 0.; ///< see gas::ModellingPlan
  };
  virtual Blast blast() = 0;

  /// Distance of the outermost disturbance from centre or axis [m].
  virtual double front() = 0;

  /// Whether unburned explosive is left.
  virtual bool is_burning() const = 0;

  /// Whether the stage that hands over to the scene has begun, so that
  /// profile() may be called.
  virtual bool is_ready() const = 0;

  /// Current state as a profile.
  virtual gas::ProfileData profile() = 0;
};


/**
 * Creates the first stage.
 * @param scene all entries; @p declare declares them
 * @param places positions at which the scene records the gas [m]
 */
template <int dim>
std::unique_ptr<FirstStage<dim>>
make_first_stage(const ParameterHandler &scene,
                 const std::function<void(ParameterHandler &)> &declare,
                 const FirstStageParameters &parameters,
                 const FirstStageLayout<dim> &plan,
                 const std::vector<dealii::Point<dim>> &places,
                 const MPI_Comm communicator);
} // namespace contrecoup::coupling
