// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/triangle_mesh.h>

namespace contrecoup
{
/**
 * A surface without steps and wrinkles of the size of its triangles: vertices
 * move towards the mean of their neighbours and partly back, so that the
 * enclosed volume stays (Taubin 1995).
 */
TriangleMesh smoothed(const TriangleMesh &mesh, unsigned int iterations);
} // namespace contrecoup
