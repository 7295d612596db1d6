// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/octree/scheme.h>

namespace contrecoup::gas
{
namespace
{
  std::vector<std::string> gradient_limiters_or_none()
  {
    std::vector<std::string> names = names_of(gradient_limiters);
    names.insert(names.begin(), "none");
    return names;
  }


  void declare_galerkin(ParameterHandler &prm)
  {
    const UsedWith used("Method/Scheme = discontinuous galerkin");
    declare_integer(prm,
                    "Degree",
                    "3",
                    1,
                    5,
                    "Discontinuous Galerkin: polynomial degree in a leaf.");
    declare_integer(prm,
                    "Cell degree",
                    "0",
                    0,
                    6,
                    "Discontinuous Galerkin: polynomial degree of the cells of "
                    "meshes with curved manifolds, such as hyper_ball. 0: "
                    "the largest that keeps uniform flow exactly (Degree + 1 "
                    "in 2-D, Degree / 2 + 1, rounded down, in 3-D); 1: "
                    "straight edges.");
    declare_bool(prm,
                 "Blending",
                 "true",
                 "Discontinuous Galerkin: whether troubled leaves are blended "
                 "with finite volumes on their nodes' subcells; needed "
                 "wherever there are shocks.");
    declare_double(
      prm,
      "Indicator threshold",
      "1",
      1e-6,
      1e6,
      "-",
      used_with("Method/Blending = true",
                "Discontinuous Galerkin: factor on the energy fraction of "
                "the highest modes above which a leaf is troubled; at "
                "degree 1, where the indicator is weak, 0.03 detects "
                "contacts too."));
    declare_bool(prm,
                 "Positivity",
                 "true",
                 "Discontinuous Galerkin: whether nodes without positive "
                 "density or energy are scaled towards the leaf's mean; "
                 "without it such a step fails and is repeated at half its "
                 "size.");
  }


  void declare_time_stepping(ParameterHandler &prm)
  {
    declare_selection(prm,
                      "Time stepping",
                      "ssp rk2",
                      runge_kutta_names(),
                      "Runge-Kutta method.");
    declare_double(prm,
                   "CFL number",
                   "0.4",
                   1e-6,
                   10.,
                   "-",
                   "Time step times max sum_d (|u_d| + c) / h_d, with h the "
                   "subcell size (Galerkin: the leaf size over 2 degree + 1); "
                   "densities stay positive up to 0.5, beyond 1 steps are "
                   "rejected and retried.");
    declare_integer(prm,
                    "Largest number of retries",
                    "10",
                    0,
                    50,
                    "Number of times that a step with an unphysical result is "
                    "halved before the run stops.");
  }
} // namespace


namespace
{
  void declare_precision(ParameterHandler &prm)
  {
    declare_selection(
      prm,
      "Precision",
      "double",
      {"double", "single"},
      "Floating-point format of the gas: single (3-D only) is faster "
      "and takes half the memory, but conserves mass, momentum and energy to "
      "about seven digits only and does not resolve waves weaker than 1e-6 "
      "of the pressure.");
  }
} // namespace


void Scheme::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Method");
  declare_selection(prm,
                    "Scheme",
                    "finite volume",
                    {"finite volume", "discontinuous galerkin"},
                    "Spatial discretisation within the leaves.");
  declare_integer(
    prm,
    "Subcells",
    "8",
    1,
    16,
    used_with("Method/Scheme = finite volume",
              "Finite volume: subcells of a leaf in each direction; 1 "
              "or an even number where leaves of different sizes meet."));
  declare_selection(
    prm,
    "Reconstruction",
    "linear",
    {"constant", "linear"},
    used_with("Method/Scheme = finite volume",
              "Finite volume: reconstruction within a subcell; constant is "
              "first order, linear second order."));
  declare_selection(prm,
                    "Limiter",
                    "mc",
                    names_of(slope_limiters),
                    "Limiter of the slopes, in finite volumes and in the "
                    "subcells of troubled Galerkin leaves: " +
                      help_of(slope_limiters) + ".");
  declare_selection(prm,
                    "Gradient limiter",
                    "none",
                    gradient_limiters_or_none(),
                    "Finite volume on meshes other than boxes: "
                    "multidimensional limiter of the gradient; at the faces "
                    "between leaves Limiter is used. none uses Limiter "
                    "everywhere, direction by direction; " +
                      help_of(gradient_limiters) + ".");
  declare_galerkin(prm);
  declare_selection(prm,
                    "Flux",
                    "hllc shock stable",
                    names_of(riemann_fluxes),
                    "Riemann flux between subcells and between leaves: " +
                      help_of(riemann_fluxes) + ".");
  declare_time_stepping(prm);
  declare_precision(prm);
}


