// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/rezone/elastic_smoothing.h>
#include <contrecoup/base/deal_ii/releases.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>

namespace contrecoup::ale
{
namespace
{
  using TrilinosVector = dealii::TrilinosWrappers::MPI::Vector;

  /// Product with a matrix, whose vmult() clang does not find in a deal.II that
  /// g++ built.
  struct Product
  {
    const dealii::TrilinosWrappers::SparseMatrix &matrix;

    void vmult(TrilinosVector &product, const TrilinosVector &vector) const
    {
      matrix.trilinos_matrix().Multiply(
        false, vector.trilinos_vector(), product.trilinos_vector());
    }
  };
} // namespace


/// Matrix, constraints and preconditioner.
class ElasticSmoothing::System
{
public:
  System(HexSpace &space,
         const PrescribedNodes &prescribed,
         const ElasticOptions &options);

  void assemble(const dealii::AlignedVector<double> &position,
                const dealii::AlignedVector<double> &displacement);
  unsigned int solve(const dealii::AlignedVector<double> &position);
  void read(dealii::AlignedVector<double> &displacement);
  void resume(const SmoothingMemory &memory);

  const SmoothingMemory &memory() const
  {
    return memory_;
  }

private:
  using Cell = dealii::DoFHandler<3>::active_cell_iterator;

  dealii::types::global_dof_index dof(const std::size_t node,
                                      const unsigned int d) const
  {
    return space_.first_dof(node) + d;
  }
  void move_mesh(const dealii::AlignedVector<double> &position);
  void constrain(const dealii::AlignedVector<double> &displacement);
  void add_cell(const dealii::FEValues<3> &values,
                dealii::FullMatrix<double> &matrix) const;
  void renew_preconditioner();
  /// Whether all nodes of a cell are prescribed.
  bool is_prescribed(const Cell &cell) const;
  /// Computes cells_ and empty_rows_. Collective.
  void find_cells();

