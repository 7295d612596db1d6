// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/batch_sweep.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
namespace
{
  std::vector<double> subcell_centers(const unsigned int n)
  {
    std::vector<double> centers(n);
    for (unsigned int i = 0; i < n; ++i)
      centers[i] = (i + 0.5) / n;
    return centers;
  }
} // namespace


template <int dim, typename Gas, typename Real>
BatchSweep<dim, Gas, Real>::BatchSweep(
  const OperatorContext<dim> &context,
  const Gas &gas,
  PrimitiveField<dim, Gas, Real> &primitives)
  : mesh_(context.mesh)
  , layout_(context.layout)
  , scheme_(context.scheme)
  , gas_(gas)
  , primitives_(primitives)
  , leaves_(context, gas, subcell_centers(layout_.n))
  , rates_(nc * layout_.n_points)
  , subcells_((layout_.n + 2 * n_beyond) * layout_.n_face_points)
  , compression_(dim * layout_.n_points)
  , compression_beyond_(2 * layout_.n_face_points)
  , hanging_flux_(2 * layout_.n_face_points)
  , line_half_slopes_(layout_.n + 2)
  , line_end_products_(layout_.n + 2)
  , line_compression_(layout_.n + 2)
{
  line_.scheme = &context.scheme;
  line_.n = layout_.n;
  line_.half_slopes = &line_half_slopes_[1];
  line_.end_products = &line_end_products_[1];
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::bind(const unsigned int batch,
                                      const BasicStage<Real> &stage)
{
  leaves_.bind(batch, stage);
  primitive_ = primitives_.batch(batch);
  const std::size_t first = batch * layout_.batch_size();
  states_ = {{stage.start + first, stage.results.state + first}};
  line_.bounds_velocity = stage.bound_velocity_slopes;
  line_.burn = leaves_.burn();
  line_.compression = nullptr;
  if (leaves_.needs_shear_factor())
  {
    line_.compression = &line_compression_[1];
    find_compression();
  }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::read_neighbors(const unsigned int direction)
{
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int face = 2 * direction + side;
    const auto &reader = leaves_.neighbors(face);
    for (unsigned int s = 0; s < reader.n_sources(); ++s)
      primitives_.batch(reader.source(s) / layout_.batch_size());
    for (unsigned int layer = 0; layer < n_beyond; ++layer)
      for (unsigned int q = 0; q < layout_.n_face_points; ++q)
      {
        const unsigned int point =
          layout_.face_point(face ^ 1U, q, std::min(layer, layout_.n - 1));
        Values values;
        reader.read(primitives_.data() + Primitives::index(0, point),
                    Leaves::width,
                    values);
        for (unsigned int c = 0; c < nc; ++c)
          beyond(side, layer, q)[c] =
            values[rotated_component<dim>(c, direction)];
      }
  }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::prefetch_neighbors(
  const unsigned int direction,
  const unsigned int q)
{
  for (unsigned int face = 2 * direction; face < 2 * direction + 2; ++face)
    for (unsigned int layer = 0; layer < n_beyond; ++layer)
    {
      const unsigned int point =
        layout_.face_point(face ^ 1U, q, std::min(layer, layout_.n - 1));
      leaves_.neighbors(face).prefetch(primitives_.data() +
                                         Primitives::index(0, point),
                                       nc * Leaves::width,
                                       leaves_.batch() * layout_.batch_size());
    }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::prefetch_states(const unsigned int line)
{
  constexpr unsigned int n_in_cache_line = 64 / sizeof(Real);
  const std::size_t n = layout_.batch_size() / layout_.n_face_points;
  for (const Real *state : states_)
    for (std::size_t i = line * n; i < (line + 1) * n; i += n_in_cache_line)
      __builtin_prefetch(state + i);
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::fill_beyond(
  const unsigned int direction,
  const HangingData<dim, Real> &hanging)
{
  read_neighbors(direction);
  if (leaves_.needs_shear_factor())
    for (unsigned int side = 0; side < 2; ++side)
      find_compression_beyond(direction, side);
  line_.shock = {
    {std::max(leaves_.sensor(), leaves_.neighbor_sensor(2 * direction)),
     leaves_.sensor(),
     std::max(leaves_.sensor(), leaves_.neighbor_sensor(2 * direction + 1))}};
  line_.leaving =
    leaves_.any_leaving(direction) ? &leaves_.leaving(direction) : nullptr;
  line_.has_hanging.fill(nullptr);
  has_hanging_.fill(Number(0.));
  using Kind = typename Boundary<dim>::Kind;
  std::array<Number, 2> is_mirrored, is_repeated;
  is_mirrored.fill(Number(0.));
  is_repeated.fill(Number(0.));
  for (auto s = mesh_.special_begin(leaves_.batch());
       s != mesh_.special_end(leaves_.batch());
       ++s)
    if (s->face / 2 == direction)
    {
      if (s->kind != SpecialFace::Kind::boundary)
        fill_hanging(*s, hanging);
      else if (leaves_.boundary().kind(s->index) == Kind::wall)
        is_mirrored[s->face % 2][s->lane] = 1.;
      else if (leaves_.boundary().kind(s->index) == Kind::open &&
               !(leaves_.leaving(direction)[s->lane] > 0.))
        is_repeated[s->face % 2][s->lane] = 1.;
      else
        fill_boundary(*s);
    }
  for (unsigned int side = 0; side < 2; ++side)
    if (any_less(Number(0.), Number(is_mirrored[side] + is_repeated[side])))
      fill_images(2 * direction + side, is_mirrored[side], is_repeated[side]);
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::fill_images(const unsigned int face,
                                             const Number &is_mirrored,
                                             const Number &is_repeated)
{
  const Number zero(0.);
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    const auto image = [&](const unsigned int layer) {
      return cell(face / 2, layout_.face_point(face, q, layer));
    };
    const Values first = image(0);
    for (unsigned int layer = 0; layer < n_beyond; ++layer)
    {
      Values mirrored = image(std::min(layer, layout_.n - 1));
      mirrored[C::velocity] = zero - mirrored[C::velocity];
      for (unsigned int c = 0; c < nc; ++c)
      {
        Number &value = beyond(face % 2, layer, q)[c];
        value = select_less(zero, is_mirrored, mirrored[c], value);
        value = select_less(zero, is_repeated, first[c], value);
      }
    }
  }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::fill_boundary(const SpecialFace &special)
{
  const unsigned int direction = special.face / 2;
  const bool is_leaving =
    leaves_.leaving(direction)[special.lane] > 0. && layout_.n > 1;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    for (unsigned int layer = 0; layer < n_beyond; ++layer)
    {
      Values inside = cell(direction, layout_.face_point(special.face, q, 0));
      // A fifth of the next subcell: then hardly anything of a shock that
      // leaves comes back (found by trials at Mach 1.1 to 1.9).
      if (is_leaving)
      {
        const Values next =
          cell(direction, layout_.face_point(special.face, q, 1));
        for (unsigned int c = 0; c < nc; ++c)
          inside[c] += (next[c] - inside[c]) * 0.2;
      }
      leaves_.fill_boundary(
        special, q, inside, beyond(special.face % 2, layer, q));
    }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::fill_hanging(
  const SpecialFace &special,
  const HangingData<dim, Real> &hanging)
{
  const unsigned int side = special.face % 2;
  const unsigned int lane = special.lane;
  const unsigned int slot = Leaves::slot_of(special);
  Values *fluxes = &hanging_flux_[side * layout_.n_face_points];
  has_hanging_[side][lane] = 1.;
  line_.has_hanging[side] = &has_hanging_[side];
  // The second layer does not count: only the slope of the first depends on it,
  // and the flux through the face is known.
  for (unsigned int c = 0; c < nc; ++c)
  {
    const unsigned int from = rotated_component<dim>(c, special.face / 2);
    const Real *halo = hanging.halo(special.index, slot, from);
    const Real *flux = hanging.flux(special.index, slot, from);
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    {
      beyond(side, 0, q)[c][lane] = halo[q];
      fluxes[q][c][lane] = flux[q];
    }
  }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::find_compression()
{
  for (unsigned int d = 0; d < dim; ++d)
  {
    const unsigned int s = layout_.stride(d);
    const auto velocity = [&](const unsigned int q) {
      return primitive_ + Primitives::index(C::velocity + d, q);
    };
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      const unsigned int index = q / s % layout_.n;
      Number here, other, smallest(0.);
      here.load(velocity(q));
      if (index > 0)
      {
        other.load(velocity(q - s));
        smallest = std::min(smallest, Number(here - other));
      }
      if (index + 1 < layout_.n)
      {
        other.load(velocity(q + s));
        smallest = std::min(smallest, Number(other - here));
      }
      compression_[d * layout_.n_points + q] = smallest;
    }
  }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::find_compression_beyond(
  const unsigned int direction,
  const unsigned int side)
{
  const unsigned int n = layout_.n;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    Number smallest(0.);
    unsigned int s = 1; // distance of neighbours along d on the face
    for (unsigned int d = 0; d < dim; ++d)
      if (d != direction)
      {
        const unsigned int c = C::velocity + (d + dim - direction) % dim;
        const Number &here = beyond(side, 0, q)[c];
        if (q / s % n > 0)
          smallest =
            std::min(smallest, Number(here - beyond(side, 0, q - s)[c]));
        if (q / s % n + 1 < n)
          smallest =
            std::min(smallest, Number(beyond(side, 0, q + s)[c] - here));
        s *= n;
      }
    compression_beyond_[side * layout_.n_face_points + q] = smallest;
  }
}


template <int dim, typename Gas, typename Real>
void BatchSweep<dim, Gas, Real>::fill_line(const unsigned int direction,
                                           const unsigned int line)
{
  const unsigned int n = layout_.n;
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  Values *const cells = subcells(line);
  line_.subcells = cells;
  // The compiler copies a whole array by a call of memcpy.
  for (unsigned int i = 0; i < n; ++i)
  {
    const Values values = cell(direction, first + i * stride);
    for (unsigned int c = 0; c < nc; ++c)
      cells[i][c] = values[c];
  }
  if constexpr (Gas::has_products)
  {
    largest_density_ = cells[0][C::density];
    largest_products_ = cells[0][C::products];
    for (int i = -int(n_beyond); i < int(n + n_beyond); ++i)
    {
      largest_density_ = std::max(largest_density_, cells[i][C::density]);
      largest_products_ = std::max(largest_products_, cells[i][C::products]);
    }
  }
  for (unsigned int side = 0; side < 2; ++side)
    line_.hanging_flux[side] =
      &hanging_flux_[side * layout_.n_face_points + line];
  if (line_.burn != nullptr)
  {
    leaves_.fill_progress(direction, line);
    line_.progress = leaves_.line_progress();
  }
  if (line_.compression == nullptr)
    return;
  for (unsigned int i = 0; i < n; ++i)
  {
    Number smallest(0.);
    for (unsigned int d = 0; d < dim; ++d)
      if (d != direction)
        smallest = std::min(
          smallest, compression_[d * layout_.n_points + first + i * stride]);
    line_compression_[i + 1] = smallest;
  }
  line_compression_[0] = compression_beyond_[line];
  line_compression_[n + 1] = compression_beyond_[layout_.n_face_points + line];
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class BatchSweep<dim, Gas, Real>
CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
