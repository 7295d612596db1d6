// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/explosive/afterburn.h>
#include <contrecoup/gas/explosive/charge_set.h>
#include <contrecoup/gas/explosive/charge_volume.h>
#include <contrecoup/gas/state/primitive.h>
#include <contrecoup/materials/custom_explosive.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>

namespace contrecoup::gas
{
namespace
{
  /// Whether two charges overlap: whether a point of a grid through charge @p
  /// a lies well within both.
  template <int dim>
  bool overlap(const Charge<dim> &a, const Charge<dim> &b)
  {
    const dealii::QIterated<dim> grid(dealii::QMidpoint<1>(), 40);
    const auto [lower, upper] = a.bounds();
    const double touching = -1e-9 * a.smallest_size();
    for (const auto &x : grid.get_points())
    {
      dealii::Point<dim> point = lower;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] += x[d] * (upper[d] - lower[d]);
      if (a.signed_distance(point) < touching &&
          b.signed_distance(point) < touching)
        return true;
    }
    return false;
  }


  /// @throws InputError for afterburn that the explosive cannot have
  void check_afterburn_of(ParameterHandler &prm, const GasMaterial &material)
  {
    Afterburn afterburn;
    {
      const Section section(prm, "Charges");
      afterburn.parse_parameters(prm);
    }
    if (!afterburn.active() || !material.has_products())
      return;
    const Section section(prm, "Material");
    check_afterburn(
      read_explosive(prm), afterburn.energy_left(), "Charges/Afterburn/Energy");
  }
} // namespace


template <int dim>
void ChargeSet<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Charges");
  declare_double(prm,
                 "Detonation speed",
                 "0",
                 0.,
                 1e6,
                 "m/s",
                 "Speed of the detonation front in the explosive; 0: the "
                 "Chapman-Jouguet speed of the explosive's constants.");
  Afterburn::declare_parameters(prm);
  const Section charge(prm, "Charge *");
  Charge<dim>::declare_parameters(prm);
}


template <int dim>
void ChargeSet<dim>::parse_parameters(ParameterHandler &prm,
                                      const GasMaterial &material,
                                      const CoarseMesh<dim> &mesh)
{
  material_ = material;
  charges_.clear();
  names_ = item_names(prm, "Charges/Charge");
  check_afterburn_of(prm, material);
  if (names_.empty())
    return;
  if (!(material.reference_density() > 0.))
    throw InputError(
      "Charges: they need Material/Equation of state = jwl in air or "
      "jwl, with an explosive that holds energy");
  density_ = material.reference_density();
  energy_density_ = density_ * material.reference_energy();
  {
    const Section section(prm, "Material");
    description_ = describe_detonation(read_explosive(prm));
  }
  const Section section(prm, "Charges");
  const ChapmanJouguetState front = chapman_jouguet(material.explosive());
  speed_ = read_double(prm, "Detonation speed");
  if (speed_ == 0.)
    speed_ = front.detonation_speed;
  stiffness_ = 1. / (1. - density_ / front.density);
  for (const std::string &name : names_)
  {
    const Section charge(prm, "Charge " + name);
    charges_.emplace_back(
      prm, mesh.geometry(), density_, "Charges/Charge " + name);
  }
}


template <int dim>
void ChargeSet<dim>::check(const Scheme &scheme,
                           const InitialState<dim> &initial_state)
{
  if (charges_.empty())
    return;
  for (unsigned int i = 0; i < charges_.size(); ++i)
    for (unsigned int j = 0; j < charges_.size(); ++j)
      if (i != j && overlap(charges_[i], charges_[j]))
        throw InputError("Charges/Charge " + names_[i] + " and Charge " +
                         names_[j] + " overlap");
  if (scheme.kind != Scheme::Kind::finite_volume)
    throw InputError(
      "Charges: they burn with Method/Scheme = finite volume only");
  const dealii::Point<dim> origin;
  const GasState<dim> ambient = initial_state.value(origin);
  if (initial_state.distance_to_feature(origin) <
        std::numeric_limits<double>::max() ||
      ambient.velocity.norm() > 0.)
    throw InputError(
      "Charges: they need a gas that is uniform and at rest around "
      "them: Initial state/Kind = uniform without Velocity");
  ambient_pressure_ =
    material_.pressure(ambient.density,
                       material_.internal_energy_density(
                         ambient.density, ambient.pressure, ambient.products),
                       ambient.products);
}