void Scheme::parse_parameters(ParameterHandler &prm, const unsigned int dim)
{
  const Section section(prm, "Method");
  kind = prm.get("Scheme") == "finite volume" ? Kind::finite_volume
                                              : Kind::discontinuous_galerkin;
  linear_reconstruction = prm.get("Reconstruction") == "linear";
  limiter = find_choice(slope_limiters, prm.get("Limiter"), "slope limiter");
  gradient_limiter.reset();
  if (prm.get("Gradient limiter") != "none")
    gradient_limiter = find_choice(
      gradient_limiters, prm.get("Gradient limiter"), "gradient limiter");
  flux = find_choice(riemann_fluxes, prm.get("Flux"), "Riemann flux");
  time_stepping = parse_runge_kutta(prm.get("Time stepping"));
  precision = prm.get("Precision") == "single" ? Precision::single_precision
                                               : Precision::double_precision;
  cfl = read_double(prm, "CFL number");
  blending = prm.get_bool("Blending");
  indicator_threshold = read_double(prm, "Indicator threshold");
  positivity = prm.get_bool("Positivity");
  largest_retries = read_unsigned(prm, "Largest number of retries");
  n_points = kind == Kind::finite_volume ? read_unsigned(prm, "Subcells")
                                         : read_unsigned(prm, "Degree") + 1;
  if (precision == Precision::single_precision && dim < 3)
    throw InputError("Method/Precision = single works in 3-D; with "
                     "Domain/Dimension = " +
                     std::to_string(dim) + " use double");
  cell_degree = 1;
  if (kind == Kind::discontinuous_galerkin)
  {
    const unsigned int largest = largest_cell_degree(degree(), dim);
    cell_degree = read_unsigned(prm, "Cell degree");
    if (cell_degree > largest)
      throw InputError("Method/Cell degree = " + std::to_string(cell_degree) +
                       ": with Method/Degree = " + std::to_string(degree()) +
                       " in " + std::to_string(dim) + "-D at most " +
                       std::to_string(largest) +
                       " keeps uniform flow; 0 chooses it");
    if (cell_degree == 0)
      cell_degree = largest;
  }
  if (kind == Kind::finite_volume && linear_reconstruction && n_points == 1)
    throw InputError("Method/Reconstruction = linear needs Method/Subcells "
                     "of 2 or more (8 is a good number in " +
                     std::to_string(dim) +
                     "-D); with one subcell use constant");
}


void Scheme::check_mesh(const bool is_axis_aligned) const
{
  if (is_axis_aligned && gradient_limiter)
    throw InputError("Method/Gradient limiter: for Domain/Mesh = box only "
                     "none is available");
  if (gradient_limiter && kind == Kind::discontinuous_galerkin)
    throw InputError("Method/Gradient limiter: for Method/Scheme = "
                     "discontinuous galerkin only none is available");
}


double Scheme::stability_limit() const
{
  return kind == Kind::finite_volume ? 1. / n_points
                                     : 1. / (2. * degree() + 1.);
}
} // namespace contrecoup::gas
