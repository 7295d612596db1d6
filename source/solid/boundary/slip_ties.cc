// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/boundary/slip_ties.h>

namespace contrecoup::solid
{
namespace
{
  constexpr const char *section_name = "Interface";
  const std::vector<std::string> contacts{"tied", "slip"};

  /// State of a tie in a checkpoint.
  struct TieRecord
  {
    std::uint32_t number; ///< of the sliding node in the whole mesh
    std::array<std::array<double, 3>, 2> force;
    double opening;
  };

} // namespace


void SlipTies::declare_parameters(dealii::ParameterHandler &prm)
{
  const Section section(prm, section_name);
  declare_selection(prm,
                    "Contact",
                    contacts[0],
                    contacts,
                    "tied: all tissues share their nodes; slip: between "
                    "Tissues and Against only the normal motion is shared, "
                    "and there is no friction.");
  const UsedWith used("Interface/Contact = slip");
  declare_string(
    prm,
    "Tissues",
    "",
    selecting("Tissues on one side of the interface, such as \"skeleton\", "
              "separated by commas."));
  declare_string(
    prm,
    "Against",
    "",
    selecting("Tissues on the other side, such as \"cerebrospinal fluid, "
              "brain\". Nodes that third tissues touch stay tied."));
  declare_double(prm,
                 "Least pressure",
                 "-1e12",
                 -1e12,
                 -1e-6,
                 "Pa",
                 "Below this pressure the interface opens, both sides bear "
                 "this pressure, and it closes when they meet again; the "
                 "default keeps it closed.");
}


void SlipTies::parse_parameters(dealii::ParameterHandler &prm)
{
  const Section section(prm, section_name);
  const std::string path = section_name;
  const auto sliding = find_tissues(prm.get("Tissues"), path + "/Tissues");
  const auto held = find_tissues(prm.get("Against"), path + "/Against");
  for (const Tissue one : sliding)
    for (const Tissue other : held)
      if (one == other)
        throw InputError(path + ": " + name_of(one) +
                         " is in Tissues and in Against");
  const bool slips = prm.get("Contact") == contacts[1];
  if (slips && (sliding.empty() || held.empty()))
    throw InputError(path +
                     "/Contact = slip needs the tissues of both sides in "
                     "Tissues and Against");
  if (slips)
    set(sliding, held, read_double(prm, "Least pressure"));
}


void SlipTies::set(const std::vector<Tissue> &sliding,
                   const std::vector<Tissue> &held,
                   const double least_pressure)
{
  sliding_ = sliding;
  held_ = held;
  least_pressure_ = least_pressure;
}


SlipInterface SlipTies::split(HexMesh &mesh) const
{
  return split_interface(mesh, sliding_, held_, section_name);
}


void SlipTies::reinit(const SolidMesh &mesh,
                      Supports &supports,
                      const bool follows)
{
  follows_ = follows;
  has_normals_ = false;
  ties_.clear();
  facets_.clear();
  areas_.clear();
  if (!active())
    return;
  areas_.resize(3 * mesh.nodes.size());
  std::vector<std::array<bool, 3>> free(mesh.nodes.size(),
                                        {{true, true, true}});
  supports.for_each_reaction([&](const std::uint32_t node,
                                 const unsigned int d,
                                 const double) { free[node][d] = false; });
  for (const SlipInterface::Pair &pair : mesh.slip.pairs)
    ties_.push_back({pair,
                     {{free[pair.sliding], free[pair.held]}},
                     mesh.owned[pair.sliding] != 0,
                     mesh.global_node[pair.sliding],
                     {},
                     0.,
                     {},
                     0.});
  for (const HexMesh::Facet &facet : mesh.slip.facets)
    facets_.push_back(facet.nodes);
}


template <typename Real>
void SlipTies::find_normals(const NodeFields<Real> &nodes,
                            const NodeExchange &exchange)
{
  if (!active() || (has_normals_ && !follows_))
    return;
  has_normals_ = true;
  std::fill(areas_.begin(), areas_.end(), 0.);
  const auto place = [&](const std::uint32_t node) {
    const Real *x =
      &nodes.position_and_displacement[nodes.position_width * node];
    Vector result;
    for (unsigned int d = 0; d < 3; ++d)
      result[d] = double(x[d]) + (follows_ ? double(x[3 + d]) : 0.);
    return result;
  };
  for (const auto &facet : facets_)
  {
    const Vector area =
      0.5 * cross_product_3d(place(facet[2]) - place(facet[0]),
                             place(facet[3]) - place(facet[1]));
    for (const std::uint32_t node : facet)
      for (unsigned int d = 0; d < 3; ++d)
        areas_[3 * node + d] += 0.25 * area[d];
  }
  exchange.add(areas_.data(), 3, 3);
  for (Tie &tie : ties_)
  {
    Vector area;
    for (unsigned int d = 0; d < 3; ++d)
      area[d] = areas_[3 * tie.nodes.sliding + d];
    tie.area = area.norm();
    tie.normal = tie.area > 0. ? area / tie.area : Vector();
  }
}


template <typename Real>
void SlipTies::set_forces(NodeFields<Real> &nodes,
                          const double before,
                          const double next)
{
  const double half = 0.5 * (before + next);
  for (Tie &tie : ties_)
  {
    const std::array<std::uint32_t, 2> node{
      {tie.nodes.sliding, tie.nodes.held}};
    // Rate at which the sides part, and what a unit of force takes from it.
    double parting = tie.opening / next, mobility = 0.;
    std::array<Vector, 2> others;
    for (unsigned int side = 0; side < 2; ++side)
    {
      const double sign = side == 0 ? -1. : 1.;
      const double inverse_mass = nodes.inverse_mass_of(node[side]);
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double n = tie.normal[d];
        others[side][d] =
          double(nodes.force_of(node[side])[d]) - tie.force[side][d];
        parting += sign * n *
                   (double(nodes.velocity_of(node[side])[d]) +
                    half * inverse_mass * others[side][d]);
        if (tie.free[side][d])
          mobility += half * inverse_mass * n * n;
      }
    }
    const double tension =
      mobility > 0. ? std::min(parting / mobility, -least_pressure_ * tie.area)
                    : 0.;
    for (unsigned int side = 0; side < 2; ++side)
      for (unsigned int d = 0; d < 3; ++d)
        if (tie.free[side][d])
        {
          Real &force = nodes.force_of(node[side])[d];
          force = static_cast<Real>(
            others[side][d] + (side == 0 ? tension : -tension) * tie.normal[d]);
          tie.force[side][d] = double(force) - others[side][d];
        }
  }
}


