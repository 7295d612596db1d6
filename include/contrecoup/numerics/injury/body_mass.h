// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace contrecoup
{
/// Mass taken for a person of unknown mass [kg].
constexpr double usual_body_mass = 78.5;

/// Declares "Body mass" of the current subsection, a number or that of the
/// body; @p sentence says for what.
void declare_body_mass(dealii::ParameterHandler &prm,
                       const std::string &sentence);

/// Whether "Body mass" of the current subsection is that of the body.
bool is_mass_of_body(const dealii::ParameterHandler &prm);

/// Reads "Body mass" of the current subsection [kg].
/// @param phantom_mass mass of the phantom [kg]; NaN for another body, which
/// gets the usual mass
double read_body_mass(const dealii::ParameterHandler &prm, double phantom_mass);
} // namespace contrecoup
