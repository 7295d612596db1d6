// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/first_stage/staged_simulation.h>
#include <contrecoup/gas/state/leaf_sampling.h>

namespace contrecoup::coupling
{
namespace
{
  using gas::GasSimulation;
  using gas::GasState;

  /// A position of the scene, by number, in the domain of the stage, and the
  /// unit vectors of the stage's directions there.
  template <int dim, int stage_dim>
  struct Probe
  {
    Probe(const std::size_t number,
          const dealii::Point<dim> &place,
          const dealii::Point<dim> &centre)
      : number(number)
    {
      dealii::Tensor<1, dim> radial = place - centre;
      if constexpr (stage_dim == 2)
      {
        radial[dim - 1] = 0.;
        this->place[1] = place[dim - 1];
        directions[1][dim - 1] = 1.;
      }
      this->place[0] = radial.norm();
      if (this->place[0] > 0.)
        directions[0] = radial / this->place[0];
    }

    std::size_t number;
    dealii::Point<stage_dim> place;
    std::array<dealii::Tensor<1, dim>, stage_dim> directions;
  };


  /// Gas solver with the dimension of the stage.
  template <int stage_dim>
  GasSimulation<stage_dim> &gas_of(GasSimulation<stage_dim> &solver)
  {
    return solver;
  }

  GasSimulation<2> &gas_of(StagedSimulation<2> &solver)
  {
    return solver.scene();
  }


  /// First stage of that solver, or null.
  template <int stage_dim>
  FirstStage<stage_dim> *stage_before(const GasSimulation<stage_dim> &)
  {
    return nullptr;
  }

  FirstStage<2> *stage_before(const StagedSimulation<2> &solver)
  {
    return solver.first_stage();
  }


  /// First stage computed in @p stage_dim dimensions.
  template <int dim, int stage_dim, typename Solver>
  class ReducedStage : public FirstStage<dim>
  {
  public:
    ReducedStage(const ParameterHandler &scene,
                 const std::function<void(ParameterHandler &)> &declare,
                 const FirstStageParameters &parameters,
                 const FirstStageLayout<dim> &plan,
                 const std::vector<dealii::Point<dim>> &places,
                 const MPI_Comm communicator)
      : plan_(plan)
      , solver_(communicator)
    {
      std::vector<dealii::Point<stage_dim>> in_stage;
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        const Probe<dim, stage_dim> probe(i, places[i], plan.centre);
        if (probe.place[0] > plan.domain_radius)
          continue;
        probes_.push_back(probe);
        in_stage.push_back(probe.place);
      }
      ParameterHandler prm;
      declare(prm);
      derive_first_stage<dim, stage_dim>(
        scene, parameters, plan, in_stage, prm);
      solver_.parse_parameters(prm);
    }

    Simulation &simulation() override
    {
      return solver_;
    }

    typename FirstStage<dim>::Blast blast() override
    {
      solver_.plan();
      const auto &plan = gas().modelling_plan();
      return {plan.energy, plan.centre[stage_dim - 1], plan.non_ideal_fraction};
    }

    double front() override
    {
      auto *const before = stage_before(solver_);
      return before != nullptr ? before->front()
                               : gas().disturbed_box().second[0];
    }

    bool is_burning() const override
    {
      auto *const before = stage_before(solver_);
      return before != nullptr ? before->is_burning()
                               : gas().core().is_burning();
    }

    bool is_ready() const override
    {
      return stage_before(solver_) == nullptr;
    }

    gas::ProfileData profile() override
    {
      return gas().profile();
    }

    void for_each_place(
      const std::function<void(std::size_t, const GasState<dim> &)> &take)
      override
    {
      const auto &states = gas().probe_set().states();
      for (std::size_t k = 0; k < probes_.size(); ++k)
      {
        GasState<dim> state;
        state.density = states[k].density;
        state.pressure = states[k].pressure;
        state.products = states[k].products;
        for (unsigned int i = 0; i < stage_dim; ++i)
          state.velocity += states[k].velocity[i] * probes_[k].directions[i];
        take(probes_[k].number, state);
      }
    }

