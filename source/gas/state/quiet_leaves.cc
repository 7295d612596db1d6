// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/state/primitive.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace contrecoup::gas
{
namespace
{
  template <typename Real>
  auto bits_of(const Real *value)
  {
    std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t> bits;
    static_assert(sizeof(bits) == sizeof(Real));
    std::memcpy(&bits, value, sizeof(bits));
    return bits;
  }

  /// Whether a stored leaf has explosive that is still to burn.
  bool burns(const GasField &field, const unsigned int leaf)
  {
    return field.burn() != nullptr && field.burn()->burns[leaf] != 0;
  }
} // namespace


template <int dim>
void QuietLeaves<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Method");
  declare_bool(prm,
               "Skip quiet leaves",
               "true",
               "Whether leaves that no wave has reached are skipped; the "
               "result is bitwise the same.");
}


template <int dim>
bool QuietLeaves<dim>::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Method");
  return prm.get_bool("Skip quiet leaves");
}


template <int dim>
QuietLeaves<dim>::QuietLeaves(const LeafMesh<dim> &mesh, const bool enabled)
  : mesh_(mesh)
  , enabled_(enabled)
{}


template <int dim>
void QuietLeaves<dim>::reinit(GasField &field,
                              const std::vector<unsigned int> &driven)
{
  layout_ = field.layout();
  n_active_leaves_ = 0;
  woken_.clear();
  quiet_ghosts_.clear();
  active_batch_.assign(mesh_.n_batches(), 0);
  active_face_.assign(mesh_.hanging_faces().size(), 0);
  quiet_.assign(std::size_t(mesh_.n_stored_batches()) * mesh_.width(), 0);
  ambient_.clear();
  if (enabled_)
    find_ambient(field);
  if (ambient_.empty())
  {
    for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
      activate(batch);
    return;
  }

  find_readers();
  visit_precision(layout_.precision, [&](const auto real) {
    find_quiet<std::decay_t<decltype(real)>>(field);
  });
  for (const unsigned int leaf : driven)
    activate(leaf / mesh_.width());
  // The state of ghosts is known at the beginning of the next stage.
  for (unsigned int ghost = 0; ghost < mesh_.n_ghosts(); ++ghost)
  {
    const unsigned int leaf = mesh_.first_ghost() + ghost;
    quiet_[leaf] = !burns(field, leaf);
    if (quiet_[leaf] != 0)
      quiet_ghosts_.push_back(ghost);
    else
      activate_readers(leaf);
  }
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
    if (!is_active(batch))
      field.copy_to_stages(batch);
}


template <int dim>
template <typename Real>
void QuietLeaves<dim>::find_quiet(const GasField &field)
{
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
  {
    const auto changes =
      deviations(field.state<Real>() + batch * layout_.batch_size());
    for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
    {
      const unsigned int leaf = batch * mesh_.width() + lane;
      quiet_[leaf] = changes[lane] == 0 && !burns(field, leaf);
      if (quiet_[leaf] == 0)
        activate_readers(leaf);
    }
  }
}


template <int dim>
bool QuietLeaves<dim>::have_products() const
{
  return ambient_.size() > Component<dim>::products &&
         ambient_[Component<dim>::products] != 0;
}


