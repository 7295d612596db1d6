// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/classical_fields.h>
#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/conditions/layer_fields.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/gas/conditions/table_profile.h>
#include <contrecoup/materials/custom_explosive.h>
#include <contrecoup/numerics/exact/detonation_solution.h>
#include <contrecoup/numerics/exact/exact_riemann.h>
#include <contrecoup/numerics/exact/noh_solution.h>
#include <contrecoup/numerics/exact/point_source.h>
#include <contrecoup/numerics/exact/sedov_solution.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
const std::vector<std::string> reference_solution_kinds{"none",
                                                        "initial",
                                                        "riemann",
                                                        "vortex",
                                                        "noh",
                                                        "sedov",
                                                        "point source",
                                                        "detonation",
                                                        "kingery bulmash",
                                                        "table"};

namespace
{
  template <int dim>
  using Field =
    std::function<GasState<dim>(const dealii::Point<dim> &, double)>;


  /// State of a radial flow around @p center in an otherwise uniform gas.
  template <int dim>
  GasState<dim> around(const dealii::Point<dim> &center,
                       const dealii::Point<dim> &point,
                       const RadialState &radial)
  {
    const double radius = point.distance(center);
    GasState<dim> state;
    state.density = radial.density;
    state.pressure = radial.pressure;
    if (radius > 0.)
      state.velocity = (point - center) * (radial.velocity / radius);
    return state;
  }


  double ideal_gamma(const GasMaterial &material, const std::string &kind)
  {
    if (!material.is_ideal())
      throw InputError("Reference: Kind = " + kind +
                       " needs an ideal gas as the material");
    return material.ideal().gamma();
  }


  template <int dim>
  Field<dim> sedov_field(const SedovField<dim> &problem, const double gamma)
  {
    const SedovSolution solution(
      problem.spreading, gamma, problem.ambient.density, problem.energy);
    return [=](const dealii::Point<dim> &point, const double time) {
      if (time <= 0.)
        return problem.value(point);
      const double radius = point.distance(problem.center);
      if (radius > solution.shock_radius(time))
        return problem.ambient;
      return around(problem.center, point, solution.value(radius, time));
    };
  }


  template <int dim>
  Field<dim> noh_field(const NohField<dim> &problem, const double gamma)
  {
    const NohSolution solution(
      problem.spreading, gamma, problem.ambient.density, problem.speed);
    return [=](const dealii::Point<dim> &point, const double time) {
      RadialState state = solution.value(point.distance(problem.center), time);
      // Ahead of the shock the small ambient pressure rises adiabatically.
      if (state.pressure == 0.)
        state.pressure =
          problem.ambient.pressure *
          std::pow(state.density / problem.ambient.density, gamma);
      return around(problem.center, point, state);
    };
  }


  /// Exact solution of a Riemann problem at the plane of @p problem.
  template <int dim>
  Field<dim> riemann_field(const RiemannField<dim> &problem,
                           const GasMaterial &material)
  {
    const auto side = [](const GasState<1> &state) {
      return RiemannState{
        state.density, state.velocity[0], state.pressure, state.products};
    };
    const ExactRiemann solution(
      side(problem.left()), side(problem.right()), material);
    return [=](const dealii::Point<dim> &point, const double time) {
      if (time <= 0.)
        return problem.value(point);
      const RiemannState state =
        solution.value(problem.distance(point, time) / time);
      GasState<1> seen_from_frame;
      // A vacuum is represented as gas of vanishing density with the velocity
      // of the solution.
      seen_from_frame.density = std::max(state.density, 1e-100);
      seen_from_frame.velocity[0] = state.velocity;
      seen_from_frame.pressure = state.pressure;
      seen_from_frame.products = state.products;
      return problem.in_space(seen_from_frame);
    };
  }


  template <int dim>
  using Arrivals = std::function<BlastMeasures(const dealii::Point<dim> &)>;


  template <int dim>
  Arrivals<dim> point_source(const SedovField<dim> &problem, const double gamma)
  {
    if (problem.spreading != 3)
      throw InputError("Reference: Kind = point source needs a domain in which "
                       "waves spread in 3 dimensions");
    if (std::abs(gamma - PointSourceSolution::gamma) > 1e-12)
      throw InputError(
        "Reference: Kind = point source has a table for gamma = " +
        brief(PointSourceSolution::gamma) + " alone, not " + brief(gamma, 8));
    const PointSourceSolution solution(
      problem.energy, problem.ambient.pressure, problem.ambient.density);
    return [=](const dealii::Point<dim> &point) {
      const double radius = point.distance(problem.center);
      BlastMeasures measures;
      measures.peak = solution.overpressure(radius);
      measures.arrival = solution.arrival_time(radius);
      return measures;
    };
  }


