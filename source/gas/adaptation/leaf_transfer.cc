// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/state/primitive.h>
#include <contrecoup/numerics/scheme/limiters.h>

namespace contrecoup::gas
{
namespace
{
  template <int dim>
  LeafBox<dim> child_box(const LeafBox<dim> &parent_box,
                         const unsigned int child)
  {
    LeafBox<dim> box = parent_box;
    box.extents *= 0.5;
    for (unsigned int d = 0; d < dim; ++d)
      if ((child >> d) & 1U)
        box.origin[d] += box.extents[d];
    return box;
  }

  template <int dim>
  std::vector<LeafBox<dim>> child_boxes(const LeafBox<dim> &parent_box)
  {
    std::vector<LeafBox<dim>> boxes;
    for (unsigned int child = 0; child < (1U << dim); ++child)
      boxes.push_back(child_box(parent_box, child));
    return boxes;
  }
} // namespace


template <int dim>
LeafTransfer<dim>::LeafTransfer(const LeafPoints<dim> &points,
                                const LeafLayout &layout,
                                const GasMaterial &material)
  : points_(points)
  , layout_(layout)
  , material_(material)
{}


template <int dim>
bool LeafTransfer<dim>::is_admissible(const double *first,
                                      const unsigned int stride) const
{
  using C = Component<dim>;
  const double density = first[C::density * stride];
  double kinetic = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    kinetic +=
      first[(C::momentum + d) * stride] * first[(C::momentum + d) * stride];
  const double products =
    material_.has_products() ? first[C::products * stride] / density : 0.;
  return density > 0. && first[C::energy * stride] - 0.5 * kinetic / density -
                             material_.least_energy_density(density, products) >
                           0.;
}


template <int dim>
bool LeafTransfer<dim>::is_admissible(const std::vector<double> &values) const
{
  for (unsigned int q = 0; q < layout_.n_points; ++q)
    if (!is_admissible(&values[q], layout_.n_points))
      return false;
  return true;
}


template <int dim>
void LeafTransfer<dim>::scale(std::vector<double> &values,
                              const std::vector<double> &mean,
                              const double theta) const
{
  for (unsigned int c = 0; c < layout_.n_components; ++c)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      double &value = values[c * layout_.n_points + q];
      value = mean[c] + theta * (value - mean[c]);
    }
}


template <int dim>
bool LeafTransfer<dim>::is_uniform(const std::vector<double> &values) const
{
  for (unsigned int c = 0; c < layout_.n_components; ++c)
    for (unsigned int q = 1; q < layout_.n_points; ++q)
      if (values[c * layout_.n_points + q] != values[c * layout_.n_points])
        return false;
  return true;
}


template <int dim>
std::vector<std::vector<double>>
LeafTransfer<dim>::to_children(const std::vector<double> &parent,
                               const LeafBox<dim> &parent_box) const
{
  if (is_uniform(parent))
    return std::vector<std::vector<double>>(n_children, parent);
  return points_.is_galerkin() ? interpolated_children(parent, parent_box)
                               : reconstructed_children(parent, parent_box);
}


template <int dim>
std::vector<double> LeafTransfer<dim>::mean(const std::vector<double> &values,
                                            const LeafBox<dim> &box) const
{
  std::vector<double> result(layout_.n_components, 0.);
  double volume = 0.;
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    const double weight = points_.exponent() == 0
                            ? points_.relative_volume(q)
                            : points_.volume(box.origin, box.extents, q);
    volume += weight;
    for (unsigned int c = 0; c < layout_.n_components; ++c)
      result[c] += weight * values[c * layout_.n_points + q];
  }
  if (points_.exponent() != 0)
    for (double &value : result)
      value /= volume;
  return result;
}


