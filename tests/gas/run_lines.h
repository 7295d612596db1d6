// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/scheme.h>

#include <cmath>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Lines joined to one list.
inline std::vector<std::string> operator+(std::vector<std::string> a,
                                          const std::vector<std::string> &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}


/// A scheme with @p n points along an edge.
inline Scheme make_scheme(const bool is_galerkin, const unsigned int n)
{
  Scheme scheme;
  scheme.kind = is_galerkin ? Scheme::Kind::discontinuous_galerkin
                            : Scheme::Kind::finite_volume;
  scheme.n_points = n;
  return scheme;
}


/// Lines for finite volumes with @p n subcells a side.
inline std::vector<std::string> finite_volume(const unsigned int n)
{
  return {"Method/Scheme=finite volume",
          "Method/Subcells=" + std::to_string(n),
          std::string("Method/Reconstruction=") +
            (n == 1 ? "constant" : "linear")};
}


/// Lines for a Galerkin scheme.
inline std::vector<std::string> galerkin(const unsigned int degree)
{
  return {"Method/Scheme=discontinuous galerkin",
          "Method/Degree=" + std::to_string(degree),
          "Method/Time stepping=ssp rk3"};
}


/// Lines for a mixture of TNT products and air.
inline std::vector<std::string> products_in_air()
{
  return {"Material/Equation of state=jwl in air", "Material/Explosive=tnt"};
}


/// Numbers between -1 and 1 that look irregular, the same on every rank.
inline double ripple(const double x, const unsigned int seed)
{
  return std::sin(6.283185307179586 * x * (1 + seed % 3) + 1.7 * seed);
}
} // namespace contrecoup::gas
