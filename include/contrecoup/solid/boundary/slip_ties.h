// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/solid/body/node_exchange.h>
#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/boundary/supports.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * An interface between tissues that slides without friction: subsection
 * "Interface". Each node of the interface is a pair, one of either side. Equal
 * and opposite forces along the normal of the interface give both nodes the
 * same normal velocity, while the pressure between them is at least a given
 * one; below it the interface opens, under that pressure, until both sides meet
 * again. Tangential motion is free. The forces act on what has no support.
 *
 * With finite rotations, normals follow the sliding side. Velocities are
 * constrained, not positions: forces that hold pairs to a surface that turns
 * would feed energy to its tilt, and positions along constant normals would
 * press a shell that turns into what it contains. In exchange, a slip s while
 * the interface turns by an angle a lets the sides part or overlap by s a.
 * Pairs stay as they are: slips must be smaller than an element.
 */
class SlipTies
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unknown tissues, and for tissues on both sides
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Sets the interface without a parameter file.
  /// @param least_pressure below which the interface opens [Pa], negative
  void set(const std::vector<Tissue> &sliding,
           const std::vector<Tissue> &held,
           double least_pressure);

  /// Tissues on either side; empty if no interface slides.
  const std::vector<Tissue> &sliding() const
  {
    return sliding_;
  }
  const std::vector<Tissue> &held() const
  {
    return held_;
  }

  /// Whether any interface slides.
  bool active() const
  {
    return !sliding_.empty();
  }

  /// Divides the nodes of the interface. @throws InputError, see
  /// split_interface()
  SlipInterface split(HexMesh &mesh) const;

  /// @param follows whether normals follow the deformed body
  void reinit(const SolidMesh &mesh, Supports &supports, bool follows);

  /// Computes normals as area-weighted means of those of the faces.
  /// Collective.
  template <typename Real>
  void find_normals(const NodeFields<Real> &nodes,
                    const NodeExchange &exchange);

  /// Sets the forces of the next step, in place of those set before. Call
  /// after Supports::set_forces(). @param before size of the last step [s]
  /// @param next size of the next step [s]
  template <typename Real>
  void set_forces(NodeFields<Real> &nodes, double before, double next);

  /// Adds up the openings of a step [s] that was made.
  template <typename Real>
  void advance(const NodeFields<Real> &nodes, double step);

  /// Forgets the forces. Call after forces were assembled again.
  void reset_forces();

  /// Adds the work of the forces with the current velocities over a time [s].
  template <typename Real>
  void add_work(const NodeFields<Real> &nodes, double time);

  /// Work of the forces so far, of this rank [J]: zero while the interface is
  /// closed and its normals are constant.
  double work() const
  {
    return work_;
  }

  /// Number of pairs, largest slip and largest opening [m]. Collective.
  template <typename Real>
  std::vector<NamedValue> measures(const NodeFields<Real> &nodes,
                                   MPI_Comm communicator) const;

  /// Writes the state of @p rank to @p folder. @throws SystemError
  void save(const std::string &folder, const MPI_Comm communicator) const;

  /// Reads the state written by any number of ranks.
  /// @throws InputError for files that are incomplete
  void restore(const std::string &folder, const MPI_Comm communicator);

private:
  using Vector = dealii::Tensor<1, 3>;

  struct Tie
  {
    SlipInterface::Pair nodes;
    std::array<std::array<bool, 3>, 2> free; ///< without support, by side
    bool is_counted;                         ///< by this rank in sums
    std::uint32_t global; ///< number of the sliding node in the whole mesh
    Vector normal;        ///< out of the sliding side; 0: not tied
    double area = 0.;     ///< [m^2]
    /// parts of the nodal forces, sliding and held [N]
    std::array<Vector, 2> force;
    double opening = 0.; ///< [m]
  };

  std::vector<Tissue> sliding_, held_;
  double least_pressure_ = 0.; ///< [Pa]
  bool follows_ = false;
  bool has_normals_ = false;
  std::vector<Tie> ties_;
  std::vector<std::array<std::uint32_t, 4>> facets_;
  std::vector<double> areas_; ///< three per node [m^2]
  double work_ = 0.;          ///< of this rank [J]
};
} // namespace contrecoup::solid
