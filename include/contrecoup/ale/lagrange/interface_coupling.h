// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/region.h>
#include <contrecoup/ale/mesh/slip_walls.h>
#include <contrecoup/base/simulation.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// How fluids and solids that share nodes are solved.
enum class CouplingScheme
{
  monolithic,
  loose,
  fixed_relaxation,
  aitken
};

/// The coupling in the course of a run: numbers alone, for checkpoints.
struct CouplingRecord
{
  std::uint64_t n_steps = 0;
  std::uint64_t n_iterations = 0;       ///< of all steps
  std::uint64_t last_iterations = 0;    ///< of the last step
  std::uint64_t largest_iterations = 0; ///< of a step
  double largest_ratio = 0.;            ///< of added mass, at any time [-]
  double work = 0.;                     ///< see InterfaceCoupling::work() [J]
  double factor = 0.; ///< that Aitken's relaxation starts the next step with
};

/**
 * Fluids and solids that are solved in turn: subsection "Coupling".
 *
 * At a node of both, with the masses m_f and m_s and the forces F_f and F_s of
 * its cells, the monolithic scheme solves (m_s + m_f) a = F_s + F_f. In turn,
 * the fluid gets the motion of the interface, acceleration a_k, and the solid
 * its force on that, F_f - m_f a_k, which moves it with b_k:
 *
 *   m_s b_k = F_s + F_f - m_f a_k,   a_k+1 = a_k + w (b_k - a_k),
 *
 * so that errors change by 1 - w (1 + r) with the ratio of added mass
 * r = m_f / m_s (Causin, Gerbeau and Nobile 2005; Foerster, Wall and Ramm
 * 2007). The loose scheme does this once, with the acceleration of the step
 * before and w = 1; the others iterate, with one w or that of Aitken (Irons and
 * Tuck 1969; Kuettler and Wall 2008). As fluids are compressible and steps
 * explicit, the added mass is that of the cells at the interface alone.
 *
 * What is not in balance at the end, (m_s + m_f) a - F_s - F_f, does work at
 * the interface, which no matter has done.
 */
class InterfaceCoupling
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  void parse_parameters(dealii::ParameterHandler &prm);

  /// The same without parameters.
  /// @param tolerance of accelerations, over those of the solid alone
  void set(const CouplingScheme scheme,
           const double relaxation,
           const double tolerance,
           const unsigned int largest_iterations);

  /// Whether fluids and solids are solved in turn.
  bool active() const
  {
    return scheme_ != CouplingScheme::monolithic;
  }

  /// Whether that is done once a step, which nothing tells to be wrong.
  bool is_loose() const
  {
    return scheme_ == CouplingScheme::loose;
  }

  /// The scheme as in a parameter file.
  const std::string &name() const;

  /// @param regions by material id of the mesh
  /// @throws InputError for fluids and solids that do not meet, if they are to
  /// be solved in turn
  void require_interface(const dealii::Triangulation<3> &mesh,
                         const std::vector<Region> &regions) const;

  /**
   * @param regions by material id of the mesh
   * @param walls whose nodes iterate only along them
   * @throws InputError for fluids and solids that share no node. Collective.
   */
  void reinit(const HexSpace &space,
              const std::vector<Region> &regions,
              const SlipWalls &walls);

  /**
   * Adds to forces on nodes of the interface what the scheme is wrong by, so
   * that they give these nodes the scheme's acceleration.
   * @param velocity with the inverse masses
   * @param is_first_half of a step; the other one starts from what it found
   * @param force AleState::width numbers for each node [N]
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

  /// What a step that failed has to say of the coupling: words to be appended,
  /// or, if it has diverged, a clause. Collective.
  std::string problem() const;

  /// Takes the step of the last balance().
  /// @param mean of the velocities before and after it [m/s]
  void finish_step(const dealii::AlignedVector<double> &mean,
                   const double step);

  /// All ranks. Collective.
  CouplingRecord record() const;

  /// Columns of a history; none if it is monolithic. Collective.
  std::vector<NamedValue> history() const;

  /// For the summary.
  /// @param energy that work is compared to [J]. Collective.
  std::vector<NamedValue> summary(const double energy) const;

  /// @param energy of all matter at @p time [J]
  /// @throws NumericsError where most of it was made up. Collective.
  void require_stable(const double time, const double energy) const;

  /// Writes record and last accelerations into a checkpoint. Collective.
  void save(const std::string &folder) const;

  /// @throws InputError for files of another scene. Collective.
  void restore(const std::string &folder);

private:
  using Vector = dealii::Tensor<1, 3>;

  /// A node of this rank with fluid and solid.
  struct Node
  {
    std::uint32_t node;
    double solid_mass;          ///< [kg]
    dealii::Tensor<2, 3> free;  ///< projects onto what walls leave free
    double ratio = 0.;          ///< of added mass [-]
    Vector alone;               ///< acceleration without m_f [m/s^2]
    Vector before, now;         ///< accelerations of steps [m/s^2]
    Vector residual, imbalance; ///< [m/s^2], [N]
  };

  [[noreturn]] void miss_interface() const;
  void find_nodes(const std::vector<Region> &regions);
  void find_free_directions(const SlipWalls &walls);
  bool iterate();

  const HexSpace *space_ = nullptr;
  CouplingScheme scheme_ = CouplingScheme::monolithic;
  double relaxation_ = 0.5;
  double tolerance_ = 1e-8;
  unsigned int most_iterations_ = 50;

  std::vector<Node> nodes_;
  CouplingRecord record_; ///< work and ratio of this rank
  double factor_ = 0.;    ///< of the present step
  std::uint64_t iterations_ = 0;
  double last_change_ = 0.; ///< of the residual, last over first
  bool has_diverged_ = false;
};
} // namespace contrecoup::ale
