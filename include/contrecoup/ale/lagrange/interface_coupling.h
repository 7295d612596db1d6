// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/region.h>
#include <contrecoup/ale/mesh/slip_walls.h>
#include <contrecoup/base/run/simulation.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// Coupling of fluids and solids at shared nodes.
enum class CouplingScheme
{
  monolithic,
  loose,
  fixed_relaxation,
  aitken
};

/// Course of the coupling. Plain data, written to checkpoints.
struct CouplingRecord
{
  std::uint64_t n_steps = 0;
  std::uint64_t n_iterations = 0;       ///< over all steps
  std::uint64_t last_iterations = 0;    ///< of the last step
  std::uint64_t largest_iterations = 0; ///< of any step
  double largest_ratio = 0.;            ///< largest m_f / m_s so far [-]
  double work = 0.;                     ///< spurious work at the interface [J]
  double factor = 0.; ///< initial relaxation factor of the next step (Aitken)
};

/**
 * Partitioned coupling of fluids and solids: subsection "Coupling".
 *
 * At an interface node with masses m_f and m_s and with forces F_f and F_s of
 * its fluid and solid cells, the monolithic scheme solves (m_s + m_f) a = F_s
 * + F_f. A partitioned scheme prescribes the interface acceleration a_k to the
 * fluid, and applies the fluid's force F_f - m_f a_k to the solid, which then
 * has the acceleration b_k:
 *
 *   m_s b_k = F_s + F_f - m_f a_k,   a_k+1 = a_k + w (b_k - a_k).
 *
 * Each iteration multiplies the error by 1 - w (1 + r), with the added mass
 * ratio r = m_f / m_s (Causin, Gerbeau and Nobile 2005; Foerster, Wall and
 * Ramm 2007). The loose scheme performs one iteration with the acceleration of
 * the previous step and w = 1. The other schemes iterate to convergence, with
 * constant w or with Aitken's (Irons and Tuck 1969; Kuettler and Wall 2008).
 * Fluids are compressible and steps explicit, so the added mass is that of the
 * cells at the interface only.
 *
 * The remaining imbalance (m_s + m_f) a - F_s - F_f does spurious work at the
 * interface.
 */
class InterfaceCoupling
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  void parse_parameters(dealii::ParameterHandler &prm);

  /// Sets the scheme without a parameter file.
  /// @param tolerance of accelerations, relative to those of the solid alone
  void set(const CouplingScheme scheme,
           const double relaxation,
           const double tolerance,
           const unsigned int largest_iterations);

  /// Whether the scheme is partitioned.
  bool active() const
  {
    return scheme_ != CouplingScheme::monolithic;
  }

  /// Whether the scheme is loose. Its error goes undetected.
  bool is_loose() const
  {
    return scheme_ == CouplingScheme::loose;
  }

  /// Name of the scheme in parameter files.
  const std::string &name() const;

  /// @param regions by material id of the mesh
  /// @throws InputError if a partitioned scheme has fluids and solids without
  /// common faces
  void require_interface(const dealii::Triangulation<3> &mesh,
                         const std::vector<Region> &regions) const;

  /**
   * Finds the interface nodes. Collective.
   * @param regions by material id of the mesh
   * @param walls interface nodes on walls iterate along the walls only
   * @throws InputError for fluids and solids that share no node
   */
  void reinit(const HexSpace &space,
              const std::vector<Region> &regions,
              const SlipWalls &walls);

  /**
   * Adds the imbalance of the scheme to the forces on interface nodes, so that
   * these nodes get the acceleration of the scheme.
   * @param velocity with inverse masses
   * @param is_first_half of a step; the second half starts from its result
   * @param force node_width numbers for each node [N]
   * @return whether the iteration converged. Collective.
   */
  bool balance(const dealii::AlignedVector<double> &velocity,
               const bool is_first_half,
               dealii::AlignedVector<double> &force);

  /// Whether the last balance() did not converge.
  bool has_diverged() const
  {
    return has_diverged_;
  }

  /// Text for the error message of a failed step: words to append, or a clause
  /// if the iteration diverged. Collective.
  std::string failure_text() const;

  /// Completes the step of the last balance().
  /// @param mean of the velocities before and after the step [m/s]
  void finish_step(const dealii::AlignedVector<double> &mean,
                   const double step);

  /// The record of all ranks. Collective.
  CouplingRecord record() const;

  /// Columns of the history; none if monolithic. Collective.
  std::vector<NamedValue> history() const;

  /// Values for the summary. Collective.
  /// @param energy to which the spurious work is compared [J]
  std::vector<NamedValue> summary(const double energy) const;

  /// @param energy total energy at @p time [J]
  /// @throws NumericsError if most of it is spurious. Collective.
  void require_stable(const double time, const double energy) const;

  /// Saves the record and the last accelerations. Collective.
  void save(const std::string &folder) const;

  /// @throws InputError for files of another scene. Collective.
  void restore(const std::string &folder);

private:
  using Vector = dealii::Tensor<1, 3>;

  /// An interface node of this rank.
  struct Node
  {
    std::uint32_t node;
    double solid_mass; ///< [kg]
    /// projector onto directions that walls leave free
    dealii::Tensor<2, 3> free;
    double ratio = 0.;             ///< m_f / m_s [-]
    Vector uncoupled_acceleration; ///< acceleration without m_f [m/s^2]
    /// accelerations of the last and the present step [m/s^2]
    Vector before, now;
    Vector residual, imbalance; ///< [m/s^2], [N]
  };

  [[noreturn]] void throw_no_interface() const;
  void find_nodes(const std::vector<Region> &regions);
  void find_free_directions(const SlipWalls &walls);
  bool iterate();

  const HexSpace *space_ = nullptr;
  CouplingScheme scheme_ = CouplingScheme::monolithic;
  double relaxation_ = 0.5;
  double tolerance_ = 1e-8;
  unsigned int most_iterations_ = 50;

  std::vector<Node> nodes_;
  CouplingRecord record_; ///< with work and ratio of this rank
  double factor_ = 0.;    ///< relaxation factor of the present step
  std::uint64_t iterations_ = 0;
  double last_change_ = 0.; ///< last residual over the first
  bool has_diverged_ = false;
};
} // namespace contrecoup::ale
