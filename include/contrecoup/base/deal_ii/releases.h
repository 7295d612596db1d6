// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * All code that differs between the releases of deal.II.
 */

#include <deal.II/base/config.h>
#include <deal.II/base/data_out_base.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/component_mask.h>

#include <vector>

namespace contrecoup
{
// deal.II 9.5 gave the level to all formats.
#if DEAL_II_VERSION_GTE(9, 5, 0)
inline constexpr auto fastest_compression =
  dealii::DataOutBase::CompressionLevel::best_speed;
#else
inline constexpr auto fastest_compression =
  dealii::DataOutBase::VtkFlags::best_speed;
#endif

/// Where the derivative of a component along a reference direction at a point
/// stands in FEEvaluation::begin_gradients(), whose order is not documented:
/// since deal.II 9.5 the directions of a point follow one another.
template <int dim>
constexpr unsigned int gradient_index(const unsigned int component,
                                      const unsigned int direction,
                                      const unsigned int point,
                                      const unsigned int n_points)
{
#if DEAL_II_VERSION_GTE(9, 5, 0)
  return (component * n_points + point) * dim + direction;
#else
  return (component * dim + direction) * n_points + point;
#endif
}

/// The communicator of a Triangulation or a DoFHandler, whose function has
/// another name since deal.II 9.7.
template <typename Distributed>
MPI_Comm communicator_of(const Distributed &distributed)
{
#if DEAL_II_VERSION_GTE(9, 7, 0)
  return distributed.get_mpi_communicator();
#else
  return distributed.get_communicator();
#endif
}

/// For each component, which of this rank's own degrees of freedom belong to
/// it. deal.II 9.7 returns them.
template <int dim>
std::vector<std::vector<bool>>
constant_modes(const dealii::DoFHandler<dim> &dofs)
{
#if DEAL_II_VERSION_GTE(9, 7, 0)
  return dealii::DoFTools::extract_constant_modes(dofs);
#else
  std::vector<std::vector<bool>> modes;
  dealii::DoFTools::extract_constant_modes(
    dofs, dealii::ComponentMask(), modes);
  return modes;
#endif
}
} // namespace contrecoup
