// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * MatrixFree with its set-up for lanes that the library does not hold.
 */

#include <contrecoup/base/deal_ii/lane_width.h>

#include <deal.II/matrix_free/matrix_free.h>
#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS == 0
#  include <deal.II/matrix_free/dof_info.templates.h>
#  include <deal.II/matrix_free/mapping_info.templates.h>
#  include <deal.II/matrix_free/matrix_free.templates.h>
#  include <deal.II/matrix_free/shape_info.templates.h>
#endif
