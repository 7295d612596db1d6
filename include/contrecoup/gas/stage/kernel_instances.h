// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * What the kernels of a stage are compiled for: a macro INSTANTIATE with the
 * arguments dimension, equation of state and precision is called for each.
 */

#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

/// Kernels of mapped leaves, which are no lines.
#define CONTRECOUP_FOR_MAPPED_KERNELS(INSTANTIATE) \
  INSTANTIATE(2, IdealGas, double);                \
  INSTANTIATE(3, IdealGas, double);                \
  INSTANTIATE(3, IdealGas, float);                 \
  INSTANTIATE(2, MieGrueneisen, double);           \
  INSTANTIATE(3, MieGrueneisen, double);           \
  INSTANTIATE(3, MieGrueneisen, float)

#define CONTRECOUP_FOR_KERNELS(INSTANTIATE) \
  INSTANTIATE(1, IdealGas, double);         \
  INSTANTIATE(1, MieGrueneisen, double);    \
  CONTRECOUP_FOR_MAPPED_KERNELS(INSTANTIATE)