    std::vector<NamedValue>
    history(const std::array<double, 3> &ambient) override
    {
      const auto own = own_ambient();
      const std::map<std::string, std::pair<double, double>> at_rest = {
        {"mass", {own[0], ambient[0]}},
        {"energy", {own[1], ambient[1]}},
        {"energy_before_afterburn", {own[1], ambient[1]}},
        {"products_mass", {own[2], ambient[2]}}};
      const auto values = solver_.history();
      std::vector<NamedValue> result;
      for (const NamedValue &value : values)
      {
        if (value.name == "momentum_x")
          add_momentum(values, result);
        if (value.name.rfind("momentum_", 0) == 0)
          continue;
        result.push_back(value);
        const auto found = at_rest.find(value.name);
        if (found != at_rest.end())
          result.back().value =
            found->second.second +
            plan_.domain_fraction * (value.value - found->second.first);
        else if (value.unit == "kg" || value.unit == "J")
          result.back().value = plan_.domain_fraction * value.value;
      }
      return result;
    }

  private:
    GasSimulation<stage_dim> &gas() const
    {
      return gas_of(solver_);
    }

    /// Mass [kg], energy [J] and mass of products [kg] of ambient gas in the
    /// whole domain of the stage.
    std::array<double, 3> own_ambient() const
    {
      const auto &mesh = gas().scene().coarse_mesh;
      const auto state = gas::conserved_state(
        gas().scene().ambient(), gas().scene().material, stage_dim + 3);
      const double radius = mesh.upper_corner()[0];
      double volume = 4. / 3. * dealii::numbers::PI * radius * radius * radius;
      if constexpr (stage_dim == 2)
        volume = dealii::numbers::PI * radius * radius *
                 (mesh.upper_corner()[1] - mesh.lower_corner()[1]);
      return {{volume * state[0],
               volume * state[stage_dim + 1],
               volume * state[stage_dim + 2]}};
    }

    /// Adds the momentum along each direction of the scene: the radial
    /// momentum integrated over the directions that planes through the centre
    /// leave.
    void add_momentum(const std::vector<NamedValue> &values,
                      std::vector<NamedValue> &result) const
    {
      std::array<double, 2> momentum{};
      for (const NamedValue &value : values)
        if (value.name == "momentum_x" || value.name == "momentum_y")
          momentum[value.name == "momentum_y"] = value.value;
      const std::array<const char *, 3> axes = {{"x", "y", "z"}};
      // Mean component of the unit vector over half of the directions.
      const double mean = stage_dim == 1 ? 0.5 : 2. / dealii::numbers::PI;
      for (unsigned int d = 0; d < dim; ++d)
      {
        NamedValue component{std::string("momentum_") + axes[d], "kg m/s", 0.};
        component.value =
          plan_.domain_fraction * plan_.side[d] * mean * momentum[0];
        if (dim == 2 && d == 0) // the scene's own radial direction
          component.value =
            plan_.domain_fraction * dealii::numbers::PI / 4. * momentum[0];
        if (stage_dim == 2 && d == dim - 1)
          component.value = plan_.domain_fraction * momentum[1];
        result.push_back(component);
      }
    }

    const FirstStageLayout<dim> plan_;
    std::vector<Probe<dim, stage_dim>> probes_; ///< within the stage's domain
    /// mutable because const queries call non-const functions of the solver.
    mutable Solver solver_;
  };
} // namespace


template <int dim>
std::unique_ptr<FirstStage<dim>>
make_first_stage(const ParameterHandler &scene,
                 const std::function<void(ParameterHandler &)> &declare,
                 const FirstStageParameters &parameters,
                 const FirstStageLayout<dim> &plan,
                 const std::vector<dealii::Point<dim>> &places,
                 const MPI_Comm communicator)
{
  if constexpr (dim == 3)
    if (parameters.kind == "axisymmetric")
    {
      if (parameters.spherical_cell_size > 0.)
        return std::make_unique<ReducedStage<dim, 2, StagedSimulation<2>>>(
          scene, declare, parameters, plan, places, communicator);
      return std::make_unique<ReducedStage<dim, 2, GasSimulation<2>>>(
        scene, declare, parameters, plan, places, communicator);
    }
  return std::make_unique<ReducedStage<dim, 1, GasSimulation<1>>>(
    scene, declare, parameters, plan, places, communicator);
}


#define CONTRECOUP_INSTANTIATE(dim)                           \
  template std::unique_ptr<FirstStage<dim>> make_first_stage( \
    const ParameterHandler &,                                 \
    const std::function<void(ParameterHandler &)> &,          \
    const FirstStageParameters &,                             \
    const FirstStageLayout<dim> &,                            \
    const std::vector<dealii::Point<dim>> &,                  \
    const MPI_Comm)

CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::coupling