  void declare_equivalence(ParameterHandler &prm,
                           const std::string &quantity,
                           const std::string &what,
                           const std::string &of_c4)
  {
    declare_list(prm,
                 "TNT equivalence of " + quantity,
                 "",
                 0,
                 1,
                 1e-3,
                 100.,
                 "-",
                 "Mass of TNT that gives the same " + what +
                   ", per mass of charge; C-4: " + of_c4 +
                   " on average (TM 5-855-1, 1986). Empty: that of "
                   "Material/Explosive; 1 without explosive.");
  }


  void declare_kingery_bulmash(ParameterHandler &prm)
  {
    const Section section(prm, "Kingery Bulmash");
    const UsedWith used("Reference/Kind = kingery bulmash");
    declare_double(prm,
                   "Mass",
                   "1",
                   1e-12,
                   1e9,
                   "kg",
                   "Mass of the whole charge, also where planes of symmetry "
                   "bound the domain.");
    declare_list(prm,
                 "Center",
                 "0, 0, 0",
                 1,
                 3,
                 -bounds::length,
                 bounds::length,
                 "m",
                 "Centre of the charge, the origin of distances; coordinates "
                 "beyond the dimension are ignored.");
    declare_selection(prm,
                      "Burst",
                      "spherical",
                      KingeryBulmash::sets,
                      "Charge in free air, or on rigid ground after Kingery "
                      "and Bulmash or after Swisdak.");
    declare_equivalence(prm, "pressure", "peak and arrival", "1.37");
    declare_equivalence(prm, "impulse", "impulse and duration", "1.19");
  }


  /// Equivalences of the entries; empty ones are those of the explosive, and 1
  /// without any.
  TntEquivalence read_equivalence(ParameterHandler &prm,
                                  const GasMaterial &material)
  {
    TntEquivalence tnt{1., 1., true, ""};
    if (material.reference_density() > 0.)
    {
      const Section section(prm, "Material");
      tnt = read_explosive(prm).tnt;
    }
    const Section section(prm, "Reference");
    const Section tables(prm, "Kingery Bulmash");
    for (const auto &[quantity, value] : {std::pair{"pressure", &tnt.pressure},
                                          std::pair{"impulse", &tnt.impulse}})
      if (const auto given =
            read_list(prm, std::string("TNT equivalence of ") + quantity);
          !given.empty())
        *value = given[0];
    return tnt;
  }


  /// Reads the entries of declare_kingery_bulmash().
  template <int dim>
  Arrivals<dim> kingery_bulmash(ParameterHandler &prm,
                                const TntEquivalence &tnt)
  {
    const Section section(prm, "Kingery Bulmash");
    const auto numbers = read_list(prm, "Center");
    dealii::Point<dim> center;
    for (unsigned int d = 0; d < std::min<std::size_t>(dim, numbers.size());
         ++d)
      center[d] = numbers[d];
    const double mass = read_double(prm, "Mass");
    const std::string burst = prm.get("Burst");
    const KingeryBulmash of_pressure(burst, mass * tnt.pressure);
    const KingeryBulmash of_impulse(burst, mass * tnt.impulse);
    return [=](const dealii::Point<dim> &point) {
      const double distance = point.distance(center);
      const auto known = [&](const KingeryBulmash &tables,
                             const BlastQuantity quantity) {
        return tables.covers(quantity, distance)
                 ? tables.value(quantity, distance)
                 : 0.;
      };
      BlastMeasures measures;
      measures.peak = known(of_pressure, BlastQuantity::overpressure);
      measures.arrival = known(of_pressure, BlastQuantity::arrival);
      measures.impulse = known(of_impulse, BlastQuantity::impulse);
      measures.duration = known(of_impulse, BlastQuantity::duration);
      return measures;
    };
  }


  /// Detonation from the origin into gas at rest: the state of @p
  /// initial_state with the density @p density of the explosive.
  template <int dim>
  Field<dim>
  detonation_field(const DetonationSolution &solution,
                   const std::shared_ptr<InitialState<dim>> &initial_state,
                   const double density)
  {
    return [=](const dealii::Point<dim> &point, const double time) {
      const dealii::Point<dim> origin;
      const double radius = point.distance(origin);
      GasState<dim> state = initial_state->value(point);
      state.density = density;
      if (radius < solution.front().detonation_speed * time)
        state = around(origin, point, solution.value(radius / time));
      state.products = 1.;
      return state;
    };
  }


  template <int dim>
  Field<dim> table_field(const std::string &file)
  {
    const TableProfile table(file);
    return [=](const dealii::Point<dim> &point, const double) {
      const GasState<1> at = table.value(point[0]);
      GasState<dim> state;
      state.density = at.density;
      state.velocity[0] = at.velocity[0];
      state.pressure = at.pressure;
      state.products = at.products;
      return state;
    };
  }
} // namespace


