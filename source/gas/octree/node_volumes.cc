// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/node_volumes.h>

#include <deal.II/base/quadrature_lib.h>

namespace contrecoup::gas
{
template <int dim>
std::vector<double> node_volumes(const LeafBox<dim> &box,
                                 const LeafPoints<dim> &points)
{
  const dealii::QGauss<1> edge(points.n());
  std::vector<std::vector<double>> shape;
  for (const auto &x : edge.get_points())
    shape.push_back(points.basis().values(x[0]));
  const dealii::Quadrature<dim> samples((dealii::Quadrature<dim>(edge)));
  std::vector<double> result(samples.size(), 0.);
  for (unsigned int s = 0; s < samples.size(); ++s)
  {
    const auto at = points.indices(s);
    const double part = samples.weight(s) * box.jacobian(samples.point(s));
    for (unsigned int q = 0; q < result.size(); ++q)
    {
      const auto index = points.indices(q);
      double value = part;
      for (unsigned int d = 0; d < dim; ++d)
        value *= shape[at[d]][index[d]];
      result[q] += value;
    }
  }
  return result;
}


template std::vector<double> node_volumes(const LeafBox<1> &,
                                          const LeafPoints<1> &);
template std::vector<double> node_volumes(const LeafBox<2> &,
                                          const LeafPoints<2> &);
template std::vector<double> node_volumes(const LeafBox<3> &,
                                          const LeafPoints<3> &);
} // namespace contrecoup::gas
