// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/hanging_group.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/state/gas_field.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

namespace contrecoup::gas
{
/**
 * Finds the leaves that no wave has reached, so that the scheme can skip them.
 * A leaf is quiet while all its points hold, bit for bit, the ambient state:
 * gas at rest, the same in all quiet leaves. If a batch and all leaves that it
 * reads are quiet, an update would reproduce its state, and the batch is
 * skipped. Leaves with unburned explosive are never quiet. Quiet leaves hold
 * the ambient state in all copies of the field. A leaf that has ceased to be
 * quiet becomes quiet again in reinit() at the earliest.
 */
template <int dim>
class QuietLeaves
{
public:
  /// Declares entry "Skip quiet leaves" of subsection "Method".
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// Reads that entry: whether quiet leaves are skipped.
  static bool parse_parameters(dealii::ParameterHandler &prm);

  /// @param enabled false: all batches are always computed
  QuietLeaves(const LeafMesh<dim> &mesh, const bool enabled);

  /**
   * Determines the ambient state (the uniform state at rest that fills most of
   * the volume) and the quiet leaves; copies these and their sensors to the
   * stages of @p field. Call after a change of mesh or state other than by a
   * time step. Collective.
   * @param driven leaves that are always computed because something other than
   * their neighbours acts on them: a boundary with a prescribed state, or a
   * source
   */
  void reinit(GasField &field, const std::vector<unsigned int> &driven);

  /// Removes the leaves found by find_woken_leaves() from the quiet ones, and
  /// the ghosts that are no longer quiet in @p state, whose ghosts must be up
  /// to date.
  template <typename Real>
  void update(const Real *state);
  void update(const GasField &field)
  {
    visit_precision(field.layout().precision, [&](const auto real) {
      update(field.state<std::decay_t<decltype(real)>>());
    });
  }

  /// update() for the state @p in that the next stage reads.
  template <typename Real>
  void begin_stage(const Real *in)
  {
    update(in);
    n_computed_ += n_active_leaves_;
    n_possible_ += mesh_.n_owned();
  }

  /// Whether the batch must be computed: it reads a leaf that is not quiet, or
  /// it contains a driven leaf.
  bool is_active(const unsigned int batch) const
  {
    return active_batch_[batch] != 0;
  }
  /// Whether an active batch has a leaf at this hanging face.
  bool is_active_face(const unsigned int hanging_face) const
  {
    return active_face_[hanging_face] != 0;
  }
  /// Whether an active batch has a leaf at a face of the group.
  bool is_active_group(const HangingGroup<dim> &group) const
  {
    return std::any_of(
      group.face.begin(),
      group.face.begin() + group.n_filled,
      [this](const unsigned int face) { return is_active_face(face); });
  }

  /// Finds leaves of an active batch that are not quiet in @p out, the result
  /// of the stage.
  template <typename Real>
  void find_woken_leaves(const unsigned int batch, const Real *out);

  /// Whether quiet leaves hold explosive products.
  bool have_products() const;

  bool is_quiet(const unsigned int leaf) const
  {
    return quiet_[leaf] != 0;
  }

  /// Leaf updates on this rank since construction: computed, and possible
  /// without skipping.
  double n_computed() const
  {
    return n_computed_;
  }
  double n_possible() const
  {
    return n_possible_;
  }

private:
  /// Bit pattern of a number in single or double precision.
  using Bits = std::uint64_t;
  using LaneBits = std::array<Bits, max_batch_width>;

  void find_readers();
  void find_ambient(const GasField &field);
  /// Sums the volumes of the uniform leaves at rest on this rank by state.
  template <typename Real>
  void sum_volumes(const GasField &field,
                   std::map<std::vector<Bits>, double> &volumes) const;
  template <typename Real>
  void find_quiet(const GasField &field);
  /// Per lane of a batch: zero if all points have the bits of the first point.
  template <typename Real>
  LaneBits differences(const Real *batch_values) const;
  /// Per lane of a batch: zero if all points hold the ambient state.
  template <typename Real>
  LaneBits deviations(const Real *batch_values) const;
  template <typename Real>
  bool ghost_is_quiet(const unsigned int ghost, const Real *in) const;
  void activate(const unsigned int batch);
  void activate_readers(const unsigned int leaf);

  const LeafMesh<dim> &mesh_;
  const bool enabled_;
  LeafLayout layout_;
  /// Ambient state by component; empty if there is none.
  std::vector<Bits> ambient_;
  std::vector<char> quiet_;        ///< per stored leaf
  std::vector<char> active_batch_; ///< per batch of owned leaves
  std::vector<char> active_face_;  ///< per hanging face
  unsigned int n_active_leaves_ = 0;
  std::vector<unsigned int> woken_;        ///< found in the current stage
  std::vector<unsigned int> quiet_ghosts_; ///< numbers of ghosts
  /// Batches that read a stored leaf, including its own batch.
  std::vector<unsigned int> readers_;
  std::vector<unsigned int> first_reader_;
  double n_computed_ = 0.;
  double n_possible_ = 0.;
};
} // namespace contrecoup::gas
