// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/timers.h>
#include <contrecoup/gas/finite_volume/make_finite_volume_operator.h>
#include <contrecoup/gas/octree/ghost_exchange.h>
#include <contrecoup/gas/stage/further_makers.h>
#include <contrecoup/gas/stepping/time_stepper.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
namespace
{
  /// The stepper of fields in the precision @p Real.
  template <int dim, typename Real>
  class PrecisionStepper : public TimeStepper<dim>
  {
  public:
    using typename TimeStepper<dim>::Rates;
    using typename TimeStepper<dim>::Result;

    PrecisionStepper(const OperatorContext<dim> &context,
                     const GasMaterial &material,
                     QuietLeaves<dim> &quiet_leaves)
      : mesh_(context.mesh)
      , scheme_(context.scheme)
      , operator_(
          scheme_.kind == Scheme::Kind::finite_volume
            ? make_finite_volume_operator<dim, Real>(context, material)
            : std::get<OperatorMaker<dim, Real>>(further_makers(
                "galerkin",
                "Method/Scheme = discontinuous galerkin"))(context, material))
      , quiet_leaves_(quiet_leaves)
    {}

    void reinit(GasField &field) override
    {
      operator_->reinit();
      exchange_.reinit(mesh_, field.layout());
      signal_rates_.resize(mesh_.first_ghost());
      compute_sensors(field);
      quiet_leaves_.reinit(field, operator_->driven_leaves());
      for (const unsigned int batch : operator_->closed_batches())
        field.copy_to_stages(batch);
    }

    void analyse(GasField &field) override
    {
      compute_sensors(field);
      if (quiet_leaves_.have_products())
        quiet_leaves_.reinit(field, operator_->driven_leaves());
    }

    void update_ghosts(GasField &field) override
    {
      exchange_.update(field.state<Real>(), field.sensors<Real>());
    }

    double signal_rate(const unsigned int leaf) const override
    {
      return signal_rates_[leaf];
    }

    double stable_step(const double rate) const override
    {
      return scheme_.cfl * scheme_.stability_limit() / rate;
    }

    Rates largest_rates(const std::vector<double> &size_ratios) const override;

    Result
    advance(GasField &field, const double time, const double step) override;

  private:
    void compute_sensors(GasField &field);
    /// @returns number of the stage copy that holds the result, or nothing
    /// when a state turned unphysical on any rank
    std::optional<unsigned int> try_step(GasField &field,
                                         const double time,
                                         const double step,
                                         const bool bound_velocity_slopes);
    /// Whether the scheme has slopes that Stage::bound_velocity_slopes bounds.
    bool can_bound_velocity_slopes() const
    {
      return scheme_.kind == Scheme::Kind::finite_volume &&
             scheme_.linear_reconstruction;
    }

    const LeafMesh<dim> &mesh_;
    const Scheme &scheme_;
    const std::unique_ptr<GasOperator<dim, Real>> operator_;
    GhostExchange<dim> exchange_;
    dealii::AlignedVector<Real> signal_rates_;
    QuietLeaves<dim> &quiet_leaves_;
    unsigned int unphysical_leaf_ = no_leaf;
    std::array<double, 6> wall_force_; ///< see Result
  };
  template <int dim, typename Real>
  void PrecisionStepper<dim, Real>::compute_sensors(GasField &field)
  {
    BasicStage<Real> stage;
    stage.results.state = field.state<Real>();
    stage.results.sensor = field.sensors<Real>();
    stage.results.signal_rate = signal_rates_.data();
    stage.burn = field.burn();
    stage.end_time = field.time();
    operator_->analyse(stage);
  }


  template <int dim, typename Real>
  typename PrecisionStepper<dim, Real>::Rates
  PrecisionStepper<dim, Real>::largest_rates(
    const std::vector<double> &size_ratios) const
  {
    std::vector<double> largest = {0., 0.};
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    {
      const double rate = signal_rates_[leaf];
      const double ratio = size_ratios.empty() ? 1. : size_ratios[leaf];
      largest[0] = std::max(largest[0], rate);
      largest[1] = std::max(largest[1], ratio * rate);
    }
    dealii::Utilities::MPI::max(largest, mesh_.communicator(), largest);
    return {largest[0], largest[1]};
  }