template <int dim>
double ChargeSet<dim>::signed_distance(const dealii::Point<dim> &point) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto &charge : charges_)
    nearest = std::min(nearest, charge.signed_distance(point));
  return nearest;
}


template <int dim>
std::vector<std::string> ChargeSet<dim>::late_burns(const double end_time) const
{
  std::vector<std::string> lines;
  const dealii::QIterated<dim> grid(dealii::QMidpoint<1>(), 20);
  for (unsigned int i = 0; i < charges_.size(); ++i)
  {
    double first = std::numeric_limits<double>::infinity(), last = 0.;
    const auto [lower, upper] = charges_[i].bounds();
    for (const auto &x : grid.get_points())
    {
      dealii::Point<dim> point = lower;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] += x[d] * (upper[d] - lower[d]);
      if (charges_[i].signed_distance(point) > 0.)
        continue;
      const double time = charges_[i].arrival(point, speed_, 0.);
      first = std::min(first, time);
      last = std::max(last, time);
    }
    if (last > end_time)
      lines.push_back(
        "WARNING: Charges/Charge " + names_[i] + " burns from " + brief(first) +
        " s to " + brief(last) + " s, but the run ends at Time/End time = " +
        brief(end_time) + " s: " + (first > end_time ? "all" : "a part") +
        " of it stays unburned; see Ignition times");
  }
  return lines;
}


template <int dim>
std::optional<double> ChargeSet<dim>::arrival(const dealii::Point<dim> &point,
                                              const double max_distance,
                                              const double lead) const
{
  std::optional<double> first;
  for (const auto &charge : charges_)
    if (charge.signed_distance(point) < max_distance)
    {
      const double time = charge.arrival(point, speed_, lead);
      first = first ? std::min(*first, time) : time;
    }
  return first;
}


template <int dim>
std::vector<std::string> ChargeSet<dim>::fill(const LeafMesh<dim> &mesh,
                                              const LeafPoints<dim> &points,
                                              GasField &field) const
{
  using C = Component<dim>;
  const LeafLayout &layout = field.layout();
  std::vector<std::string> report;
  std::vector<double> filled(std::size_t(mesh.n_owned()) * layout.n_points, 0.);
  for (unsigned int i = 0; i < charges_.size(); ++i)
  {
    const ChargeVolume volume = charge_volume(charges_[i], mesh, points);
    for (const auto &contribution : volume.contributions)
      filled[std::size_t(contribution.leaf) * layout.n_points +
             contribution.point] += contribution.fraction;
    report.push_back("Charge " + names_[i] + ": " +
                     brief(volume.total * density_, 8) + " kg in the domain" +
                     (volume.is_exact ? ""
                                      : ", which cuts it: as the cells "
                                        "sample it"));
    if (!(volume.total > 0.))
      throw InputError("Charges/Charge " + names_[i] +
                       " lies outside of the domain");
  }

  double fullest = 0.;
  visit_precision(layout.precision, [&](const auto real) {
    auto *state = field.state<std::decay_t<decltype(real)>>();
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      for (unsigned int q = 0; q < layout.n_points; ++q)
      {
        const double fraction = filled[std::size_t(leaf) * layout.n_points + q];
        fullest = std::max(fullest, fraction);
        if (fraction == 0.)
          continue;
        auto *u = state + layout.offset(leaf) + layout.value(0, q);
        const std::size_t next = layout.value(1, 0);
        for (unsigned int c = 0; c < layout.n_components; ++c)
          u[c * next] *= 1. - fraction;
        u[C::density * next] += fraction * density_;
        u[C::energy * next] += fraction * energy_density_;
        u[C::products * next] += fraction * density_;
      }
  });
  fullest = dealii::Utilities::MPI::max(fullest, mesh.communicator());
  if (fullest > 1. + 1e-6)
    throw InputError("Charges: they overlap; together they need more than the "
                     "volume of a cell that they share");
  return report;
}


template class ChargeSet<1>;
template class ChargeSet<2>;
template class ChargeSet<3>;
} // namespace contrecoup::gas
