// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/record/displacement_field.h>

namespace contrecoup::solid
{
namespace
{
  const std::vector<std::string> axes{"x", "y", "z"};

  std::vector<Expression> read_vector(const ParameterHandler &prm,
                                      const std::string &section,
                                      const std::string &quantity)
  {
    std::vector<Expression> result;
    for (const std::string &axis : axes)
    {
      const std::string name = quantity + " " + axis;
      result.emplace_back(section + "/" + name, prm.get(name));
    }
    return result;
  }
} // namespace


void InitialMotion::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Initial state");
  for (const std::string &axis : axes)
    declare_string(prm,
                   "Displacement " + axis,
                   "0",
                   "[m] Initial displacement as a muParser expression of x, "
                   "y, z and pi; its strains act suddenly.");
  for (const std::string &axis : axes)
    declare_string(
      prm,
      "Velocity " + axis,
      "0",
      "[m/s] Initial velocity as a muParser expression of x, y, z and pi.");
}


void InitialMotion::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Initial state");
  displacement_ = read_vector(prm, "Initial state", "Displacement");
  velocity_ = read_vector(prm, "Initial state", "Velocity");
}


template <typename Real>
void InitialMotion::set(const SolidMesh &mesh, NodeFields<Real> &nodes) const
{
  for (unsigned int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    {
      if (!displacement_[d].is_zero())
        nodes.displacement_of(i)[d] =
          static_cast<Real>(displacement_[d].value(mesh.nodes[i]));
      if (!velocity_[d].is_zero())
        nodes.velocity_of(i)[d] =
          static_cast<Real>(velocity_[d].value(mesh.nodes[i]));
    }
}


void ReferenceMotion::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Reference");
  declare_bool(
    prm,
    "Displacement",
    "false",
    "Whether errors against the reference displacements below are computed.");
  for (const std::string &axis : axes)
    declare_string(
      prm,
      "Displacement " + axis,
      "0",
      used_with("Reference/Displacement = true",
                "[m] Reference displacement as a muParser expression of "
                "x, y, z (undeformed coordinates), t and pi."));
  declare_string(prm,
                 "Pressure",
                 "",
                 "[Pa] Reference pressure of elements as a muParser "
                 "expression of x, y, z, t and pi; empty: none.");
}


void ReferenceMotion::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Reference");
  if (prm.get_bool("Displacement"))
    displacement_ = read_vector(prm, "Reference", "Displacement");
  if (!prm.get("Pressure").empty())
    pressure_.emplace("Reference/Pressure", prm.get("Pressure"));
}


template <typename Real>
std::vector<NamedValue>
ReferenceMotion::errors(const SolidBody<Real> &body) const
{
  std::vector<NamedValue> errors;
  if (!displacement_.empty())
    add_displacement(body, errors);
  if (pressure_)
    add_pressure(body, errors);
  return errors;
}


template <typename Real>
void ReferenceMotion::add_displacement(const SolidBody<Real> &body,
                                       std::vector<NamedValue> &errors) const
{
  const SolidMesh &mesh = body.mesh();
  std::vector<double> squares(2, 0.), largest(2, 0.);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    const double inverse_mass = body.nodes().inverse_mass_of(i);
    const double weight =
      mesh.owned[i] != 0 && inverse_mass > 0. ? 1. / inverse_mass : 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double theory = displacement_[d].value(mesh.nodes[i], body.time());
      const double error = double(body.nodes().displacement_of(i)[d]) - theory;
      squares[0] += weight * error * error;
      squares[1] += weight * theory * theory;
      largest[0] = std::max(largest[0], std::abs(error));
      largest[1] = std::max(largest[1], std::abs(theory));
    }
  }
  dealii::Utilities::MPI::sum(squares, body.communicator(), squares);
  dealii::Utilities::MPI::max(largest, body.communicator(), largest);
  errors.push_back(
    {"displacement_L2", "-", std::sqrt(squares[0] / squares[1])});
  errors.push_back({"displacement_maximum", "-", largest[0] / largest[1]});
}


template <typename Real>
void ReferenceMotion::add_pressure(const SolidBody<Real> &body,
                                   std::vector<NamedValue> &errors) const
{
  const SolidMesh &mesh = body.mesh();
  std::vector<double> sums(2, 0.);
  body.elements().visit(
    body.nodes(),
    body.times(),
    [&](const std::uint32_t cell, const ElementValues &element) {
      dealii::Point<3> middle;
      for (const std::uint32_t node : mesh.elements[cell])
        middle += mesh.nodes[node] / 8.;
      const double theory = pressure_->value(middle, body.time());
      sums[0] +=
        element.volume * std::abs(pressure_of(element.stress) - theory);
      sums[1] += element.volume * std::abs(theory);
    });
  dealii::Utilities::MPI::sum(sums, body.communicator(), sums);
  errors.push_back({"pressure_L1", "-", sums[0] / sums[1]});
}


template void InitialMotion::set(const SolidMesh &, NodeFields<double> &) const;
template void InitialMotion::set(const SolidMesh &, NodeFields<float> &) const;
template std::vector<NamedValue>
ReferenceMotion::errors(const SolidBody<double> &) const;
template std::vector<NamedValue>
ReferenceMotion::errors(const SolidBody<float> &) const;
} // namespace contrecoup::solid
