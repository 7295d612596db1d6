// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/ghost_exchange.h>
#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/state/burn.h>
#include <contrecoup/gas/state/open_fractions.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <tuple>
#include <vector>

namespace contrecoup::gas
{
/**
 * The conserved quantities of all leaves of this rank and its ghosts, in
 * the three copies that a Runge-Kutta step needs, and one sensor value for
 * each leaf; in the precision of the layout. Functions with a template
 * argument exist for that precision alone, the others convert.
 */
class GasField
{
public:
  /// Room for @p n_batches batches, zero.
  void reinit(const LeafLayout &layout, const unsigned int n_batches);

  const LeafLayout &layout() const
  {
    return layout_;
  }

  /// The current state; see LeafLayout.
  template <typename Real = double>
  Real *state()
  {
    return copies<Real>().states[0].data();
  }
  template <typename Real = double>
  const Real *state() const
  {
    return copies<Real>().states[0].data();
  }
  /// Room for stages, number 0 or 1.
  template <typename Real = double>
  Real *stage(const unsigned int i)
  {
    return copies<Real>().states[1 + i].data();
  }
  /// Makes stage @p i the current state.
  void accept_stage(const unsigned int i);

  /// Makes the stages' copies of a batch, and of its sensors, equal to the
  /// current ones.
  void copy_to_stages(const unsigned int batch);

  /// Sensor of each leaf, for the current state.
  template <typename Real = double>
  Real *sensor()
  {
    return copies<Real>().sensors[0].data();
  }
  template <typename Real = double>
  Real *stage_sensor(const unsigned int i)
  {
    return copies<Real>().sensors[1 + i].data();
  }

  /// Sensor of a leaf, for the current state.
  double sensor_of(const unsigned int leaf) const;

  /// A value of a leaf.
  double value(const unsigned int leaf,
               const unsigned int component,
               const unsigned int point) const;

  /// A value of W leaves from @p leaf on, a multiple of W.
  Lanes<double> values(const unsigned int leaf,
                       const unsigned int component,
                       const unsigned int point) const;

  /// Copies a leaf out as [component][point], and in.
  std::vector<double> leaf(const unsigned int leaf) const;
  void set_leaf(const unsigned int leaf, const std::vector<double> &values);

  /// Says what is still to burn at time @p time; null: nothing. Holds until
  /// reinit().
  void set_burn(const Burn *burn, const double time)
  {
    burn_ = burn;
    time_ = time;
  }
  /// Null where nothing is to burn.
  const Burn *burn() const
  {
    return burn_;
  }
  /// Time given to set_burn() [s].
  double time() const
  {
    return time_;
  }
  /// Burned fraction of a point now; one where there is no explosive.
  double burned(const unsigned int leaf, const unsigned int point) const
  {
    return burn_ == nullptr
             ? 1.
             : burn_->fraction(burn_->progress(leaf, point, time_),
                               value(leaf, 0, point));
  }
  /// The pressure that gas of pressure @p pressure exerts where @p burned of
  /// it has burned [Pa].
  double exerted_pressure(const double pressure, const double burned) const
  {
    return burn_ == nullptr ? pressure : burn_->pressure(pressure, burned);
  }

  /// Says where a rigid body leaves less room for gas; null: nowhere. Holds
  /// until the mesh changes.
  void set_open_fractions(const OpenFractions *open_fractions)
  {
    open_fractions_ = open_fractions;
  }
  /// Null where there is no body.
  const OpenFractions *open_fractions() const
  {
    return open_fractions_;
  }
  /// The part of a point's volume that is gas [-].
  double open_fraction(const unsigned int leaf, const unsigned int point) const
  {
    return open_fractions_ == nullptr ? 1. : (*open_fractions_)(leaf, point);
  }

  /// Makes padding lanes and unused ghosts copies of leaf 0: valid states.
  void fill_padding(const unsigned int n_owned);

  std::size_t memory() const;

private:
  template <typename Real>
  struct Copies
  {
    std::array<dealii::AlignedVector<Real>, 3> states;
    std::array<dealii::AlignedVector<Real>, 3> sensors;
  };

  template <typename Real>
  Copies<Real> &copies()
  {
    Assert(precision_of<Real> == layout_.precision, dealii::ExcInternalError());
    return std::get<Copies<Real>>(copies_);
  }
  template <typename Real>
  const Copies<Real> &copies() const
  {
    Assert(precision_of<Real> == layout_.precision, dealii::ExcInternalError());
    return std::get<Copies<Real>>(copies_);
  }
  /// Calls @p function with the copies that are in use.
  template <typename Function>
  decltype(auto) visit(const Function &function)
  {
    return visit_precision(layout_.precision, [&](const auto real) {
      return function(copies<std::decay_t<decltype(real)>>());
    });
  }
  template <typename Function>
  decltype(auto) visit(const Function &function) const
  {
    return visit_precision(layout_.precision, [&](const auto real) {
      return function(copies<std::decay_t<decltype(real)>>());
    });
  }

  LeafLayout layout_;
  const Burn *burn_ = nullptr;
  double time_ = 0.;
  const OpenFractions *open_fractions_ = nullptr;
  std::tuple<Copies<double>, Copies<float>> copies_;
};


inline double GasField::value(const unsigned int leaf,
                              const unsigned int component,
                              const unsigned int point) const
{
  const std::size_t position =
    layout_.offset(leaf) + layout_.value(component, point);
  return visit(
    [&](const auto &copies) -> double { return copies.states[0][position]; });
}


inline Lanes<double> GasField::values(const unsigned int leaf,
                                      const unsigned int component,
                                      const unsigned int point) const
{
  const std::size_t position =
    layout_.offset(leaf) + layout_.value(component, point);
  return visit([&](const auto &copies) {
    Lanes<double> result;
    for (unsigned int lane = 0; lane < W; ++lane)
      result[lane] = copies.states[0][position + lane];
    return result;
  });
}
} // namespace contrecoup::gas
