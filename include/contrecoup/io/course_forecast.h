// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/trial_run.h>

namespace contrecoup
{
namespace io
{
  /**
   * The course of a scene, from two trial runs on coarser meshes. What a moment
   * costs grows from mesh to mesh as it did at that moment from one trial to
   * the other: finer meshes are dear where fronts are, hardly dearer where the
   * scene's limits keep cells coarse. Each stage costs the seconds given.
   * @param before the coarser trial; without stages if there was only one
   * @param seconds of the scene's stages, as many as the last trial has
   */
  ExpectedCourse forecast_course(const Trial &before,
                                 const Trial &last,
                                 const std::vector<double> &seconds);
} // namespace io
} // namespace contrecoup
