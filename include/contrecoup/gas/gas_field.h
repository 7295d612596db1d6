// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/burn.h>
#include <contrecoup/gas/ghost_exchange.h>
#include <contrecoup/gas/leaf_layout.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/// The conserved quantities of all leaves of this rank and its ghosts, in
/// the three copies that a Runge-Kutta step needs, and one sensor value for
/// each leaf.
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
  double *state()
  {
    return copies_[0].data();
  }
  const double *state() const
  {
    return copies_[0].data();
  }
  /// Room for stages, number 0 or 1.
  double *stage(const unsigned int i)
  {
    return copies_[1 + i].data();
  }
  /// Makes stage @p i the current state.
  void accept_stage(const unsigned int i)
  {
    copies_[0].swap(copies_[1 + i]);
    sensors_[0].swap(sensors_[1 + i]);
  }

  /// Sensor of each leaf, for the current state.
  double *sensor()
  {
    return sensors_[0].data();
  }
  const double *sensor() const
  {
    return sensors_[0].data();
  }
  double *stage_sensor(const unsigned int i)
  {
    return sensors_[1 + i].data();
  }

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
             : burn_->fraction(
                 burn_->progress(leaf, point, time_),
                 state()[layout_.offset(leaf) + layout_.value(0, point)]);
  }
  /// The pressure that gas of pressure @p pressure exerts where @p burned of
  /// it has burned [Pa].
  double exerted_pressure(const double pressure, const double burned) const
  {
    return burn_ == nullptr ? pressure : burn_->pressure(pressure, burned);
  }

  /// Makes padding lanes and unused ghosts copies of leaf 0: valid states.
  void fill_padding(const unsigned int n_owned);

  std::size_t memory() const;

private:
  LeafLayout layout_;
  const Burn *burn_ = nullptr;
  double time_ = 0.;
  std::array<dealii::AlignedVector<double>, 3> copies_;
  std::array<dealii::AlignedVector<double>, 3> sensors_;
};
} // namespace contrecoup::gas
