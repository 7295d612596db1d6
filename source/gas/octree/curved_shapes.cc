// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/deal_ii/mapping_with_subfaces.h>
#include <contrecoup/base/deal_ii/releases.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/octree/curved_shapes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <sstream>

namespace contrecoup::gas
{
template <int dim>
class CurvedShapes<dim>::Mapping : public MappingWithSubfaces<dim>
{
public:
  explicit Mapping(const CurvedShapes &shapes)
    : MappingWithSubfaces<dim>(dealii::FE_Q<dim>(shapes.degree_))
    , shapes_(shapes)
  {}

  std::unique_ptr<dealii::Mapping<dim>> clone() const override
  {
    return std::make_unique<Mapping>(shapes_);
  }

  // MappingFE of deal.II 9.4 starts at a vertex, takes whole steps alone, and
  // fails in cells of strong curvature.
  dealii::Point<dim> transform_real_to_unit_cell(
    const typename dealii::Triangulation<dim>::cell_iterator &cell,
    const dealii::Point<dim> &place) const override
  {
    return shapes_.reference_place(cell, place);
  }

protected:
  std::vector<dealii::Point<dim>> compute_mapping_support_points(
    const typename dealii::Triangulation<dim>::cell_iterator &cell)
    const override
  {
    const auto *const nodes = shapes_.first_node(cell->active_cell_index());
    std::vector<dealii::Point<dim>> result;
    for (const unsigned int node : shapes_.lexicographic_)
      result.push_back(nodes[node]);
    return result;
  }

private:
  const CurvedShapes &shapes_;
};


template <int dim>
CurvedShapes<dim>::CurvedShapes(const dealii::Triangulation<dim> &triangulation,
                                const unsigned int degree)
  : triangulation_(triangulation)
  , degree_(degree)
  , n_nodes_(dealii::Utilities::pow(degree + 1, dim))
  , basis_(dealii::Polynomials::generate_complete_Lagrange_basis(
      dealii::QGaussLobatto<1>(degree + 1).get_points()))
  , lexicographic_(
      dealii::FETools::hierarchic_to_lexicographic_numbering<dim>(degree))
  , mapping_(std::make_unique<Mapping>(*this))
{}


template <int dim>
void CurvedShapes<dim>::reinit()
{
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  const dealii::FE_Q<dim> element(degree_);
  dealii::DoFHandler<dim> dof_handler(triangulation_);
  dof_handler.distribute_dofs(element);
  const dealii::IndexSet relevant =
    dealii::DoFTools::extract_locally_relevant_dofs(dof_handler);
  dealii::AffineConstraints<double> hanging(relevant);
  dealii::DoFTools::make_hanging_node_constraints(dof_handler, hanging);
  hanging.close();

  std::array<Vector, dim> positions;
  for (Vector &component : positions)
    component.reinit(
      dof_handler.locally_owned_dofs(), relevant, communicator_of(dof_handler));
  const dealii::MappingQ<dim> manifolds(degree_);
  dealii::FEValues<dim> values(manifolds,
                               element,
                               element.get_unit_support_points(),
                               dealii::update_quadrature_points);
  std::vector<dealii::types::global_dof_index> indices(n_nodes_);
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < n_nodes_; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          if (positions[d].in_local_range(indices[i]))
            positions[d](indices[i]) = values.quadrature_point(i)[d];
    }
  for (Vector &component : positions)
  {
    hanging.distribute(component);
    component.update_ghost_values();
  }

  nodes_.assign(std::size_t(triangulation_.n_active_cells()) * n_nodes_, {});
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
    {
      cell->get_dof_indices(indices);
      const std::size_t first =
        std::size_t(cell->active_cell_index()) * n_nodes_;
      for (unsigned int i = 0; i < n_nodes_; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          nodes_[first + lexicographic_[i]][d] = positions[d](indices[i]);
    }
}


template <int dim>
void CurvedShapes<dim>::check(const std::string &mesh_name) const
{
  const auto nodes = dealii::FE_Q<dim>(degree_).get_unit_support_points();
  for (const auto &cell : triangulation_.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    for (const auto &node : nodes)
    {
      const unsigned int index = cell->active_cell_index();
      const double jacobian = dealii::determinant(derivative(index, node));
      if (jacobian > 0.)
        continue;
      std::ostringstream message;
      message << mesh_name << ": the curved cell of degree " << degree_
              << " with centre " << cell->center()
              << " m is inverted or flat at " << place(index, node)
              << " m (Jacobian " << jacobian
              << "; must be positive); refine more, or set Method/Cell degree "
                 "= 1 for straight cells";
      throw InputError(message.str());
    }
  }
}


// Line by line along x; differences to a node avoid cancellation far from the
// origin.
template <int dim>
typename CurvedShapes<dim>::Position
CurvedShapes<dim>::position(const unsigned int index,
                            const dealii::Point<dim> &x) const
{
  const unsigned int n = degree_ + 1;
  boost::container::small_vector<std::array<double, 2>, 24> factors(3 * n);
  const auto factor = [&](const unsigned int d, const unsigned int i) {
    return factors[d * n + i].data(); // value and slope
  };
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int d = 0; d < dim; ++d)
      basis_[i].value(x[d], 1, factor(d, i));