template <int dim>
void LeafTransfer<dim>::balance(const std::vector<std::vector<double>> &from,
                                const std::vector<LeafBox<dim>> &from_boxes,
                                std::vector<std::vector<double>> &to,
                                const std::vector<LeafBox<dim>> &to_boxes) const
{
  if (points_.exponent() == 0)
    return;
  // Integrals of the excess over one value vanish exactly for uniform leaves.
  const auto excess = [&](const std::vector<std::vector<double>> &leaves,
                          const std::vector<LeafBox<dim>> &boxes,
                          const unsigned int c,
                          double &volume) {
    double sum = 0.;
    volume = 0.;
    for (unsigned int leaf = 0; leaf < leaves.size(); ++leaf)
      for (unsigned int q = 0; q < layout_.n_points; ++q)
      {
        const double part =
          points_.volume(boxes[leaf].origin, boxes[leaf].extents, q);
        volume += part;
        sum += part * (leaves[leaf][c * layout_.n_points + q] -
                       from[0][c * layout_.n_points]);
      }
    return sum;
  };
  for (unsigned int c = 0; c < layout_.n_components; ++c)
  {
    double volume = 0.;
    const double missing =
      excess(from, from_boxes, c, volume) - excess(to, to_boxes, c, volume);
    for (auto &leaf : to)
      for (unsigned int q = 0; q < layout_.n_points; ++q)
        leaf[c * layout_.n_points + q] += missing / volume;
  }
}


template <int dim>
std::vector<double> LeafTransfer<dim>::apply(const std::vector<double> &values,
                                             const Matrices &matrices,
                                             const unsigned int child) const
{
  const unsigned int n = layout_.n;
  std::vector<double> current = values;
  std::vector<double> next(values.size());
  for (unsigned int d = 0; d < dim; ++d)
  {
    const auto &matrix = matrices((child >> d) & 1U);
    const unsigned int stride = layout_.stride(d);
    for (unsigned int c = 0; c < layout_.n_components; ++c)
      for (unsigned int line = 0; line < layout_.n_face_points; ++line)
      {
        const unsigned int first =
          c * layout_.n_points + layout_.face_point(2 * d, line, 0);
        for (unsigned int i = 0; i < n; ++i)
        {
          double sum = 0.;
          for (unsigned int j = 0; j < n; ++j)
            sum += matrix(i, j) * current[first + j * stride];
          next[first + i * stride] = sum;
        }
      }
    current.swap(next);
  }
  return current;
}


template <int dim>
std::vector<std::vector<double>>
LeafTransfer<dim>::interpolated_children(const std::vector<double> &parent,
                                         const LeafBox<dim> &parent_box) const
{
  std::vector<std::vector<double>> children;
  for (unsigned int child = 0; child < n_children; ++child)
    children.push_back(apply(
      parent,
      [this](const unsigned int half) -> const dealii::FullMatrix<double> & {
        return points_.basis().to_child(half);
      },
      child));
  balance({parent}, {parent_box}, children, child_boxes(parent_box));
  make_admissible(children, mean(parent, parent_box));
  return children;
}


template <int dim>
void LeafTransfer<dim>::make_admissible(
  std::vector<std::vector<double>> &leaves,
  const std::vector<double> &mean) const
{
  const auto all_admissible = [&]() {
    return std::all_of(leaves.begin(), leaves.end(), [&](const auto &leaf) {
      return is_admissible(leaf);
    });
  };
  // The admissible set is convex and contains the mean, so bisection succeeds.
  for (unsigned int cut = 0; cut < 10 && !all_admissible(); ++cut)
    for (auto &leaf : leaves)
      scale(leaf, mean, cut < 9 ? 0.5 : 0.);
}


template <int dim>
std::array<std::vector<double>, LeafTransfer<dim>::n_children>
LeafTransfer<dim>::subcell_parts(const std::vector<double> &parent,
                                 const LeafBox<dim> &parent_box,
                                 const unsigned int point) const
{
  const auto index = points_.indices(point);
  // Distances of the halves from the centroid along each direction, such that
  // the volume mean of all parts equals the subcell's value.
  std::array<std::array<double, 2>, dim> distance;
  for (unsigned int d = 0; d < dim; ++d)
    distance[d] = {{-0.25, 0.25}};
  if (points_.exponent() > 0)
  {
    const double begin = points_.subcell_begin(index[0]);
    const double end = points_.subcell_end(index[0]);
    dealii::Point<dim> low, middle, high;
    for (unsigned int d = 1; d < dim; ++d)
      middle[d] = high[d] = 1.;
    low[0] = begin;
    middle[0] = 0.5 * (begin + end);
    high[0] = end;
    const double inner =
      points_.volume(parent_box.origin, parent_box.extents, low, middle);
    low[0] = middle[0];
    const double outer =
      points_.volume(parent_box.origin, parent_box.extents, low, high);
    distance[0] = {
      {-0.5 * outer / (inner + outer), 0.5 * inner / (inner + outer)}};
  }
  std::array<std::vector<double>, n_children> parts;
  parts.fill(std::vector<double>(layout_.n_components));
  for (unsigned int c = 0; c < layout_.n_components; ++c)
  {
    const double *u = &parent[c * layout_.n_points + point];
    std::array<double, dim> slope{};
    for (unsigned int d = 0; d < dim; ++d)
    {
      const int s = layout_.stride(d);
      if (index[d] > 0 && index[d] + 1 < layout_.n)
        slope[d] = minmod(u[0] - u[-s], u[s] - u[0]);
    }
    for (unsigned int part = 0; part < n_children; ++part)
    {
      parts[part][c] = u[0];
      for (unsigned int d = 0; d < dim; ++d)
        parts[part][c] += slope[d] * distance[d][(part >> d) & 1U];
    }
  }
  for (const auto &part : parts)
    if (!is_admissible(part.data(), 1))
    {
      for (unsigned int c = 0; c < layout_.n_components; ++c)
        for (auto &flat : parts)
          flat[c] = parent[c * layout_.n_points + point];
      break;
    }
  return parts;
}


