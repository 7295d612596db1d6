// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/adaptation.h>
#include <contrecoup/gas/adaptation/jump_sensor.h>
#include <contrecoup/gas/adaptation/line_adaptation.h>
#include <contrecoup/geometry/mesh/ghost_cells.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>
#include <optional>

namespace contrecoup::gas
{
template <int dim>
Adaptation<dim>::Adaptation(const AdaptationParameters &parameters,
                            LeafMesh<dim> &mesh,
                            const LeafPoints<dim> &points,
                            const GasMaterial &material)
  : parameters_(parameters)
  , mesh_(mesh)
  , points_(points)
  , material_(material)
  , levels_(parameters_, mesh)
  , pace_(parameters)
{}


template <int dim>
std::vector<unsigned int> Adaptation<dim>::leaf_weights() const
{
  // An active leaf costs some hundred times as much per stage as a quiet one,
  // which costs memory, and time in adaptations.
  const unsigned int quiet = 1, active = 50;
  std::vector<unsigned int> weights(mesh_.n_owned(), quiet);
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    if (quiet_leaves_ != nullptr &&
        quiet_leaves_->is_active(leaf / mesh_.width()))
      weights[leaf] = active;
  return weights;
}


template <int dim>
std::vector<bool> Adaptation<dim>::wanted_batches() const
{
  std::vector<bool> wanted(mesh_.n_batches(), true);
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
    wanted[batch] = quiet_leaves_ == nullptr || quiet_leaves_->is_active(batch);
  return wanted;
}


template <int dim>
std::vector<typename Adaptation<dim>::FaceMarks>
Adaptation<dim>::face_marks(const GasField &field) const
{
  using Sensor = AdaptationParameters::Sensor;
  std::vector<FaceMarks> marks(mesh_.n_owned());
  if (parameters_.sensor == Sensor::blast)
    marks = front_sensor_by_face(
      mesh_, points_, material_, field, parameters_.noise, wanted_batches());
  else
  {
    const auto values =
      jump_sensor(mesh_,
                  points_,
                  material_,
                  field,
                  parameters_.noise,
                  wanted_batches(),
                  parameters_.sensor == Sensor::pressure_jump);
    for (unsigned int leaf = 0; leaf < marks.size(); ++leaf)
      marks[leaf].fill(values[leaf]);
  }
  if (!parameters_.buffer_only_ahead)
    for (FaceMarks &mark : marks)
      mark.fill(*std::max_element(mark.begin(), mark.end()));
  return marks;
}


template <int dim>
std::vector<double> Adaptation<dim>::sensors(const GasField &field) const
{
  std::vector<double> result;
  for (const FaceMarks &mark : face_marks(field))
    result.push_back(*std::max_element(mark.begin(), mark.end()));
  return result;
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
  std::vector<FaceMarks> marks = face_marks(field);
  // Cells without gas would look like fronts. Leaves at the body have a
  // prescribed level, and the leaves next to them detect approaching waves.
  for (unsigned int leaf = 0; leaf < marks.size(); ++leaf)
    if (field.open_fractions() != nullptr &&
        !field.open_fractions()->is_open(leaf))
      marks[leaf].fill(0.);
  // Unburned explosive keeps its refinement level.
  for (unsigned int leaf = 0; leaf < marks.size() && field.burn() != nullptr;
       ++leaf)
    if (field.burn()->burns[leaf])
      marks[leaf].fill(1.);
  for (unsigned int layer = 0; layer < parameters_.buffer; ++layer)
    spread(marks);
  set_flags(marks);
  if constexpr (dim == 1)
    balance_line(mesh_);
  mesh_.triangulation().prepare_coarsening_and_refinement();
  bool any = false;
  for (const auto &cell : mesh_.triangulation().active_cell_iterators())
    any = any || (cell->is_locally_owned() &&
                  (cell->refine_flag_set() || cell->coarsen_flag_set()));
  if (dealii::Utilities::MPI::max(any ? 1U : 0U, mesh_.communicator()) == 0)
    return false;
  change_mesh(field, maps);
  return true;
}


template <int dim>
void Adaptation<dim>::inherit(const CellIterator &cell,
                              const unsigned int face,
                              const Marks &marks,
                              FaceMarks &result) const
{
  const auto look = [&](const auto &neighbor) {
    if (neighbor->level() < cell->level())
      return;
    const FaceMarks others = marks(neighbor);
    if (others[face ^ 1U] < parameters_.refine)
      return;
    for (unsigned int f = 0; f < 2 * dim; ++f)
      if (others[f] >= parameters_.refine)
        result[f] = std::max(result[f], parameters_.refine);
  };
  const bool periodic = dim > 1 && cell->has_periodic_neighbor(face);
  if (cell->at_boundary(face) && !periodic)
    return;
  const auto neighbor =
    periodic ? cell->periodic_neighbor(face) : cell->neighbor(face);
  if (!neighbor->has_children())
    look(neighbor);
  else if (dim == 1)
    look(neighbor->child(1 - face));
  else
    // Only the children at the face: others would widen the AMR buffer next to
    // coarse leaves, and be coarsened again in the next adaptation.
    for (unsigned int c = 0; c < HangingFace<dim>::n_fine; ++c)
      look(periodic ? cell->periodic_neighbor_child_on_subface(face, c)
                    : cell->neighbor_child_on_subface(face, c));
}


template <int dim>
void Adaptation<dim>::spread(std::vector<FaceMarks> &marks) const
{
  std::map<dealii::CellId, FaceMarks> ghost_marks;
  if constexpr (dim > 1)
  {
    const auto pack =
      [&](const ActiveIterator &cell) -> std::optional<FaceMarks> {
      return marks[mesh_.leaf_of(cell)];
    };
    const auto unpack = [&](const ActiveIterator &cell, const FaceMarks &mark) {
      ghost_marks[cell->id()] = mark;
    };
    exchange_with_ghosts<dim, FaceMarks>(mesh_.triangulation(), pack, unpack);
  }
  const auto marks_of = [&](const CellIterator &cell) {
    return cell->is_locally_owned() ? marks[mesh_.leaf_of(cell)]
                                    : ghost_marks[cell->id()];
  };
  std::vector<FaceMarks> result = marks;
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    for (const unsigned int face : mesh_.cell(leaf)->face_indices())
      inherit(mesh_.cell(leaf), face, marks_of, result[leaf]);
  marks.swap(result);
}


template <int dim>
void Adaptation<dim>::set_flags(const std::vector<FaceMarks> &marks)
{
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const auto &cell = mesh_.cell(leaf);
    const unsigned int level = cell->level();
    cell->clear_refine_flag();
    cell->clear_coarsen_flag();
    const auto allowed = levels_.levels(leaf, time_);
    const double mark =
      *std::max_element(marks[leaf].begin(), marks[leaf].end());
    if ((mark >= parameters_.refine && level < allowed.max_level) ||
        level < allowed.min_level)
      cell->set_refine_flag();
    else if ((mark < parameters_.coarsen && level > allowed.min_level) ||
             level > allowed.max_level)
      cell->set_coarsen_flag();
  }
}


