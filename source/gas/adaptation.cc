// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/adaptation.h>
#include <contrecoup/gas/front_sensor.h>
#include <contrecoup/gas/jump_sensor.h>
#include <contrecoup/gas/leaf_carrier.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <optional>

namespace contrecoup::gas
{
namespace
{
  void declare_sensor(ParameterHandler &prm)
  {
    declare_selection(
      prm,
      "Sensor",
      "density and pressure",
      {"density and pressure", "pressure", "blast"},
      "What leaves are halved for: bends of density and "
      "pressure; of pressure alone, which lets the mesh coarsen "
      "at contacts, as in the hot core of an explosion; or, with "
      "blast, pressure fronts alone, also weak ones.");
    declare_double(prm,
                   "Refine above",
                   "0.5",
                   0.,
                   1.,
                   "-",
                   "Sensor value, a bend relative to the slope, above which a "
                   "leaf is halved.");
    declare_double(prm,
                   "Coarsen below",
                   "0.2",
                   0.,
                   1.,
                   "-",
                   "Sensor value below which sibling leaves are merged.");
    declare_double(prm,
                   "Noise",
                   "0.02",
                   1e-12,
                   1.,
                   "-",
                   "Relative differences between neighbouring points that "
                   "the sensor takes for noise; with the blast sensor the "
                   "relative strength of fronts for which it is one half.");
  }


  void declare_fine_box(ParameterHandler &prm)
  {
    declare_list(prm,
                 "Fine box lower corner",
                 "0, 0, 0",
                 1,
                 3,
                 -unbounded,
                 unbounded,
                 "m",
                 "Corner of smallest coordinates of a box that stays fine.");
    declare_list(prm,
                 "Fine box upper corner",
                 "1, 1, 1",
                 1,
                 3,
                 -unbounded,
                 unbounded,
                 "m",
                 "Its corner of largest coordinates.");
    declare_integer(prm,
                    "Fine box levels",
                    "0",
                    0,
                    20,
                    "Times that leaves with their centre in this box stay "
                    "halved beyond the initial refinement, also where the mesh "
                    "does not adapt; 0 for no such box.");
  }
} // namespace


void AdaptationParameters::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Adaptation");
  declare_bool(prm,
               "Active",
               "false",
               "Whether leaves are halved and merged during the run.");
  declare_integer(prm,
                  "Interval",
                  "5",
                  0,
                  1000000,
                  "Steps between adaptations; fewer where a front could else "
                  "cross the buffer in between, and 0 for as many as it "
                  "allows.");
  declare_integer(prm,
                  "Smallest level",
                  "0",
                  0,
                  20,
                  "Times that every coarse leaf stays halved at least.");
  declare_integer(prm,
                  "Largest level",
                  "0",
                  0,
                  20,
                  "Times that a coarse leaf may be halved at most.");
  declare_sensor(prm);
  declare_integer(prm,
                  "Buffer",
                  "1",
                  0,
                  10,
                  "Layers of leaves around marked ones that are halved "
                  "with them.");
  declare_fine_box(prm);
  SizeLimits::declare_parameters(prm);
}


void AdaptationParameters::parse_parameters(
  ParameterHandler &prm,
  const unsigned int dim,
  const unsigned int initial_refinement,
  const unsigned int n_points,
  const bool is_finite_volume,
  const bool is_axis_aligned)
{
  const Section section(prm, "Adaptation");
  active = prm.get_bool("Active");
  interval = read_unsigned(prm, "Interval");
  least_level = read_unsigned(prm, "Smallest level");
  most_level =
    std::max(read_unsigned(prm, "Largest level"), initial_refinement);
  refine = read_double(prm, "Refine above");
  coarsen = read_double(prm, "Coarsen below");
  noise = read_double(prm, "Noise");
  const std::string name = prm.get("Sensor");
  sensor = name == "blast"      ? Sensor::blast
           : name == "pressure" ? Sensor::pressure_bend
                                : Sensor::bend;
  buffer = read_unsigned(prm, "Buffer");
  fine_lower = read_list(prm, "Fine box lower corner");
  fine_upper = read_list(prm, "Fine box upper corner");
  const unsigned int fine_levels = read_unsigned(prm, "Fine box levels");
  fine_level = fine_levels > 0 ? initial_refinement + fine_levels : 0;
  most_level = std::max(most_level, fine_level);
  limits.parse_parameters(prm, dim);
  if (active || fine_level > 0)
    check(dim, n_points, is_finite_volume, is_axis_aligned);
}


void AdaptationParameters::check(const unsigned int dim,
                                 const unsigned int n_points,
                                 const bool is_finite_volume,
                                 const bool is_axis_aligned) const
{
  if (is_finite_volume && n_points % 2 == 1 && n_points != 1)
    throw InputError("Adaptation needs Method/Subcells = 1 or an even number, "
                     "not " +
                     std::to_string(n_points));
  if (!is_axis_aligned)
    throw InputError("Adaptation needs Domain/Mesh = box");
  if (coarsen > refine)
    throw InputError("Adaptation/Coarsen below must not be larger than "
                     "Adaptation/Refine above");
  if (least_level > most_level)
    throw InputError("Adaptation/Smallest level must not be larger than "
                     "Adaptation/Largest level");
  if (fine_level > 0 && (fine_lower.size() < dim || fine_upper.size() < dim))
    throw InputError("Adaptation/Fine box lower corner and upper corner need " +
                     std::to_string(dim) + " numbers, one for each direction");
}


