// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/state/gas_field.h>

#include <deal.II/base/parameter_handler.h>

#include <cstdint>
#include <map>
#include <vector>

namespace contrecoup::gas
{
/**
 * Knows which leaves no wave has reached. A leaf is quiet while all its
 * points hold, to the last bit, the ambient state: gas at rest, the same in
 * all quiet leaves. Where a batch and all leaves that it reads are quiet,
 * the schemes would write what is there already, and the batch is passed
 * over. Leaves with explosive that is still to burn are never quiet. Quiet
 * leaves hold the ambient state in all copies of the field; a leaf that has
 * lost its quiet gets it back in reinit() at the earliest.
 */
template <int dim>
class QuietLeaves
{
public:
  /// Declares entry "Skip quiet leaves" of subsection "Method".
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// Reads it: whether quiet leaves are passed over.
  static bool parse_parameters(dealii::ParameterHandler &prm);

  /// @param enabled false: every batch is computed always
  QuietLeaves(const LeafMesh<dim> &mesh, const bool enabled);

  /**
   * Finds the ambient state, the uniform state at rest that fills most of
   * the volume, and the quiet leaves; copies them, and their sensors, to
   * the stages of @p field. Call when mesh or state were changed from
   * outside. Collective.
   * @param driven leaves that are always computed, because something other
   * than their neighbours acts on them: a boundary with a state of its own,
   * or a source
   */
  void reinit(GasField &field, const std::vector<unsigned int> &driven);

  /// Takes note of the leaves that the last stage woke, and of ghosts that
  /// are no longer quiet in @p state, whose ghosts are up to date.
  template <typename Real>
  void update(const Real *state);
  void update(const GasField &field)
  {
    visit_precision(field.layout().precision, [&](const auto real) {
      update(field.state<std::decay_t<decltype(real)>>());
    });
  }

  /// update() for the state that the next stage reads.
  template <typename Real>
  void begin_stage(const Real *in)
  {
    update(in);
    n_computed_ += n_active_leaves_;
    n_possible_ += mesh_.n_owned();
  }

  /// Whether the batch must be computed: it reads a leaf that is not quiet,
  /// or is driven.
  bool is_active(const unsigned int batch) const
  {
    return active_batch_[batch] != 0;
  }
  /// Whether an active batch meets this hanging face.
  bool is_active_face(const unsigned int hanging_face) const
  {
    return active_face_[hanging_face] != 0;
  }

  /// Looks for leaves of an active batch that are not quiet in @p out, the
  /// state that the stage wrote.
  template <typename Real>
  void find_woken_leaves(const unsigned int batch, const Real *out);

  /// Whether quiet leaves hold explosive products.
  bool have_products() const;

  bool is_quiet(const unsigned int leaf) const
  {
    return quiet_[leaf] != 0;
  }

  /// Leaves of this rank that stages computed, since construction, and
  /// those that they would have without quiet ones.
  double n_computed() const
  {
    return n_computed_;
  }
  double n_possible() const
  {
    return n_possible_;
  }

private:
  /// Bit patterns of numbers of either precision.
  using Bits = std::uint64_t;
  using LaneBits = std::array<Bits, max_batch_width>;

  void find_readers();
  void find_ambient(const GasField &field);
  /// Adds the volumes of the leaves at rest on this rank, by their state.
  template <typename Real>
  void sum_volumes(const GasField &field,
                   std::map<std::vector<Bits>, double> &volumes) const;
  template <typename Real>
  void find_quiet(const GasField &field);
  /// Per lane of a batch: zero where all points hold the first one's bits.
  template <typename Real>
  LaneBits differences(const Real *batch_values) const;
  /// Per lane: zero where all points hold the ambient state.
  template <typename Real>
  LaneBits deviations(const Real *batch_values) const;
  template <typename Real>
  bool ghost_is_quiet(const unsigned int ghost, const Real *in) const;
  void activate(const unsigned int batch);
  void activate_readers(const unsigned int leaf);

  const LeafMesh<dim> &mesh_;
  const bool enabled_;
  LeafLayout layout_;
  /// The ambient state by component; empty: there is none.
  std::vector<Bits> ambient_;
  std::vector<char> quiet_;        ///< per stored leaf
  std::vector<char> active_batch_; ///< per batch of owned leaves
  std::vector<char> active_face_;  ///< per hanging face
  unsigned int n_active_leaves_ = 0;
  std::vector<unsigned int> woken_;        ///< since the stage began
  std::vector<unsigned int> quiet_ghosts_; ///< numbers of ghosts
  /// Batches that read a stored leaf, its own among them.
  std::vector<unsigned int> readers_;
  std::vector<unsigned int> first_reader_;
  double n_computed_ = 0.;
  double n_possible_ = 0.;
};
} // namespace contrecoup::gas