template <int dim>
bool Adaptation<dim>::refine_where(
  const std::function<bool(const unsigned int leaf)> &wanted)
{
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
    if (static_cast<unsigned int>(mesh_.cell(leaf)->level()) <
          levels_.levels(leaf, time_).max_level &&
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
    balance_line(mesh_);
  mesh_.triangulation().execute_coarsening_and_refinement();
  mesh_.distribute();
  return true;
}


template <int dim>
void Adaptation<dim>::refine_at_body()
{
  do
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      if (levels_.is_too_coarse_at_body(leaf))
        mesh_.cell(leaf)->set_refine_flag();
  while (refine_flagged());
}


template <int dim>
void Adaptation<dim>::refine_fine_box()
{
  do
    for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      if (parameters_.fine_level > 0 &&
          static_cast<unsigned int>(mesh_.cell(leaf)->level()) <
            levels_.levels(leaf, time_).min_level)
        mesh_.cell(leaf)->set_refine_flag();
  while (refine_flagged());
}


template <int dim>
void Adaptation<dim>::change_mesh(GasField &field, BlastMaps<dim> &maps)
{
  const LeafCarrier<dim> carrier(mesh_, points_, material_, field, maps);
  const auto former_levels = leaf_levels(mesh_);
  weights_ = leaf_weights();
  mesh_.triangulation().execute_coarsening_and_refinement();
  mesh_.rebuild();
  const auto origins = leaf_origins<dim>(former_levels, leaf_levels(mesh_));
  carrier.carry_over(origins);
  carry_weights(origins);
  if constexpr (dim > 1)
    if (dealii::Utilities::MPI::n_mpi_processes(mesh_.communicator()) > 1 &&
        needs_distribution())
      distribute(carrier, field, maps);
  weights_.clear();
  field.fill_padding(mesh_.n_owned());
}


template <int dim>
void Adaptation<dim>::carry_weights(const std::vector<LeafOrigin> &origins)
{
  std::vector<unsigned int> weights;
  weights.reserve(origins.size());
  for (const LeafOrigin &origin : origins)
  {
    const auto first = weights_.begin() + origin.former;
    const bool is_merged = origin.change == LeafOrigin::Change::merged;
    weights.push_back(
      *std::max_element(first, first + (is_merged ? 1U << dim : 1U)));
  }
  weights_.swap(weights);
}


template <int dim>
bool Adaptation<dim>::needs_distribution() const
{
  // A distribution takes about a third of the time of the steps between two
  // adaptations, in which the work on a rank changes by a few per cent.
  constexpr double largest_excess = 0.1;
  const auto communicator = mesh_.communicator();
  const auto work = dealii::Utilities::MPI::min_max_avg(
    std::accumulate(weights_.begin(), weights_.end(), 0.), communicator);
  bool is_split = false;
  for (unsigned int leaf = 0; leaf < mesh_.n_owned() && !is_split; ++leaf)
    is_split = splits_siblings(leaf);
  return work.max > (1. + largest_excess) * work.avg ||
         dealii::Utilities::MPI::max(is_split ? 1U : 0U, communicator) > 0;
}


template <int dim>
bool Adaptation<dim>::splits_siblings(const unsigned int leaf) const
{
  const auto &cell = mesh_.cell(leaf);
  if (cell->level() == 0)
    return false;
  bool any_elsewhere = false;
  for (unsigned int c = 0; c < cell->parent()->n_children(); ++c)
  {
    const auto sibling = cell->parent()->child(c);
    if (sibling->has_children())
      return false;
    any_elsewhere = any_elsewhere || !sibling->is_locally_owned();
  }
  return any_elsewhere;
}


template <int dim>
void Adaptation<dim>::distribute(const LeafCarrier<dim> &carrier,
                                 GasField &field,
                                 BlastMaps<dim> &maps)
{
  if constexpr (dim > 1)
  {
    using Bytes = boost::iterator_range<std::vector<char>::const_iterator>;
    auto &tria = mesh_.triangulation();
    const auto handle = tria.register_data_attach(
      [&](const CellIterator &cell, const auto) { return carrier.pack(cell); },
      false);
    weigher_ =
      tria.signals.weight.connect([this](const CellIterator &cell, const auto) {
        return weights_[mesh_.leaf_of(cell)];
      });
    mesh_.distribute();
    weigher_.disconnect();
    field.reinit(field.layout(), mesh_.n_stored_batches());
    if (!maps.empty())
      maps.reinit(field.layout().n_points, mesh_.n_owned());
    tria.notify_ready_to_unpack(
      handle, [&](const CellIterator &cell, const auto, const Bytes &bytes) {
        carrier.unpack(cell, &*bytes.begin());
      });
  }
}


template class Adaptation<1>;
template class Adaptation<2>;
template class Adaptation<3>;
} // namespace contrecoup::gas