template <int dim>
std::vector<std::vector<double>>
LeafTransfer<dim>::reconstructed_children(const std::vector<double> &parent,
                                          const LeafBox<dim> &parent_box) const
{
  const unsigned int n = layout_.n;
  std::vector<std::vector<double>> children(n_children,
                                            std::vector<double>(parent.size()));
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    const auto index = points_.indices(q);
    const auto parts = subcell_parts(parent, parent_box, q);
    for (unsigned int part = 0; part < n_children; ++part)
    {
      unsigned int child = 0, to = 0;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int place = 2 * index[d] + ((part >> d) & 1U);
        child |= (place / n) << d;
        to += place % n * layout_.stride(d);
      }
      for (unsigned int c = 0; c < layout_.n_components; ++c)
        children[child][c * layout_.n_points + to] = parts[part][c];
    }
  }
  return children;
}


template <int dim>
std::vector<double> LeafTransfer<dim>::from_children(
  const std::vector<std::vector<double>> &children,
  const LeafBox<dim> &parent_box) const
{
  // Uniform children are copied: round-off of a mean would make quiet leaves
  // active.
  if (is_uniform(children[0]) &&
      std::all_of(children.begin(), children.end(), [&](const auto &child) {
        return child == children[0];
      }))
    return children[0];
  return points_.is_galerkin() ? projected_parent(children, parent_box)
                               : averaged_parent(children, parent_box);
}


template <int dim>
std::vector<double> LeafTransfer<dim>::projected_parent(
  const std::vector<std::vector<double>> &children,
  const LeafBox<dim> &parent_box) const
{
  std::vector<double> result(children[0].size(), 0.);
  for (unsigned int child = 0; child < n_children; ++child)
  {
    const auto part = apply(
      children[child],
      [this](const unsigned int half) -> const dealii::FullMatrix<double> & {
        return points_.basis().from_child(half);
      },
      child);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += part[i];
  }
  std::vector<std::vector<double>> parent = {std::move(result)};
  balance(children, child_boxes(parent_box), parent, {parent_box});
  // The projection may overshoot at a jump.
  make_admissible(parent, mean(parent[0], parent_box));
  return parent[0];
}


template <int dim>
std::vector<double> LeafTransfer<dim>::averaged_parent(
  const std::vector<std::vector<double>> &children,
  const LeafBox<dim> &parent_box) const
{
  std::vector<double> result(children[0].size(), 0.);
  const unsigned int n = layout_.n;
  std::vector<double> volume(layout_.n_points, 0.);
  for (unsigned int child = 0; child < n_children; ++child)
  {
    const LeafBox<dim> box = child_box(parent_box, child);
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      const auto index = points_.indices(q);
      unsigned int to = 0;
      for (unsigned int d = 0; d < dim; ++d)
        to += (((child >> d) & 1U) * n + index[d]) / 2 * layout_.stride(d);
      const double part = points_.volume(box.origin, box.extents, q);
      volume[to] += part;
      for (unsigned int c = 0; c < layout_.n_components; ++c)
        result[c * layout_.n_points + to] +=
          part * children[child][c * layout_.n_points + q];
    }
  }
  for (unsigned int c = 0; c < layout_.n_components; ++c)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      result[c * layout_.n_points + q] /= volume[q];
  return result;
}


template class LeafTransfer<1>;
template class LeafTransfer<2>;
template class LeafTransfer<3>;
} // namespace contrecoup::gas
