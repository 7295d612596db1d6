// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/kernel/lobatto_metric.h>
#include <contrecoup/gas/octree/leaf_layout.h>

namespace contrecoup::gas
{
namespace
{
  /// Ends of the subcells, whose edges are the quadrature weights.
  std::vector<double> subcell_corners(const LobattoBasis &basis)
  {
    std::vector<double> corners = {0.};
    for (const double weight : basis.weights())
      corners.push_back(corners.back() + weight);
    corners.back() = 1.;
    return corners;
  }
} // namespace


template <int dim>
LobattoMetric<dim>::LobattoMetric(const unsigned int n)
  : Base(subcell_corners(LobattoBasis(n)))
  , basis_(n)
  , places_(dealii::Utilities::pow(n, dim))
  , tangents_(dim * places_.size())
  , normals_(dim * places_.size())
  , potential_(places_.size())
{}


template <int dim>
void LobattoMetric<dim>::reinit(const LeafMesh<dim> &mesh,
                                const unsigned int batch)
{
  Base::place_nodes(mesh, batch);
  const unsigned int n = basis_.n_points();
  for (unsigned int q = 0; q < places_.size(); ++q)
  {
    std::array<double, dim> x;
    unsigned int rest = q;
    for (unsigned int d = 0; d < dim; ++d)
    {
      x[d] = basis_.nodes()[rest % n];
      rest /= n;
    }
    places_[q] = Base::place(x);
  }
  differentiate_places();
  set_normals();
  set_volumes();
  for (unsigned int direction = 0; direction < dim; ++direction)
    set_areas(direction);
}


template <int dim>
template <typename Values>
auto LobattoMetric<dim>::derivative(const Values &values,
                                    const unsigned int direction,
                                    const unsigned int point) const
{
  const unsigned int n = basis_.n_points();
  const unsigned int stride = dealii::Utilities::pow(n, direction);
  const unsigned int i = (point / stride) % n;
  const unsigned int first = point - i * stride;
  auto sum = values[first] * Number(basis_.derivative()(i, 0));
  for (unsigned int j = 1; j < n; ++j)
    sum += values[first + j * stride] * Number(basis_.derivative()(i, j));
  return sum;
}


template <int dim>
void LobattoMetric<dim>::differentiate_places()
{
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int q = 0; q < places_.size(); ++q)
      tangents_[d * places_.size() + q] = derivative(places_, d, q);
}


template <int dim>
void LobattoMetric<dim>::set_normals()
{
  if constexpr (dim == 2)
    for (unsigned int q = 0; q < places_.size(); ++q)
    {
      const Vector &a = tangents_[q];
      const Vector &b = tangents_[places_.size() + q];
      normals_[q][0] = b[1];
      normals_[q][1] = -b[0];
      normals_[places_.size() + q][0] = -a[1];
      normals_[places_.size() + q][1] = a[0];
    }
  else
    for (unsigned int direction = 0; direction < dim; ++direction)
      set_curl(direction);
}


// Component x_n of the vector across direction i is that along i of
// -curl (x_l grad x_m - x_m grad x_l) / 2, with n, m, l and i, j, k cyclic.
template <int dim>
void LobattoMetric<dim>::set_curl(const unsigned int direction)
{
  const unsigned int size = places_.size();
  const unsigned int along[] = {(direction + 1) % dim, (direction + 2) % dim};
  for (unsigned int component = 0; component < dim; ++component)
  {
    const unsigned int m = (component + 1) % dim, l = (component + 2) % dim;
    for (unsigned int part = 0; part < 2; ++part)
    {
      const Vector *tangent = &tangents_[along[part] * size];
      for (unsigned int q = 0; q < size; ++q)
        potential_[q] =
          places_[q][l] * tangent[q][m] - places_[q][m] * tangent[q][l];
      for (unsigned int q = 0; q < size; ++q)
      {
        const Number half =
          derivative(potential_, along[1 - part], q) * (part == 0 ? 0.5 : -0.5);
        Number &normal = normals_[direction * size + q][component];
        normal = part == 0 ? half : Number(normal + half);
      }
    }
  }
}


template <int dim>
void LobattoMetric<dim>::set_volumes()
{
  const unsigned int n = basis_.n_points();
  const unsigned int size = places_.size();
  for (unsigned int q = 0; q < size; ++q)
  {
    dealii::Tensor<2, dim, Number> tangents;
    for (unsigned int d = 0; d < dim; ++d)
      tangents[d] = tangents_[d * size + q];
    Number &volume = Base::volumes_[q];
    volume = determinant(tangents);
    unsigned int rest = q;
    std::array<double, dim> weight;
    for (unsigned int d = 0; d < dim; ++d)
    {
      weight[d] = basis_.weights()[rest % n];
      volume = volume * weight[d];
      rest /= n;
    }
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        if (e != d)
          normals_[d * size + q] *= Number(weight[e]);
  }
}


template <int dim>
void LobattoMetric<dim>::set_areas(const unsigned int direction)
{
  const unsigned int n = basis_.n_points();
  const LeafLayout layout(dim, n, 1);
  const Vector *normals = &normals_[direction * places_.size()];
  for (unsigned int line = 0; line < layout.n_face_points; ++line)
  {
    const unsigned int first = layout.face_point(2 * direction, line, 0);
    const unsigned int last = layout.face_point(2 * direction + 1, line, 0);
    Vector area = normals[first];
    for (unsigned int i = 0; i < n; ++i)
    {
      Base::areas_[Base::face(direction, i, line)] = area;
      const unsigned int q = layout.face_point(2 * direction, line, i);
      area += derivative(normals, direction, q) * Number(basis_.weights()[i]);
    }
    Base::areas_[Base::face(direction, n, line)] = normals[last];
    Base::centers_[Base::face(direction, 0, line)] =
      places_[first] + Base::origin_;
    Base::centers_[Base::face(direction, n, line)] =
      places_[last] + Base::origin_;
  }
}


template class LobattoMetric<2>;
template class LobattoMetric<3>;
} // namespace contrecoup::gas