template <int dim>
void QuietLeaves<dim>::find_readers()
{
  std::vector<std::pair<unsigned int, unsigned int>> pairs;
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
  {
    for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
      pairs.emplace_back(batch * mesh_.width() + lane, batch);
    for (unsigned int face = 0; face < 2 * dim; ++face)
      for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
        pairs.emplace_back(mesh_.neighbors(batch, face)[lane], batch);
  }
  // The flux of one part of a hanging face may depend on all its leaves.
  for (const auto &face : mesh_.hanging_faces())
  {
    std::vector<unsigned int> leaves(face.fine_leaf.begin(),
                                     face.fine_leaf.end());
    leaves.push_back(face.coarse_leaf);
    for (const unsigned int leaf : leaves)
      for (const unsigned int reader : leaves)
        if (leaf != no_leaf && reader < mesh_.n_owned())
          pairs.emplace_back(leaf, reader / mesh_.width());
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  readers_.clear();
  first_reader_.assign(quiet_.size() + 1, 0);
  for (const auto &[leaf, reader] : pairs)
  {
    readers_.push_back(reader);
    ++first_reader_[leaf + 1];
  }
  for (std::size_t leaf = 0; leaf < quiet_.size(); ++leaf)
    first_reader_[leaf + 1] += first_reader_[leaf];
}


template <int dim>
void QuietLeaves<dim>::find_ambient(const GasField &field)
{
  std::map<std::vector<Bits>, double> volumes;
  visit_precision(layout_.precision, [&](const auto real) {
    sum_volumes<std::decay_t<decltype(real)>>(field, volumes);
  });
  const std::vector<std::pair<std::vector<Bits>, double>> mine(volumes.begin(),
                                                               volumes.end());
  std::map<std::vector<Bits>, double> sums;
  for (const auto &of_rank :
       dealii::Utilities::MPI::all_gather(mesh_.communicator(), mine))
    for (const auto &[key, volume] : of_rank)
      sums[key] += volume;
  double largest = 0.;
  for (const auto &[key, volume] : sums)
    if (volume > largest)
    {
      largest = volume;
      ambient_ = key;
    }
}


template <int dim>
template <typename Real>
void QuietLeaves<dim>::sum_volumes(
  const GasField &field,
  std::map<std::vector<Bits>, double> &volumes) const
{
  // Most scenes have one or a few such states; of many, only some are counted.
  const std::size_t most_states = 64;
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
  {
    const Real *values = field.state<Real>() + batch * layout_.batch_size();
    const auto changes = differences(values);
    for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
    {
      const unsigned int leaf = batch * mesh_.width() + lane;
      std::vector<Bits> key(layout_.n_components);
      for (unsigned int c = 0; c < layout_.n_components; ++c)
        key[c] = bits_of(values + layout_.value(c, 0) + lane);
      bool is_at_rest = changes[lane] == 0 && !burns(field, leaf);
      for (unsigned int d = 0; d < dim; ++d)
        is_at_rest = is_at_rest && key[Component<dim>::momentum + d] == 0;
      if (is_at_rest &&
          (volumes.size() < most_states || volumes.count(key) > 0))
        volumes[key] += mesh_.cell(leaf)->measure();
    }
  }
}


template <int dim>
template <typename Real>
typename QuietLeaves<dim>::LaneBits
QuietLeaves<dim>::differences(const Real *batch_values) const
{
  LaneBits result{};
  for (unsigned int c = 0; c < layout_.n_components; ++c)
    for (unsigned int q = 1; q < layout_.n_points; ++q)
      for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
        result[lane] |= bits_of(batch_values + layout_.value(c, q) + lane) ^
                        bits_of(batch_values + layout_.value(c, 0) + lane);
  return result;
}


template <int dim>
template <typename Real>
typename QuietLeaves<dim>::LaneBits
QuietLeaves<dim>::deviations(const Real *batch_values) const
{
  LaneBits result{};
  for (unsigned int c = 0; c < layout_.n_components; ++c)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
        result[lane] |=
          bits_of(batch_values + layout_.value(c, q) + lane) ^ ambient_[c];
  return result;
}


template <int dim>
template <typename Real>
void QuietLeaves<dim>::update(const Real *state)
{
  for (const unsigned int leaf : woken_)
    activate_readers(leaf);
  woken_.clear();
  const auto has_woken = [&](const unsigned int ghost) {
    if (ghost_is_quiet(ghost, state))
      return false;
    quiet_[mesh_.first_ghost() + ghost] = 0;
    activate_readers(mesh_.first_ghost() + ghost);
    return true;
  };
  quiet_ghosts_.erase(
    std::remove_if(quiet_ghosts_.begin(), quiet_ghosts_.end(), has_woken),
    quiet_ghosts_.end());
}


template <int dim>
template <typename Real>
bool QuietLeaves<dim>::ghost_is_quiet(const unsigned int ghost,
                                      const Real *in) const
{
  const Real *values = in + layout_.offset(mesh_.first_ghost() + ghost);
  Bits changes = 0;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    if ((mesh_.ghosts()[ghost].faces >> face) & 1U)
      for (unsigned int depth = 0; depth < std::min(2U, layout_.n); ++depth)
        for (unsigned int q = 0; q < layout_.n_face_points; ++q)
          for (unsigned int c = 0; c < layout_.n_components; ++c)
            changes |=
              bits_of(values +
                      layout_.value(c, layout_.face_point(face, q, depth))) ^
              ambient_[c];
  return changes == 0;
}


template <int dim>
template <typename Real>
void QuietLeaves<dim>::find_woken_leaves(const unsigned int batch,
                                         const Real *out)
{
  const auto begin = quiet_.begin() + batch * mesh_.width();
  const auto end = begin + mesh_.n_filled_lanes(batch);
  if (std::find(begin, end, char(1)) == end)
    return;
  const auto changes = deviations(out + batch * layout_.batch_size());
  for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
    if (quiet_[batch * mesh_.width() + lane] != 0 && changes[lane] != 0)
    {
      quiet_[batch * mesh_.width() + lane] = 0;
      woken_.push_back(batch * mesh_.width() + lane);
    }
}


template <int dim>
void QuietLeaves<dim>::activate(const unsigned int batch)
{
  if (active_batch_[batch] != 0)
    return;
  active_batch_[batch] = 1;
  n_active_leaves_ += mesh_.n_filled_lanes(batch);
  for (auto s = mesh_.special_begin(batch); s != mesh_.special_end(batch); ++s)
    if (s->kind != SpecialFace::Kind::boundary)
      active_face_[s->index] = 1;
}


template <int dim>
void QuietLeaves<dim>::activate_readers(const unsigned int leaf)
{
  for (unsigned int i = first_reader_[leaf]; i < first_reader_[leaf + 1]; ++i)
    activate(readers_[i]);
}


#define CONTRECOUP_INSTANTIATE(dim)                                     \
  template class QuietLeaves<dim>;                                      \
  template void QuietLeaves<dim>::update(const double *);               \
  template void QuietLeaves<dim>::update(const float *);                \
  template void QuietLeaves<dim>::find_woken_leaves(const unsigned int, \
                                                    const double *);    \
  template void QuietLeaves<dim>::find_woken_leaves(const unsigned int, \
                                                    const float *)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