template <typename Real>
void SlipTies::advance(const NodeFields<Real> &nodes, const double step)
{
  for (Tie &tie : ties_)
    for (unsigned int d = 0; d < 3; ++d)
      tie.opening += step * tie.normal[d] *
                     (double(nodes.velocity_of(tie.nodes.held)[d]) -
                      double(nodes.velocity_of(tie.nodes.sliding)[d]));
}


void SlipTies::reset_forces()
{
  for (Tie &tie : ties_)
    tie.force = {};
}


template <typename Real>
void SlipTies::add_work(const NodeFields<Real> &nodes, const double time)
{
  for (const Tie &tie : ties_)
    if (tie.is_counted)
      for (unsigned int d = 0; d < 3; ++d)
        work_ +=
          time *
          (tie.force[0][d] * double(nodes.velocity_of(tie.nodes.sliding)[d]) +
           tie.force[1][d] * double(nodes.velocity_of(tie.nodes.held)[d]));
}


template <typename Real>
std::vector<NamedValue> SlipTies::measures(const NodeFields<Real> &nodes,
                                           const MPI_Comm communicator) const
{
  if (!active())
    return {};
  double n_pairs = 0.;
  std::vector<double> largest{0., 0.};
  for (const Tie &tie : ties_)
  {
    Vector apart;
    for (unsigned int d = 0; d < 3; ++d)
      apart[d] = double(nodes.displacement_of(tie.nodes.held)[d]) -
                 double(nodes.displacement_of(tie.nodes.sliding)[d]);
    apart -= (apart * tie.normal) * tie.normal;
    largest[0] = std::max(largest[0], apart.norm());
    largest[1] = std::max(largest[1], tie.opening);
    n_pairs += tie.is_counted ? 1. : 0.;
  }
  dealii::Utilities::MPI::max(largest, communicator, largest);
  return {
    {"slip_nodes", "-", dealii::Utilities::MPI::sum(n_pairs, communicator)},
    {"largest_slip", "m", largest[0]},
    {"largest_opening", "m", largest[1]}};
}


void SlipTies::save(const std::string &folder,
                    const MPI_Comm communicator) const
{
  if (!active())
    return;
  io::save_part(folder, "slip", communicator, [&](io::StateWriter &out) {
    out.put(work_);
    out.put_records(ties_.size(), [&](const std::size_t i) {
      const Tie &tie = ties_[i];
      TieRecord record{tie.global, {}, tie.opening};
      for (unsigned int side = 0; side < 2; ++side)
        for (unsigned int d = 0; d < 3; ++d)
          record.force[side][d] = tie.force[side][d];
      return record;
    });
  });
}


void SlipTies::restore(const std::string &folder, const MPI_Comm communicator)
{
  if (!active())
    return;
  work_ = 0.;
  const io::NumberIndex here = io::index_by_number(
    ties_.size(), [&](const std::size_t i) { return ties_[i].global; });
  io::restore_parts(folder, "slip", [&](io::StateReader &in) {
    double work = 0.;
    in.take(work);
    // Rank 0 continues the sum over all saved ranks.
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      work_ += work;
    in.take_records<TieRecord>(
      here, [&](const std::size_t i, const TieRecord &record) {
        ties_[i].opening = record.opening;
        for (unsigned int side = 0; side < 2; ++side)
          for (unsigned int d = 0; d < 3; ++d)
            ties_[i].force[side][d] = record.force[side][d];
      });
  });
}


#define CONTRECOUP_INSTANTIATE(Real)                                        \
  template void SlipTies::find_normals(const NodeFields<Real> &,            \
                                       const NodeExchange &);               \
  template void SlipTies::set_forces(                                       \
    NodeFields<Real> &, const double, const double);                        \
  template void SlipTies::advance(const NodeFields<Real> &, const double);  \
  template void SlipTies::add_work(const NodeFields<Real> &, const double); \
  template std::vector<NamedValue> SlipTies::measures(                      \
    const NodeFields<Real> &, const MPI_Comm) const;

CONTRECOUP_INSTANTIATE(double)
CONTRECOUP_INSTANTIATE(float)
} // namespace contrecoup::solid
