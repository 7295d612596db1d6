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
 * Conserved quantities of all owned and ghost leaves of this rank, in the
 * three copies that a Runge-Kutta step needs, and one sensor value per leaf,
 * in the precision of the layout. Functions with a template argument require
 * that precision; the others convert to double.
 */
class GasField
{
public:
  /// Allocates @p n_batches batches, set to zero.
  void reinit(const LeafLayout &layout, const unsigned int n_batches);

  const LeafLayout &layout() const
  {
    return layout_;
  }

  /// Current state; see LeafLayout.
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
  /// State of Runge-Kutta stage @p i, 0 or 1.
  template <typename Real = double>
  Real *stage(const unsigned int i)
  {
    return copies<Real>().states[1 + i].data();
  }
  /// Makes stage @p i the current state.
  void accept_stage(const unsigned int i);

  /// Copies the current state and sensors of a batch to both stages.
  void copy_to_stages(const unsigned int batch);

  /// Sensor of each leaf for the current state.
  template <typename Real = double>
  Real *sensors()
  {
    return copies<Real>().sensors[0].data();
  }
  template <typename Real = double>
  Real *stage_sensors(const unsigned int i)
  {
    return copies<Real>().sensors[1 + i].data();
  }

  /// Sensor of one leaf for the current state.
  double sensor_of(const unsigned int leaf) const;

  /// Value of one leaf in the current state.
  double value(const unsigned int leaf,
               const unsigned int component,
               const unsigned int point) const;

  /// Values of double_width consecutive leaves; @p leaf, the first, is a
  /// multiple of double_width.
  Lanes<double> values(const unsigned int leaf,
                       const unsigned int component,
                       const unsigned int point) const;

  /// Reads and writes one leaf as [component][point].
  std::vector<double> leaf(const unsigned int leaf) const;
  void set_leaf(const unsigned int leaf, const std::vector<double> &values);

  /// Gives the current state room for @p n_batches batches of a changed octree,
  /// and keeps the state before as the former one until end_change(), which
  /// gives the stages the same room and sets all sensors to zero. In between,
  /// every owned leaf is to be written.
  void begin_change(const unsigned int n_batches);
  void end_change();
  /// Copies the former leaves @p former, one for each lane, to a batch.
  void copy_former_leaves(const unsigned int batch,
                          const std::vector<unsigned int> &former);
  /// One former leaf as [component][point].
  std::vector<double> former_leaf(const unsigned int leaf) const;

  /// Sets the programmed burn and the time [s] at which it is evaluated; null
  /// if nothing burns. Valid until reinit().
  void set_burn(const Burn *burn, const double time)
  {
    burn_ = burn;
    time_ = time;
  }
  /// Programmed burn; null if nothing burns.
  const Burn *burn() const
  {
    return burn_;
  }
  /// Time given to set_burn() [s].
  double time() const
  {
    return time_;
  }
  /// Burned fraction of a point at time(); one where there is no explosive.
  double burned(const unsigned int leaf, const unsigned int point) const
  {
    return burn_ == nullptr
             ? 1.
             : burn_->fraction(burn_->progress(leaf, point, time_),
                               value(leaf, 0, point));
  }
  /// Exerted pressure [Pa] of gas with pressure @p pressure after burning and
  /// burned fraction @p burned.
  double exerted_pressure(const double pressure, const double burned) const
  {
    return burn_ == nullptr ? pressure : burn_->pressure(pressure, burned);
  }

  /// Sets the open fractions around a rigid body; null without a body. Valid
  /// until the mesh changes.
  void set_open_fractions(const OpenFractions *open_fractions)
  {
    open_fractions_ = open_fractions;
  }
  /// Open fractions; null without a body.
  const OpenFractions *open_fractions() const
  {
    return open_fractions_;
  }
  /// Open fraction of a point's volume [-].
  double open_fraction(const unsigned int leaf, const unsigned int point) const
  {
    return open_fractions_ == nullptr ? 1. : (*open_fractions_)(leaf, point);
  }

  /// Fills padding lanes and unused ghosts with copies of leaf 0, a valid
  /// state.
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
  /// Calls @p function with the copies in the precision of the layout.
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

  /// One leaf of a copy of the state, as [component][point].
  std::vector<double> leaf_of_copy(const unsigned int copy,
                                   const unsigned int leaf) const;

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
    for (unsigned int lane = 0; lane < double_width; ++lane)
      result[lane] = copies.states[0][position + lane];
    return result;
  });
}
} // namespace contrecoup::gas
