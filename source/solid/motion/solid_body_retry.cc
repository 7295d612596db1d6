// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/body/node_backup.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <cmath>
#include <sstream>

namespace contrecoup::solid
{
namespace
{
  /// Steps between copies of the state; so many keep the cost of copies below
  /// 1 %.
  constexpr std::size_t steps_between_copies = 500;

  /// Least volume of an element over its undeformed volume, and the least
  /// ratio of the most compressed element's volumes after and before a step.
  constexpr double least_allowed = 1e-3;
  constexpr double least_in_a_step = 0.8;
} // namespace


/// A copy of an earlier state, and the steps made since.
template <typename Real>
struct SolidBody<Real>::Snapshot
{
  NodeBackup<Real> nodes;
  HexMemory<Lanes<Real>> memory;
  std::vector<TissueEnergies> losses;
  Supports supports;
  SlipTies slip;
  double time, relaxed_time;
  StepTimes times;
  double external_work, nodal_work, step_change;
  std::vector<double> steps; ///< sizes of the steps since the copy [s]
};


template <typename Real>
void SolidBody<Real>::save_snapshot()
{
  if (!snapshot_)
    snapshot_ = std::make_shared<Snapshot>();
  snapshot_->nodes.save(nodes_);
  snapshot_->memory = operator_.batches();
  snapshot_->losses = operator_.losses();
  snapshot_->supports = supports_;
  snapshot_->slip = slip_;
  snapshot_->time = time_;
  snapshot_->relaxed_time = time_of_relaxed_strain_;
  snapshot_->times = times_;
  snapshot_->external_work = external_work_;
  snapshot_->nodal_work = nodal_work_;
  snapshot_->step_change = step_change_;
  snapshot_->steps.clear();
}


template <typename Real>
void SolidBody<Real>::restore_snapshot()
{
  snapshot_->nodes.restore(nodes_);
  static_cast<HexMemory<Lanes<Real>> &>(operator_.batches()) =
    snapshot_->memory;
  operator_.losses() = snapshot_->losses;
  supports_ = snapshot_->supports;
  slip_ = snapshot_->slip;
  time_ = snapshot_->time;
  time_of_relaxed_strain_ = snapshot_->relaxed_time;
  times_ = snapshot_->times;
  external_work_ = snapshot_->external_work;
  nodal_work_ = snapshot_->nodal_work;
  step_change_ = snapshot_->step_change;
  loads_.set_time(time_);
  for (const double step : snapshot_->steps)
    take_step(step);
  find_least_dilatations();
  save_snapshot();
}


template <typename Real>
void SolidBody<Real>::find_least_dilatations()
{
  least_dilatations_ = operator_.least_dilatations();
  dealii::Utilities::MPI::min(
    least_dilatations_, communicator_, least_dilatations_);
}


template <typename Real>
bool SolidBody<Real>::is_physical(const std::vector<double> &before) const
{
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!(1. + least_dilatations_[i] >
          std::max(least_allowed, least_in_a_step * (1. + before[i]))))
      return false;
  return true;
}


template <typename Real>
typename SolidBody<Real>::Advance
SolidBody<Real>::advance(const double step, const unsigned int largest_retries)
{
  if (!snapshot_ || snapshot_->steps.size() >= steps_between_copies)
    save_snapshot();
  const std::vector<double> before = least_dilatations_;
  Advance result{step, 0};
  for (;;)
  {
    take_step(result.step);
    find_least_dilatations();
    if (is_physical(before))
      break;
    if (result.retries >= largest_retries)
      throw_step_failure(result);
    restore_snapshot();
    result.step *= 0.5;
    ++result.retries;
  }
  snapshot_->steps.push_back(result.step);
  for (std::size_t i = 0; i < least_dilatations_.size(); ++i)
    least_volume_ = std::min(least_volume_, 1. + least_dilatations_[i]);
  return result;
}


template <typename Real>
void SolidBody<Real>::throw_step_failure(const Advance &failed)
{
  // Find the most compressed element; values that are not finite come first.
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t cell = 0;
  for (std::uint32_t i = 0; i < mesh_.elements.size(); ++i)
  {
    const double value = operator_.dilatation(i);
    const double dilatation = std::isfinite(value) ? value : -1e300;
    if (dilatation < least)
    {
      least = dilatation;
      cell = i;
    }
  }
  std::ostringstream text;
  if (!mesh_.elements.empty())
    describe(cell, text);
  restore_snapshot();
  if (!mesh_.elements.empty())
  {
    const ElementValues before = operator_.values(nodes_, times_, cell);
    text << "; before the step it had " << brief(1. + before.dilatation)
         << " of it, and the pressure "
         << brief(-(before.stress[0] + before.stress[1] + before.stress[2]) /
                  3.)
         << " Pa";
  }
  const auto values = gather_arrays(communicator_, std::vector<double>{least});
  const auto texts = gather_texts(communicator_, text.str());
  const auto found = std::min_element(values.begin(), values.end());
  std::ostringstream message;
  message << "The body turned unphysical at time " << time_
          << " s although the step was reduced to " << brief(failed.step)
          << " s; " << texts[found - values.begin()];
  throw NumericsError(message.str());
}


template <typename Real>
void SolidBody<Real>::describe(const std::uint32_t cell,
                               std::ostream &text) const
{
  dealii::Point<3> centre;
  for (const std::uint32_t node : mesh_.elements[cell])
    centre += mesh_.nodes[node] / 8.;
  text << "element " << mesh_.global_element[cell] << " of "
       << name_of(mesh_.tissues[mesh_.tissue[cell]]) << " at (" << centre
       << ") m would be left with " << brief(1. + operator_.dilatation(cell))
       << " of its volume, where more than " << brief(least_allowed)
       << ", and 0.8 of the least before, are allowed";
}


template <typename Real>
double SolidBody<Real>::compressed_step() const
{
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < least_dilatations_.size(); ++i)
  {
    const SolidMaterial &material = operator_.materials()[i];
    if (material.gas.exists() && i < element_steps_.size())
      step = std::min(
        step,
        element_steps_[i] /
          std::sqrt(std::max(1., material.stiffening(least_dilatations_[i]))));
  }
  return step;
}


template class SolidBody<double>;
template class SolidBody<float>;
} // namespace contrecoup::solid
