// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Number of the face-connected piece of each cell of a mesh that is not
/// refined, from 0.
template <int dim>
std::vector<unsigned int> find_pieces(const dealii::Triangulation<dim> &mesh);

/// A warning of a body or a mesh in several pieces; empty for one.
/// @param what is in pieces, such as "the body"
std::string pieces_warning(const std::string &what,
                           const unsigned int n_pieces);
} // namespace contrecoup
