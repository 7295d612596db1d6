// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/hex8_geometry.h>
#include <contrecoup/solid/motion/element_rotation.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::solid
{
template <typename Real>
double largest_rotation(const SolidMesh &mesh,
                        const NodeFields<Real> &nodes,
                        const MPI_Comm communicator)
{
  double largest = 0.;
  for (const HexMesh::Cell &element : mesh.elements)
  {
    HexVectors<double> x, u;
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
      {
        x[c][d] = mesh.nodes[element[c]][d];
        u[c][d] = nodes.displacement_of(element[c])[d];
      }
    const Matrix3<double> h =
      mean_gradient(hex_geometry(to_modes(x)), to_modes(u));
    largest = std::max(largest,
                       0.5 * std::hypot(h[2][1] - h[1][2],
                                        h[0][2] - h[2][0],
                                        h[1][0] - h[0][1]));
  }
  return dealii::Utilities::MPI::max(largest, communicator);
}


template double
largest_rotation(const SolidMesh &, const NodeFields<double> &, MPI_Comm);
template double
largest_rotation(const SolidMesh &, const NodeFields<float> &, MPI_Comm);
} // namespace contrecoup::solid