template <int dim>
void ReferenceSolution<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Reference");
  declare_selection(prm,
                    "Kind",
                    "none",
                    reference_solution_kinds,
                    "Reference for the errors of the run: none, the initial "
                    "state itself, the exact solution of the initial state of "
                    "the same name, the point source that Initial state/Sedov "
                    "describes (at probes), the detonation of the Material's "
                    "explosive from the origin, the measurements that Kingery "
                    "and Bulmash fitted (at probes), or a table.");
  declare_bool(
    prm,
    "Measure errors",
    "true",
    used_with("Reference/Kind not none",
              "Whether the summary contains the errors against the "
              "reference; false if it only serves exact boundaries."));
  declare_file(
    prm,
    "Table",
    "",
    used_with("Reference/Kind = table",
              "CSV file with columns position [m] (along x, or the radius), "
              "density [kg/m^3], velocity [m/s], pressure [Pa] and "
              "optionally products [-]: the profile at the end time."));
  declare_kingery_bulmash(prm);
}


template <int dim>
void ReferenceSolution<dim>::parse_parameters(ParameterHandler &prm,
                                              const GasMaterial &material)
{
  std::string table;
  {
    const Section section(prm, "Reference");
    name_ = prm.get("Kind");
    table = prm.get("Table");
    measure_errors_ = prm.get_bool("Measure errors");
  }
  value_ = nullptr;
  arrival_ = nullptr;
  equivalence_.clear();
  if (name_ == "kingery bulmash")
  {
    const auto tnt = read_equivalence(prm, material);
    const Section section(prm, "Reference");
    arrival_ = kingery_bulmash<dim>(prm, tnt);
    if (tnt.pressure != 1. || tnt.impulse != 1.)
      equivalence_ = ", as " + in_words(tnt);
  }
  else if (name_ == "table")
    value_ = table_field<dim>(table);
  else if (name_ == "initial")
  {
    const auto initial = std::make_shared<InitialState<dim>>();
    initial->parse_parameters(prm, material);
    value_ = [=](const dealii::Point<dim> &point, const double) {
      return initial->value(point);
    };
  }
  else if (name_ == "detonation")
    parse_detonation(prm, material);
  else if (name_ != "none")
    parse_exact_solution(prm, material);
}


template <int dim>
void ReferenceSolution<dim>::parse_detonation(ParameterHandler &prm,
                                              const GasMaterial &material)
{
  if (!(material.reference_density() > 0.))
    throw InputError("Reference: Kind = detonation needs a Material with an "
                     "explosive, jwl or jwl in air");
  CoarseMesh<dim> mesh;
  mesh.parse_parameters(prm);
  const auto initial = std::make_shared<InitialState<dim>>();
  initial->parse_parameters(prm, material);
  const DetonationSolution solution(dim + radial_exponent(mesh.geometry()),
                                    material.explosive());
  value_ =
    detonation_field<dim>(solution, initial, material.reference_density());
  const auto front = solution.front();
  arrival_ = [=](const dealii::Point<dim> &point) {
    BlastMeasures measures;
    measures.peak = front.pressure - initial->value(point).pressure;
    measures.arrival = point.norm() / front.detonation_speed;
    return measures;
  };
}


template <int dim>
void ReferenceSolution<dim>::parse_exact_solution(ParameterHandler &prm,
                                                  const GasMaterial &material)
{
  CoarseMesh<dim> mesh;
  mesh.parse_parameters(prm);
  const Geometry geometry = mesh.geometry();

  const Section section(prm, "Initial state");
  const std::string problem = (name_ == "point source") ? "sedov" : name_;
  if (prm.get("Kind") != problem)
    throw InputError("Reference: Kind = " + name_ +
                     " needs Initial state/Kind = " + problem);

  if (name_ == "riemann")
    value_ = riemann_field(RiemannField<dim>(prm, material), material);
  else if (name_ == "noh")
    value_ = noh_field(NohField<dim>(prm, material, geometry),
                       ideal_gamma(material, name_));
  else if (name_ == "sedov")
    value_ = sedov_field(SedovField<dim>(prm, material, geometry),
                         ideal_gamma(material, name_));
  else if (name_ == "point source")
    arrival_ = point_source(SedovField<dim>(prm, material, geometry),
                            ideal_gamma(material, name_));
  else if (name_ == "vortex")
  {
    const VortexField<dim> vortex(prm, material, geometry);
    value_ = [=](const dealii::Point<dim> &point, const double time) {
      return vortex.value(point, time);
    };
  }
}


template <int dim>
const std::string &ReferenceSolution<dim>::name() const
{
  return name_;
}


template <int dim>
bool ReferenceSolution<dim>::exists() const
{
  return static_cast<bool>(value_);
}


template <int dim>
bool ReferenceSolution<dim>::is_measured() const
{
  return exists() && measure_errors_;
}


template <int dim>
GasState<dim> ReferenceSolution<dim>::value(const dealii::Point<dim> &point,
                                            const double time) const
{
  return value_(point, time);
}


template <int dim>
bool ReferenceSolution<dim>::has_arrivals() const
{
  return static_cast<bool>(arrival_);
}


template <int dim>
BlastMeasures
ReferenceSolution<dim>::arrival(const dealii::Point<dim> &point) const
{
  return arrival_(point);
}


template class ReferenceSolution<1>;
template class ReferenceSolution<2>;
template class ReferenceSolution<3>;
} // namespace contrecoup::gas