  HexSpace &space_;
  PrescribedNodes prescribed_;
  ElasticOptions options_;
  dealii::IndexSet own_, relevant_;
  dealii::AffineConstraints<double> constraints_;
  dealii::TrilinosWrappers::SparseMatrix matrix_;
  TrilinosVector right_side_, solution_;
  std::vector<Cell> cells_; ///< owned cells with free nodes
  /// rows of the matrix without contributions
  std::vector<dealii::types::global_dof_index> empty_rows_;
  dealii::TrilinosWrappers::PreconditionAMG preconditioner_;
  SmoothingMemory memory_;
};


ElasticSmoothing::System::System(HexSpace &space,
                                 const PrescribedNodes &prescribed,
                                 const ElasticOptions &options)
  : space_(space)
  , prescribed_(prescribed)
  , options_(options)
  , own_(space.node_dofs().locally_owned_dofs())
  , relevant_(
      dealii::DoFTools::extract_locally_relevant_dofs(space.node_dofs()))
  , memory_(space)
{
  dealii::AlignedVector<double> none(node_width * space.n_nodes());
  constrain(none);
  dealii::TrilinosWrappers::SparsityPattern pattern(
    own_, own_, relevant_, space.communicator());
  dealii::DoFTools::make_sparsity_pattern(
    space.node_dofs(), pattern, constraints_, false);
  pattern.compress();
  matrix_.reinit(pattern);
  right_side_.reinit(own_, space.communicator());
  solution_.reinit(own_, space.communicator());
  find_cells();
}


void ElasticSmoothing::System::move_mesh(
  const dealii::AlignedVector<double> &position)
{
  std::vector<dealii::types::global_dof_index> dofs(24);
  for (const Cell &cell : cells_)
  {
    cell->get_dof_indices(dofs);
    for (const unsigned int v : cell->vertex_indices())
    {
      const auto node = space_.node_of(dofs[3 * v]);
      for (unsigned int d = 0; d < 3; ++d)
        cell->vertex(v)[d] = position[node_width * node + d];
    }
  }
}


void ElasticSmoothing::System::constrain(
  const dealii::AlignedVector<double> &displacement)
{
  constraints_.clear();
  constraints_.reinit(relevant_);
  for (std::size_t n = 0; n < space_.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3 && !space_.is_sliding(n); ++d)
      if (prescribed_.components[n][d])
      {
        constraints_.add_line(dof(n, d));
        constraints_.set_inhomogeneity(dof(n, d),
                                       displacement[node_width * n + d]);
      }
  for (const InclinedNode &slide : prescribed_.inclined)
  {
    const double *const matter = &displacement[node_width * slide.node];
    const auto line = dof(slide.node, slide.component);
    double ahead = matter[slide.component];
    constraints_.add_line(line);
    for (unsigned int d = 0; d < 3; ++d)
      if (slide.factor[d] != 0.)
      {
        constraints_.add_entry(line, dof(slide.node, d), slide.factor[d]);
        ahead -= slide.factor[d] * matter[d];
      }
    constraints_.set_inhomogeneity(line, ahead);
  }
  constraints_.close();
}


void ElasticSmoothing::System::add_cell(
  const dealii::FEValues<3> &values,
  dealii::FullMatrix<double> &matrix) const
{
  const double nu = options_.poisson_ratio;
  const double lambda = nu / ((1. + nu) * (1. - 2. * nu));
  const double mu = 0.5 / (1. + nu);
  matrix = 0.;
  double volume = 0.;
  for (const unsigned int q : values.quadrature_point_indices())
    volume += values.JxW(q);
  const double stiffness = std::pow(volume, -options_.stiffening);
  // The three components share the shape gradients.
  std::array<dealii::Tensor<1, 3>, 8> g;
  for (const unsigned int q : values.quadrature_point_indices())
  {
    const double weight = stiffness * values.JxW(q);
    for (unsigned int v = 0; v < 8; ++v)
      g[v] = values.shape_grad(3 * v, q);
    for (unsigned int v = 0; v < 8; ++v)
      for (unsigned int w = 0; w <= v; ++w)
      {
        const double trace = g[v] * g[w];
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            matrix(3 * v + a, 3 * w + b) +=
              weight * (lambda * g[v][a] * g[w][b] + mu * g[v][b] * g[w][a] +
                        (a == b ? mu * trace : 0.));
      }
  }
  for (unsigned int i = 0; i < 24; ++i)
    for (unsigned int j = i + 1; j < 24; ++j)
      matrix(i, j) = matrix(j, i);
}


bool ElasticSmoothing::System::is_prescribed(const Cell &cell) const
{
  std::vector<dealii::types::global_dof_index> dofs(24);
  cell->get_dof_indices(dofs);
  return std::all_of(dofs.begin(), dofs.end(), [&](const auto dof) {
    return constraints_.is_constrained(dof);
  });
}


void ElasticSmoothing::System::find_cells()
{
  // Rows without contributions belong to nodes among prescribed ones.
  std::vector<dealii::types::global_dof_index> dofs(24);
  TrilinosVector touched(own_, space_.communicator());
  for (const auto &cell : space_.node_dofs().active_cell_iterators())
    if (cell->is_locally_owned() && !is_prescribed(cell))
    {
      cells_.push_back(cell);
      cell->get_dof_indices(dofs);
      for (const auto dof : dofs)
        touched(dof) += 1.;
    }
  touched.compress(dealii::VectorOperation::add);
  for (const auto dof : own_)
    if (touched(dof) == 0.)
      empty_rows_.push_back(dof);
}


void ElasticSmoothing::System::assemble(
  const dealii::AlignedVector<double> &position,
  const dealii::AlignedVector<double> &displacement)
{
  move_mesh(position);
  constrain(displacement);
  matrix_ = 0.;
  right_side_ = 0.;
  const auto &dof_handler = space_.node_dofs();
  dealii::FEValues<3> values(dof_handler.get_fe(),
                             dealii::QGauss<3>(2),
                             dealii::update_gradients |
                               dealii::update_JxW_values);
  dealii::FullMatrix<double> local(24, 24);
  const dealii::Vector<double> none(24);
  std::vector<dealii::types::global_dof_index> dofs(24);
  for (const Cell &cell : cells_)
  {
    values.reinit(cell);
    add_cell(values, local);
    cell->get_dof_indices(dofs);
    constraints_.distribute_local_to_global(
      local, none, dofs, matrix_, right_side_);
  }
  matrix_.compress(dealii::VectorOperation::add);
  for (const auto row : empty_rows_)
    matrix_.set(row, row, 1.);
  matrix_.compress(dealii::VectorOperation::insert);
  right_side_.compress(dealii::VectorOperation::add);
}


void ElasticSmoothing::System::renew_preconditioner()
{
  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
  data.elliptic = true;
  data.higher_order_elements = false;
  data.smoother_sweeps = 2;
  data.aggregation_threshold = 0.02;
  data.constant_modes = constant_modes(space_.node_dofs());
  preconditioner_.initialize(matrix_, data);
}


unsigned int
ElasticSmoothing::System::solve(const dealii::AlignedVector<double> &position)
{
  if (memory_.first_iterations == 0)
  {
    renew_preconditioner();
    memory_.hierarchy_position = position;
  }
  constraints_.set_zero(solution_);
  const double size = right_side_.l2_norm();
  dealii::SolverControl control(options_.largest_iterations,
                                options_.tolerance * size + 1e-300);
  dealii::SolverCG<TrilinosVector> solver(control);
  try
  {
    solver.solve(Product{matrix_}, solution_, right_side_, preconditioner_);
  }
  catch (const dealii::SolverControl::NoConvergence &)
  {
    throw NumericsError(
      "mesh smoothing: the residual is still " +
      brief(control.last_value() / size) + " of its first one after " +
      std::to_string(options_.largest_iterations) +
      " iterations; Rezone/Tolerance may be too small for flat cells");
  }
  constraints_.distribute(solution_);
  const unsigned int n = std::max(control.last_step(), 1U);
  if (memory_.first_iterations == 0)
    memory_.first_iterations = n;
  else if (n > options_.rebuild_factor * memory_.first_iterations + 5.)
    memory_.first_iterations = 0;
  return control.last_step();
}


void ElasticSmoothing::System::read(dealii::AlignedVector<double> &displacement)
{
  TrilinosVector all(own_, relevant_, space_.communicator());
  all = solution_;
  for (std::size_t n = 0; n < space_.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3 && !space_.is_sliding(n); ++d)
      displacement[node_width * n + d] = all[dof(n, d)];
  memory_.displacement = displacement;
}


void ElasticSmoothing::System::resume(const SmoothingMemory &memory)
{
  memory_ = memory;
  for (std::size_t n = 0; n < space_.n_locally_owned_nodes(); ++n)
    for (unsigned int d = 0; d < 3 && !space_.is_sliding(n); ++d)
      solution_[dof(n, d)] = memory_.displacement[node_width * n + d];
  solution_.compress(dealii::VectorOperation::insert);
  if (memory_.first_iterations == 0)
    return;
  assemble(memory_.hierarchy_position, memory_.displacement);
  renew_preconditioner();
}


SmoothingMemory::SmoothingMemory(const HexSpace &space)
  : displacement(node_width * space.n_nodes())
  , hierarchy_position(node_width * space.n_nodes())
{}


ElasticSmoothing::ElasticSmoothing() = default;
ElasticSmoothing::~ElasticSmoothing() = default;


void ElasticSmoothing::reinit(HexSpace &space,
                              const PrescribedNodes &prescribed,
                              const ElasticOptions &options)
{
  system_ = std::make_unique<System>(space, prescribed, options);
}


unsigned int
ElasticSmoothing::solve(const dealii::AlignedVector<double> &position,
                        dealii::AlignedVector<double> &displacement)
{
  system_->assemble(position, displacement);
  const unsigned int n = system_->solve(position);
  system_->read(displacement);
  return n;
}


const SmoothingMemory &ElasticSmoothing::memory() const
{
  return system_->memory();
}


void ElasticSmoothing::resume(const SmoothingMemory &memory)
{
  system_->resume(memory);
}
} // namespace contrecoup::ale