  template <int dim, typename Real>
  std::optional<unsigned int>
  PrecisionStepper<dim, Real>::try_step(GasField &field,
                                        const double time,
                                        const double step,
                                        const bool bound_velocity_slopes)
  {
    const auto &stages = scheme_.time_stepping.stages;
    Real *in = field.state<Real>();
    Real *sensor = field.sensors<Real>();
    unsigned int target = 0;
    unphysical_leaf_ = no_leaf;
    wall_force_.fill(0.);
    for (unsigned int s = 0; s < stages.size(); ++s)
    {
      {
        const TimerScope timer("ghost exchange");
        exchange_.update(in, sensor);
      }
      target = s % 2;
      BasicStage<Real> stage;
      stage.start = field.state<Real>();
      stage.in = in;
      stage.results.state = field.stage<Real>(target);
      stage.a = stages[s].initial_weight;
      stage.step = step;
      stage.time = time + stages[s].time * step;
      stage.end_time = time + step;
      stage.burn = field.burn();
      stage.sensor = sensor;
      stage.results.sensor = field.stage_sensors<Real>(target);
      stage.results.signal_rate =
        s + 1 == stages.size() ? signal_rates_.data() : nullptr;
      stage.bound_velocity_slopes = bound_velocity_slopes;
      stage.results.wall_force = &wall_force_;
      for (unsigned int later = s; later < stages.size(); ++later)
        stage.weight *= 1. - stages[later].initial_weight;
      stage.results.unphysical_leaf = &unphysical_leaf_;
      operator_->apply(stage, quiet_leaves_);
      if (operator_->redistributes())
      {
        exchange_.update(stage.results.state, stage.results.sensor);
        operator_->redistribute(stage, quiet_leaves_);
      }
      in = field.stage<Real>(target);
      sensor = field.stage_sensors<Real>(target);
    }
    // One agreement for all stages: later ones of a bad step do no harm.
    const bool is_bad = unphysical_leaf_ != no_leaf;
    if (dealii::Utilities::MPI::max(is_bad ? 1U : 0U, mesh_.communicator()) > 0)
      return {};
    return target;
  }


  template <int dim, typename Real>
  typename PrecisionStepper<dim, Real>::Result
  PrecisionStepper<dim, Real>::advance(GasField &field,
                                       const double time,
                                       const double step)
  {
    Result result;
    result.step = step;
    for (;;)
    {
      // First as accurate as the scheme is, then bounded, then shorter.
      auto target = try_step(field, time, result.step, false);
      result.bound_velocity_slopes = !target && can_bound_velocity_slopes();
      if (result.bound_velocity_slopes)
        target = try_step(field, time, result.step, true);
      if (target)
      {
        field.accept_stage(*target);
        result.wall_force = wall_force_;
        return result;
      }
      if (result.retries == scheme_.largest_retries)
      {
        result.failed = true;
        if (unphysical_leaf_ != no_leaf)
          result.unphysical_leaf = unphysical_leaf_;
        return result;
      }
      ++result.retries;
      result.step *= 0.5;
    }
  }


} // namespace


template <int dim>
std::unique_ptr<TimeStepper<dim>>
make_time_stepper(const OperatorContext<dim> &context,
                  const GasMaterial &material,
                  QuietLeaves<dim> &quiet_leaves)
{
  return visit_precision(
    context.layout.precision,
    [&](const auto real) -> std::unique_ptr<TimeStepper<dim>> {
      using Real = kernel_number<dim, std::decay_t<decltype(real)>>;
      return std::make_unique<PrecisionStepper<dim, Real>>(
        context, material, quiet_leaves);
    });
}


template std::unique_ptr<TimeStepper<1>>
make_time_stepper(const OperatorContext<1> &,
                  const GasMaterial &,
                  QuietLeaves<1> &);
template std::unique_ptr<TimeStepper<2>>
make_time_stepper(const OperatorContext<2> &,
                  const GasMaterial &,
                  QuietLeaves<2> &);
template std::unique_ptr<TimeStepper<3>>
make_time_stepper(const OperatorContext<3> &,
                  const GasMaterial &,
                  QuietLeaves<3> &);
} // namespace contrecoup::gas