  const dealii::Point<dim> *const node = first_node(index);
  Position result{node[0], {}};
  for (unsigned int line = 0; line < n_nodes_ / n; ++line)
  {
    dealii::Tensor<1, dim> value, slope;
    for (unsigned int i = 0; i < n; ++i)
    {
      const dealii::Tensor<1, dim> from_first = node[line * n + i] - node[0];
      value += factor(0, i)[0] * from_first;
      slope += factor(0, i)[1] * from_first;
    }
    for (unsigned int along = 0; along <= dim; ++along)
    {
      double weight = 1.;
      for (unsigned int d = 1, rest = line; d < dim; ++d, rest /= n)
        weight *= factor(d, rest % n)[d == along ? 1 : 0];
      for (unsigned int i = 0; i < dim; ++i)
        if (along == dim)
          result.place[i] += weight * value[i];
        else
          result.derivative[i][along] +=
            weight * (along == 0 ? slope[i] : value[i]);
    }
  }
  return result;
}


// Newton's method with steps that shorten the distance.
template <int dim>
dealii::Point<dim> CurvedShapes<dim>::reference_place(
  const typename dealii::Triangulation<dim>::cell_iterator &cell,
  const dealii::Point<dim> &place) const
{
  const unsigned int index = cell->active_cell_index();
  dealii::Point<dim> x = dealii::GeometryInfo<dim>::project_to_unit_cell(
    cell->real_to_unit_cell_affine_approximation(place));
  Position here = position(index, x);
  for (unsigned int iteration = 0; iteration < 50; ++iteration)
  {
    const dealii::Tensor<1, dim> residual = place - here.place;
    dealii::Tensor<1, dim> step = dealii::invert(here.derivative) * residual;
    if (step.norm() < 1e-12)
      return x + step;
    Position next = position(index, x + step);
    while (place.distance(next.place) >= residual.norm() && step.norm() > 1e-9)
    {
      step *= 0.5;
      next = position(index, x + step);
    }
    x += step;
    here = next;
  }
  throw typename dealii::Mapping<dim>::ExcTransformationFailed();
}


// Column of the Jacobian's cofactors, after Nanson.
template <int dim>
dealii::Tensor<1, dim> CurvedShapes<dim>::outward_area(const unsigned int index,
                                                       const unsigned int face,
                                                       const double a,
                                                       const double b) const
{
  dealii::Point<dim> x;
  double along = a;
  for (unsigned int d = 0; d < dim; ++d)
    if (d == face / 2)
      x[d] = face % 2;
    else
    {
      x[d] = along;
      along = b;
    }
  const dealii::Tensor<2, dim> jacobian = derivative(index, x);
  const double factor =
    dealii::determinant(jacobian) * (face % 2 == 1 ? 1. : -1.);
  return dealii::invert(jacobian)[face / 2] * factor;
}


template <int dim>
bool has_curved_manifold(const dealii::Triangulation<dim> &triangulation)
{
  const auto ids = triangulation.get_manifold_ids();
  return std::any_of(ids.begin(), ids.end(), [&](const auto id) {
    return id != dealii::numbers::flat_manifold_id &&
           dynamic_cast<const dealii::FlatManifold<dim> *>(
             &triangulation.get_manifold(id)) == nullptr;
  });
}


template class CurvedShapes<1>;
template class CurvedShapes<2>;
template class CurvedShapes<3>;
template bool has_curved_manifold(const dealii::Triangulation<1> &);
template bool has_curved_manifold(const dealii::Triangulation<2> &);
template bool has_curved_manifold(const dealii::Triangulation<3> &);
} // namespace contrecoup::gas
