// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/voxel_image.h>

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace contrecoup
{
/// The rules by which segment_head() makes tissues of a T1-weighted image.
struct HeadRules
{
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  double head_threshold = 0.25;    ///< over the brain's median [-]
  double fluid_threshold = 0.45;   ///< over the brain's median [-]
  double closing = 0.008;          ///< radius [m]
  double fluid_thickness = 0.002;  ///< [m]
  double skull_thickness = 0.0065; ///< [m]
  double scalp_thickness = 0.003;  ///< the least [m]
};

/// What a voxel of a head is.
enum class HeadLabel : unsigned char
{
  brain = 0,
  fluid = 1,
  skull = 2,
  scalp = 3,
  outside = 255,
};

/**
 * Makes brain, cerebrospinal fluid, skull and scalp of a T1-weighted image and
 * a mask of its brain (above 0). These are rules, not a reading of the anatomy:
 *
 * 1. The cranial cavity is the largest piece of the mask, closed by the closing
 *    radius so that the furrows belong to it, and grown by the fluid's
 *    thickness.
 * 2. Brain is what of the mask is brighter than the fluid threshold times the
 *    brain's median; the rest of the cavity is fluid, ventricles included.
 * 3. The head is what is brighter than the head threshold times the median, or
 *    in the cavity; its largest piece, closed by the closing radius, with all
 *    that cannot be reached from the sides and the top.
 * 4. Skull is what of the head is within its thickness of the cavity, but not
 *    where the scalp would be thinner than its least thickness.
 * 5. Scalp is the rest of the head, with face and neck.
 * @throws InputError when the mask is empty, or all of the image is dark
 */
std::vector<HeadLabel> segment_head(const VoxelImage &image,
                                    const VoxelImage &mask,
                                    const HeadRules &rules);
} // namespace contrecoup