void AdaptationParameters::fit_interval(const double reach,
                                        const unsigned int dim,
                                        const unsigned int n_points)
{
  // Shock speed over |u| + dim c behind it, largest for adiabatic exponents
  // of 1.2 and more and shocks of any strength.
  const double shock_share = dim == 1 ? 1. : (dim == 2 ? 0.65 : 0.54);
  // The front may stand on the rim of a marked leaf, and is seen by the
  // sensor one point ahead.
  const double room = buffer - 1. / n_points;
  const double steps = std::max(1., std::floor(room / (reach * shock_share)));
  const auto longest = static_cast<unsigned int>(std::min(steps, 1e6));
  interval = interval == 0 ? longest : std::min(interval, longest);
}


template <int dim>
Adaptation<dim>::Adaptation(const AdaptationParameters &parameters,
                            LeafMesh<dim> &mesh,
                            const LeafPoints<dim> &points,
                            const GasMaterial &material)
  : parameters_(parameters)
  , mesh_(mesh)
  , points_(points)
  , material_(material)
{
  weigh_leaves();
}


template <int dim>
void Adaptation<dim>::weigh_leaves()
{
  if constexpr (dim > 1)
    weights_ = mesh_.triangulation().signals.weight.connect(
      [this](const typename LeafMesh<dim>::CellIterator &cell,
             const typename LeafMesh<dim>::Tria::CellStatus) {
        return weight(cell);
      });
}


template <int dim>
unsigned int
Adaptation<dim>::weight(const typename LeafMesh<dim>::CellIterator &cell) const
{
  // An active leaf takes some hundred times as long in each stage; a quiet
  // one takes memory, and time when the mesh changes.
  const unsigned int quiet = 1, active = 50;
  if (quiet_leaves_ == nullptr)
    return quiet;
  if (!cell->has_children())
    return quiet_leaves_->is_active(mesh_.leaf_of(cell) / mesh_.width())
             ? active
             : quiet;
  for (unsigned int c = 0; c < cell->n_children(); ++c)
    if (weight(cell->child(c)) == active)
      return active;
  return quiet;
}


template <int dim>
std::vector<double> Adaptation<dim>::sensors(const GasField &field) const
{
  std::vector<bool> wanted(mesh_.n_batches(), true);
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
    wanted[batch] = quiet_leaves_ == nullptr || quiet_leaves_->is_active(batch);
  using Sensor = AdaptationParameters::Sensor;
  if (parameters_.sensor == Sensor::blast)
    return front_sensor(
      mesh_, points_, material_, field, parameters_.noise, wanted);
  return jump_sensor(mesh_,
                     points_,
                     material_,
                     field,
                     parameters_.noise,
                     wanted,
                     parameters_.sensor == Sensor::pressure_bend);
}


template <int dim>
bool Adaptation<dim>::adapt(GasField &field,
                            BlastMaps<dim> &maps,
                            const double time,
                            QuietLeaves<dim> *quiet_leaves)
{
  time_ = time;
  quiet_leaves_ = quiet_leaves;
  if (quiet_leaves_ != nullptr)
    quiet_leaves_->update(field);
  const bool changed = adapt_now(field, maps);
  quiet_leaves_ = nullptr;
  return changed;
}


template <int dim>
bool Adaptation<dim>::adapt_now(GasField &field, BlastMaps<dim> &maps)
{
  std::vector<double> marks = sensors(field);
  // Cells without gas would look like fronts; leaves at the body keep their
  // size anyhow, and those beside them see what comes.
  for (unsigned int leaf = 0; leaf < marks.size(); ++leaf)
    if (field.open_fractions() != nullptr &&
        !field.open_fractions()->is_open(leaf))
      marks[leaf] = 0.;
  // Explosive that is to burn stays as fine as it was lit.
  for (unsigned int leaf = 0; leaf < marks.size() && field.burn() != nullptr;
       ++leaf)
    if (field.burn()->burns[leaf])
      marks[leaf] = 1.;
  for (unsigned int layer = 0; layer < parameters_.buffer; ++layer)
    spread(marks);
  set_flags(marks);
  if constexpr (dim == 1)
    balance_line();
  mesh_.triangulation().prepare_coarsening_and_refinement();
  bool any = false;
  for (const auto &cell : mesh_.triangulation().active_cell_iterators())
    any = any || (cell->is_locally_owned() &&
                  (cell->refine_flag_set() || cell->coarsen_flag_set()));
  if (dealii::Utilities::MPI::max(any ? 1U : 0U, mesh_.communicator()) == 0)
    return false;
  if constexpr (dim == 1)
    carry_over_line(field, maps);
  else
    carry_over(field, maps);
  return true;
}


