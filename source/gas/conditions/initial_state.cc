// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/classical_fields.h>
#include <contrecoup/gas/conditions/expression_field.h>
#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/conditions/layer_fields.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/conditions/region_field.h>

namespace contrecoup::gas
{
const std::vector<std::string> initial_state_kinds{"uniform",
                                                   "regions",
                                                   "riemann",
                                                   "layers",
                                                   "sedov",
                                                   "noh",
                                                   "vortex",
                                                   "expression",
                                                   "profile"};


template <int dim>
InitialState<dim>::InitialState() = default;


template <int dim>
InitialState<dim>::~InitialState() = default;


template <int dim>
void InitialState<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Initial state");
  declare_selection(prm,
                    "Kind",
                    "uniform",
                    initial_state_kinds,
                    "State of the gas at time zero: the Background, the "
                    "Background with regions, or that of the subsection of "
                    "this name.");
  RegionField<dim>::declare_parameters(prm);
  RiemannField<dim>::declare_parameters(prm);
  LayerField<dim>::declare_parameters(prm);
  SedovField<dim>::declare_parameters(prm);
  NohField<dim>::declare_parameters(prm);
  VortexField<dim>::declare_parameters(prm);
  ExpressionField<dim>::declare_parameters(prm);
  ProfileField<dim>::declare_parameters(prm);
}


template <int dim>
void InitialState<dim>::parse_parameters(ParameterHandler &prm,
                                         const GasMaterial &material)
{
  CoarseMesh<dim> mesh;
  mesh.parse_parameters(prm);
  const Geometry geometry = mesh.geometry();
  geometry_ = geometry;
  material_ = material;

  const Section section(prm, "Initial state");
  const std::string kind = prm.get("Kind");
  if (kind == "riemann")
    field_ = std::make_unique<RiemannField<dim>>(prm, material);
  else if (kind == "layers")
    field_ = std::make_unique<LayerField<dim>>(prm, material);
  else if (kind == "sedov")
    field_ = std::make_unique<SedovField<dim>>(prm, material, geometry);
  else if (kind == "noh")
    field_ = std::make_unique<NohField<dim>>(prm, material, geometry);
  else if (kind == "vortex")
    field_ = std::make_unique<VortexField<dim>>(prm, material, geometry);
  else if (kind == "expression")
    field_ = std::make_unique<ExpressionField<dim>>(prm, material);
  else if (kind == "profile")
    field_ = std::make_unique<ProfileField<dim>>(prm, material, geometry);
  else
    field_ = std::make_unique<RegionField<dim>>(
      prm, material, geometry, kind == "regions");
}


template <int dim>
GasState<dim> InitialState<dim>::value(const dealii::Point<dim> &point) const
{
  return field_->value(point);
}


template <int dim>
GasState<dim> InitialState<dim>::ambient(const dealii::Point<dim> &point) const
{
  return field_->ambient(point);
}


template <int dim>
double InitialState<dim>::time() const
{
  return field_->time();
}


template <int dim>
const ProfileField<dim> *InitialState<dim>::profile() const
{
  return dynamic_cast<const ProfileField<dim> *>(field_.get());
}


template <int dim>
void InitialState<dim>::set_profile(std::shared_ptr<const Profile> profile,
                                    const dealii::Point<dim> &centre)
{
  field_ = std::make_unique<ProfileField<dim>>(
    std::move(profile), centre, field_->ambient(centre), material_, geometry_);
}


template <int dim>
double InitialState<dim>::smallest_feature() const
{
  return field_->smallest_feature();
}


template <int dim>
double
InitialState<dim>::distance_to_feature(const dealii::Point<dim> &point) const
{
  return field_->distance_to_feature(point);
}


template <int dim>
double
InitialState<dim>::ambient_pressure(const dealii::Point<dim> &point) const
{
  const auto background = field_->background_pressure();
  return background ? *background : field_->value(point).pressure;
}


template class InitialState<1>;
template class InitialState<2>;
template class InitialState<3>;
} // namespace contrecoup::gas
