// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/fe/mapping_fe.h>

#include <memory>

namespace contrecoup
{
/**
 * dealii::MappingFE for meshes with hanging faces, without area elements
 * (JxW) on parts of faces: deal.II has none of these, 9.4 gives them
 * those of the whole face and 9.6 ends the program. MatrixFree asks for them,
 * but takes those of the smaller cell.
 */
template <int dim>
class MappingWithSubfaces : public dealii::MappingFE<dim>
{
public:
  using dealii::MappingFE<dim>::MappingFE;

protected:
  std::unique_ptr<typename dealii::Mapping<dim>::InternalDataBase>
  get_subface_data(const dealii::UpdateFlags flags,
                   const dealii::Quadrature<dim - 1> &quadrature) const override
  {
    return dealii::MappingFE<dim>::get_subface_data(
      static_cast<dealii::UpdateFlags>(flags & ~int(dealii::update_JxW_values)),
      quadrature);
  }
};
} // namespace contrecoup