template <int dim>
double Adaptation<dim>::largest_mark(const CellIterator &cell,
                                     const unsigned int face,
                                     const Marks &mark) const
{
  double largest = 0.;
  const auto look = [&](const auto &neighbor) {
    if (neighbor->level() >= cell->level())
      largest = std::max(largest, mark(neighbor));
  };
  const bool periodic = dim > 1 && cell->has_periodic_neighbor(face);
  if (cell->at_boundary(face) && !periodic)
    return largest;
  const auto neighbor =
    periodic ? cell->periodic_neighbor(face) : cell->neighbor(face);
  if (!neighbor->has_children())
    look(neighbor);
  else if (dim == 1)
    look(neighbor->child(1 - face));
  else
    // Only the children on the face: farther ones would widen the buffer
    // beside coarse leaves, to be merged again the next time.
    for (unsigned int c = 0; c < HangingFace<dim>::n_fine; ++c)
      look(periodic ? cell->periodic_neighbor_child_on_subface(face, c)
                    : cell->neighbor_child_on_subface(face, c));
  return largest;
}


template <int dim>
void Adaptation<dim>::spread(std::vector<double> &marks) const
{
  std::map<dealii::CellId, double> ghost_marks;
  if constexpr (dim > 1)
  {
    const auto pack = [&](const ActiveIterator &cell) -> std::optional<double> {
      return marks[mesh_.leaf_of(cell)];
    };
    const auto unpack = [&](const ActiveIterator &cell, const double &mark) {
      ghost_marks[cell->id()] = mark;
    };
    dealii::GridTools::exchange_cell_data_to_ghosts<double,
                                                    dealii::Triangulation<dim>>(
      mesh_.triangulation(), pack, unpack);
  }
  const auto mark_of = [&](const CellIterator &cell) {
    return cell->is_locally_owned() ? marks[mesh_.leaf_of(cell)]
                                    : ghost_marks[cell->id()];
  };
  std::vector<double> result = marks;
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    for (const unsigned int face : mesh_.cell(leaf)->face_indices())
      if (largest_mark(mesh_.cell(leaf), face, mark_of) >= parameters_.refine)
        result[leaf] = std::max(result[leaf], parameters_.refine);
  marks.swap(result);
}


template <int dim>
void Adaptation<dim>::set_flags(const std::vector<double> &marks)
{
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const auto &cell = mesh_.cell(leaf);
    const unsigned int level = cell->level();
    cell->clear_refine_flag();
    cell->clear_coarsen_flag();
    const auto allowed = levels(leaf);
    if ((marks[leaf] >= parameters_.refine && level < allowed.most) ||
        level < allowed.least)
      cell->set_refine_flag();
    else if ((marks[leaf] < parameters_.coarsen && level > allowed.least) ||
             level > allowed.most)
      cell->set_coarsen_flag();
  }
}


template <int dim>
bool Adaptation<dim>::refine_where(
  const std::function<bool(const unsigned int leaf)> &wanted)
{
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    if (static_cast<unsigned int>(mesh_.cell(leaf)->level()) <
          levels(leaf).most &&
        wanted(leaf))
      mesh_.cell(leaf)->set_refine_flag();
  return refine_flagged();
}


template <int dim>
bool Adaptation<dim>::refine_flagged()
{
  bool any = false;
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    any = any || mesh_.cell(leaf)->refine_flag_set();
  if (dealii::Utilities::MPI::max(any ? 1U : 0U, mesh_.communicator()) == 0)
    return false;
  if constexpr (dim == 1)
    balance_line();
  mesh_.triangulation().execute_coarsening_and_refinement();
  mesh_.rebuild();
  return true;
}


template <int dim>
void Adaptation<dim>::carry_over(GasField &field, BlastMaps<dim> &maps)
{
  if constexpr (dim > 1)
  {
    using Cell = typename LeafMesh<dim>::CellIterator;
    using Status = typename LeafMesh<dim>::Tria::CellStatus;
    using Bytes = boost::iterator_range<std::vector<char>::const_iterator>;
    const LeafCarrier<dim> carrier(mesh_, points_, material_, field, maps);
    auto &tria = mesh_.triangulation();
    const auto handle = tria.register_data_attach(
      [&](const Cell &cell, const Status status) {
        return carrier.pack(cell, status == tria.CELL_COARSEN);
      },
      false);
    tria.execute_coarsening_and_refinement();
    mesh_.rebuild();
    field.reinit(field.layout(), mesh_.n_stored_batches());
    if (!maps.empty())
      maps.reinit(field.layout().n_points, mesh_.n_owned());
    tria.notify_ready_to_unpack(
      handle, [&](const Cell &cell, const Status status, const Bytes &bytes) {
        carrier.unpack(cell, status == tria.CELL_REFINE, &*bytes.begin());
      });
    field.fill_padding(mesh_.n_owned());
  }
}


template class Adaptation<1>;
template class Adaptation<2>;
template class Adaptation<3>;
} // namespace contrecoup::gas
