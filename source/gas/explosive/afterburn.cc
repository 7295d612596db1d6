// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/explosive/afterburn.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/primitive.h>

#include <cmath>
#include <istream>
#include <ostream>

namespace contrecoup::gas
{
namespace
{
  /// Reference pressure of Miller's law, 1 Mbar [Pa], and its exponents of the
  /// remaining fuel and of the pressure.
  constexpr double reference_pressure = 1e11, fuel_exponent = 0.5,
                   pressure_exponent = 1. / 6.;

  /// Calls @p function(pointer to the conserved quantities, stride between
  /// components, volume) for each point that holds products.
  template <int dim, typename Function>
  void for_products(const LeafMesh<dim> &mesh,
                    const LeafPoints<dim> &points,
                    GasField &field,
                    const Function &function)
  {
    const LeafLayout &layout = field.layout();
    const std::size_t next = layout.value(1, 0);
    // On a box mesh in plane geometry, a point has the same fraction of the
    // volume of every leaf; elsewhere no table holds for all leaves.
    std::vector<double> fractions;
    if (points.exponent() == 0 && mesh.coarse_mesh().is_axis_aligned())
      for (unsigned int q = 0; q < layout.n_points; ++q)
        fractions.push_back(points.relative_volume(q));
    visit_precision(layout.precision, [&](const auto real) {
      auto *state = field.state<std::decay_t<decltype(real)>>();
      for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      {
        const LeafBox<dim> box = leaf_box(mesh, leaf);
        const double leaf_volume = fractions.empty() ? 1. : box.jacobian({});
        auto *u = state + layout.offset(leaf);
        for (unsigned int q = 0; q < layout.n_points; ++q, u += layout.width)
          if (u[Component<dim>::products * next] > 0.)
            function(u,
                     next,
                     fractions.empty() ? point_volume(box, points, q)
                                       : fractions[q] * leaf_volume);
      }
    });
  }

  /// Mass-weighted mean pressure of the products [Pa].
  template <int dim>
  double mean_pressure(const LeafMesh<dim> &mesh,
                       const LeafPoints<dim> &points,
                       const GasMaterial &material,
                       GasField &field)
  {
    using C = Component<dim>;
    // Densities of products below this fraction of the ambient density do not
    // affect the mean.
    const double negligible = 1e-6;
    std::vector<double> sums(2, 0.);
    for_products(
      mesh,
      points,
      field,
      [&](const auto *u, const std::size_t next, const double volume) {
        const double products = u[C::products * next];
        if (products < negligible)
          return;
        std::array<double, C::products + 1> values;
        for (unsigned int c = 0; c < values.size(); ++c)
          values[c] = u[c * next];
        const double pressure =
          primitive_state<dim>(values.data(), material).pressure;
        sums[0] += products * volume;
        sums[1] += products * volume * pressure;
      });
    dealii::Utilities::MPI::sum(sums, mesh.communicator(), sums);
    return sums[0] > 0. ? sums[1] / sums[0] : 0.;
  }

  /// Entries of Miller's law.
  void declare_rate(ParameterHandler &prm)
  {
    const UsedWith used("Afterburn/Kind = miller");
    declare_double(prm,
                   "Rate",
                   "6500",
                   0.,
                   1e12,
                   "1/s",
                   "Rate a of fresh products at 1 Mbar; 6500 is the "
                   "value 0.0065 per microsecond of the literature.");
  }
} // namespace


void Afterburn::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Afterburn");
  declare_selection(prm,
                    "Kind",
                    "none",
                    {"none", "constant", "miller"},
                    "Whether the products release more energy as they burn in "
                    "air: not at all, at a constant rate, or by Miller's law.");
  declare_double(
    prm,
    "Energy",
    "3.5e6",
    0.,
    1e12,
    "J/kg",
    used_with("Afterburn/Kind not none",
              "Total energy released per kg of products; the default "
              "fits blasts of TNT and C-4 in free air; TNT with enough "
              "oxygen releases 1e7 (Schwer: 16.3 GJ/m^3)."));
  {
    const UsedWith used("Afterburn/Kind = constant");
    declare_double(prm,
                   "Start time",
                   "0",
                   0.,
                   bounds::time,
                   "s",
                   "Start of the afterburn, which waits until all "
                   "explosive has burned.");
    declare_double(prm,
                   "End time",
                   "4.4e-3",
                   0.,
                   bounds::time,
                   "s",
                   "Time when all energy has been released.");
  }
  declare_rate(prm);
}


void Afterburn::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Afterburn");
  const std::string kind = prm.get("Kind");
  kind_ = kind == "none"     ? Kind::none
          : kind == "miller" ? Kind::miller
                             : Kind::constant;
  energy_ = read_double(prm, "Energy");
  start_ = read_double(prm, "Start time");
  end_ = read_double(prm, "End time");
  rate_ = read_double(prm, "Rate");
  if (kind_ == Kind::constant && !(start_ < end_))
    throw InputError("Charges/Afterburn/End time must be after Start time");
}


double Afterburn::grown_fraction(const double time,
                                 const double step,
                                 const double pressure) const
{
  if (kind_ == Kind::constant)
    return std::min(std::max((time - start_) / (end_ - start_), fraction_), 1.);
  // Exact solution of the law at constant pressure: (1 - L)^(1 - m) falls
  // linearly to zero.
  const double growth =
    step * rate_ *
    std::pow(std::max(pressure, 0.) / reference_pressure, pressure_exponent);
  constexpr double power = 1. - fuel_exponent;
  const double fuel = 1. - fraction_;
  if (fuel <= 0.)
    return 1.;
  const double left = std::pow(fuel, power) - power * growth;
  return left <= 0. ? 1. : 1. - std::pow(left, 1. / power);
}


template <int dim>
bool Afterburn::release(const double time,
                        const double step,
                        const LeafMesh<dim> &mesh,
                        const LeafPoints<dim> &points,
                        const GasMaterial &material,
                        GasField &field)
{
  using C = Component<dim>;
  if (!active() || fraction_ == 1. || field.burn() != nullptr)
    return false;
  const double pressure =
    kind_ == Kind::miller ? mean_pressure(mesh, points, material, field) : 0.;
  const double grown = grown_fraction(time, step, pressure);
  const double energy_per_products = energy_ * (grown - fraction_);
  fraction_ = grown;
  if (!(energy_per_products > 0.))
    return false;
  double sum = 0.;
  for_products(mesh,
               points,
               field,
               [&](auto *u, const std::size_t next, const double volume) {
                 const double energy =
                   u[C::products * next] * energy_per_products;
                 u[C::energy * next] += energy;
                 sum += energy * volume;
               });
  released_ += dealii::Utilities::MPI::sum(sum, mesh.communicator());
  return true;
}


void Afterburn::save(std::ostream &stream) const
{
  stream.write(reinterpret_cast<const char *>(&fraction_), sizeof(fraction_));
  stream.write(reinterpret_cast<const char *>(&released_), sizeof(released_));
}


void Afterburn::load(std::istream &stream)
{
  stream.read(reinterpret_cast<char *>(&fraction_), sizeof(fraction_));
  stream.read(reinterpret_cast<char *>(&released_), sizeof(released_));
}


#define CONTRECOUP_INSTANTIATE(dim)                         \
  template bool Afterburn::release(const double,            \
                                   const double,            \
                                   const LeafMesh<dim> &,   \
                                   const LeafPoints<dim> &, \
                                   const GasMaterial &,     \
                                   GasField &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
