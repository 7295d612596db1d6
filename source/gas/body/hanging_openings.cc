// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/hanging_openings.h>

namespace contrecoup::gas
{
template <int dim, typename Real>
void HangingOpenings<dim, Real>::reinit(const HangingGroup<dim> &group,
                                        const LeafMesh<dim> &mesh,
                                        const LeafLayout &layout,
                                        const CutLeaves<dim> &cut_leaves)
{
  const unsigned int side = group.coarse_face, fine_side = group.match.face;
  const unsigned int n = layout.n_face_points;
  const auto touches = [&](const unsigned int leaf,
                           const unsigned int point,
                           const unsigned int face) {
    return cut_leaves.opening({leaf, point}, face) > 0. ? 1. : 0.;
  };
  for (auto &values : along)
    values.resize(n);
  below.resize(n);
  for (unsigned int part = 0; part < n_fine; ++part)
  {
    opening[part].resize(n);
    fine_below[part].resize(n);
    for (auto &values : fraction[part])
      values.resize(n);
  }
  for (unsigned int lane = 0; lane < layout.width; ++lane)
    is_cut[lane] = cut_leaves.is_cut_face(group.face[lane]) ? 1. : 0.;
  for (unsigned int lane = 0; lane < layout.width; ++lane)
    for (unsigned int q = 0; q < n; ++q)
    {
      const unsigned int coarse = group.coarse_leaf[lane];
      const unsigned int point = layout.face_point(side, q, 0);
      below[q][lane] = touches(coarse, point, side ^ 1U);
      for (unsigned int d = 0, t = 0; d < dim; ++d)
        if (d != side / 2)
          along[t++][q][lane] = touches(coarse, point, 2 * d + 1);
      for (unsigned int part = 0; part < n_fine; ++part)
      {
        // Where this rank needs no leaf, another one stands in for it.
        const unsigned int fine = group.fine_leaf[part][lane];
        const unsigned int first = layout.face_point(fine_side, q, 0);
        const unsigned int second = layout.face_point(fine_side, q, 1);
        HangingFace<dim> face = mesh.hanging_faces()[group.face[lane]];
        face.fine_leaf[part] = fine;
        const double open = cut_leaves.hanging_opening(face, part, q);
        const double inner = touches(fine, first, fine_side ^ 1U);
        opening[part][q][lane] = open;
        fine_below[part][q][lane] = inner;
        const auto &fractions = cut_leaves.fractions();
        fraction[part][0][q][lane] = open > 0. ? fractions(fine, first) : 0.;
        fraction[part][1][q][lane] =
          open > 0. ? fractions(fine, second) * inner : 0.;
      }
    }
}


template struct HangingOpenings<2, double>;
template struct HangingOpenings<3, double>;
template struct HangingOpenings<3, float>;
} // namespace contrecoup::gas
