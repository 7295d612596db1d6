// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/leaf_metric.h>

namespace contrecoup::gas
{
namespace
{
  /// i-th direction after @p direction in cyclic order; the cross product of
  /// the first and the second points along @p direction.
  template <int dim>
  unsigned int cyclic(const unsigned int direction, const unsigned int i)
  {
    return (direction + i) % dim;
  }

  std::vector<double> equal_parts(const unsigned int n)
  {
    std::vector<double> corners;
    for (unsigned int i = 0; i <= n; ++i)
      corners.push_back(double(i) / n);
    return corners;
  }
} // namespace


template <int dim>
LeafMetric<dim>::LeafMetric(const unsigned int n)
  : LeafMetric(equal_parts(n))
{}


template <int dim>
LeafMetric<dim>::LeafMetric(const std::vector<double> &corners)
  : corners_(corners)
  , n_(corners.size() - 1)
  , n_face_points_(dealii::Utilities::pow(n_, dim - 1))
  , nodes_(dealii::Utilities::pow(n_ + 1, dim))
{
  areas_.resize(dim * (n_ + 1) * n_face_points_);
  centers_.resize(areas_.size());
  volumes_.resize(n_ * n_face_points_);
  for (unsigned int d = 0; d < dim; ++d)
    node_stride_[d] = dealii::Utilities::pow(n_ + 1, d);
}


template <int dim>
void LeafMetric<dim>::reinit(const LeafMesh<dim> &mesh,
                             const unsigned int batch)
{
  place_nodes(mesh, batch);
  for (unsigned int direction = 0; direction < dim; ++direction)
    for (unsigned int layer = 0; layer <= n_; ++layer)
      for (unsigned int line = 0; line < n_face_points_; ++line)
        measure_face(direction, layer, line);
  measure_volumes();
}


template <int dim>
void LeafMetric<dim>::place_nodes(const LeafMesh<dim> &mesh,
                                  const unsigned int batch)
{
  // Coordinates relative to vertex 0 avoid cancellation far from the origin.
  for (unsigned int lane = 0; lane < double_width; ++lane)
  {
    const auto &cell =
      mesh.cell(std::min(batch * double_width + lane, mesh.n_owned() - 1));
    for (unsigned int v = 0; v < vertices_.size(); ++v)
      for (unsigned int d = 0; d < dim; ++d)
        vertices_[v][d][lane] = cell->vertex(v)[d] - cell->vertex(0)[d];
    for (unsigned int d = 0; d < dim; ++d)
      origin_[d][lane] = cell->vertex(0)[d];
  }
  for (unsigned int node = 0; node < nodes_.size(); ++node)
  {
    std::array<double, dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = corners_[(node / node_stride_[d]) % (n_ + 1)];
    nodes_[node] = place(x);
  }
}


template <int dim>
typename LeafMetric<dim>::Vector
LeafMetric<dim>::place(const std::array<double, dim> &x) const
{
  Vector result;
  for (unsigned int v = 0; v < vertices_.size(); ++v)
  {
    double weight = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      weight *= (v >> d) & 1U ? x[d] : 1. - x[d];
    if (weight != 0.)
      for (unsigned int d = 0; d < dim; ++d)
        result[d] += vertices_[v][d] * weight;
  }
  return result;
}


template <int dim>
unsigned int LeafMetric<dim>::first_node(const unsigned int direction,
                                         const unsigned int layer,
                                         const unsigned int line) const
{
  unsigned int node = layer * node_stride_[direction];
  unsigned int rest = line;
  for (unsigned int d = 0; d < dim; ++d)
    if (d != direction)
    {
      node += (rest % n_) * node_stride_[d];
      rest /= n_;
    }
  return node;
}


template <int dim>
void LeafMetric<dim>::measure_face(const unsigned int direction,
                                   const unsigned int layer,
                                   const unsigned int line)
{
  const Vector *node = &nodes_[first_node(direction, layer, line)];
  Vector &area = areas_[face(direction, layer, line)];
  Vector &center = centers_[face(direction, layer, line)];
  if constexpr (dim == 2)
  {
    const unsigned int s = node_stride_[1 - direction];
    const Vector edge = node[s] - node[0];
    const double sign = direction == 0 ? 1. : -1.;
    area[0] = edge[1] * sign;
    area[1] = edge[0] * -sign;
    center = (node[s] + node[0]) * Number(0.5);
  }
  else
  {
    // Half the cross product of the diagonals, exact for bilinear faces.
    const unsigned int s = node_stride_[cyclic<dim>(direction, 1)];
    const unsigned int t = node_stride_[cyclic<dim>(direction, 2)];
    const Vector a = node[s + t] - node[0];
    const Vector b = node[t] - node[s];
    for (unsigned int d = 0; d < dim; ++d)
    {
      const unsigned int e = (d + 1) % dim, f = (d + 2) % dim;
      area[d] = (a[e] * b[f] - a[f] * b[e]) * 0.5;
    }
    center = (node[0] + node[s] + node[t] + node[s + t]) * Number(0.25);
  }
}


// By Gauss's theorem, the volume is the sum over the faces of the integral of
// x . n / dim, and the mean of x . n over a bilinear face is its value at the
// centre of the face. The centres of opposite faces are symmetric about the
// centre of the subcell.
template <int dim>
void LeafMetric<dim>::measure_volumes()
{
  volumes_.fill(Number(0.));
  const LeafLayout layout(dim, n_, 1);
  for (unsigned int direction = 0; direction < dim; ++direction)
    for (unsigned int line = 0; line < n_face_points_; ++line)
      for (unsigned int i = 0; i < n_; ++i)
      {
        const unsigned int low = face(direction, i, line);
        const unsigned int high = face(direction, i + 1, line);
        const Vector width = centers_[high] - centers_[low];
        volumes_[layout.face_point(2 * direction, line, i)] +=
          width * (areas_[low] + areas_[high]) * (0.5 / dim);
      }
  for (Vector &center : centers_)
    center += origin_;
}


template <int dim>
typename LeafMetric<dim>::Vector
LeafMetric<dim>::tangent(const unsigned int direction,
                         const unsigned int layer,
                         const unsigned int line,
                         const unsigned int along) const
{
  const Vector *node = &nodes_[first_node(direction, layer, line)];
  const unsigned int s = node_stride_[along];
  Vector edge = node[s] - node[0];
  if constexpr (dim == 3)
  {
    const unsigned int t = node_stride_[3 - direction - along];
    edge += node[s + t] - node[t];
  }
  return edge * (Number(1.) / std::sqrt(edge * edge));
}


template class LeafMetric<2>;
template class LeafMetric<3>;
} // namespace contrecoup::gas
