// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/image/voxel_image.h>

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace contrecoup
{
/// Parameters of segment_head().
struct HeadRules
{
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  double head_threshold = 0.25;    ///< relative to the brain's median [-]
  double fluid_threshold = 0.45;   ///< relative to the brain's median [-]
  double closing = 0.008;          ///< radius [m]
  double fluid_thickness = 0.002;  ///< [m]
  double skull_thickness = 0.0065; ///< [m]
  double scalp_thickness = 0.003;  ///< least thickness [m]
};

/// Tissue of a voxel of a head.
enum class HeadLabel : unsigned char
{
  brain = 0,
  fluid = 1,
  skull = 2,
  scalp = 3,
  outside = 255,
};

/**
 * Segments a T1-weighted image, with a mask of its brain (positive inside),
 * into brain, cerebrospinal fluid, skull and scalp. These are rules, not
 * anatomical segmentation:
 *
 * 1. The cranial cavity is the largest piece of the mask, closed with the
 *    closing radius, so that it contains the sulci, and dilated by the fluid
 *    thickness.
 * 2. Brain are the mask voxels brighter than the fluid threshold times the
 *    brain's median; the rest of the cavity, including ventricles, is fluid.
 * 3. The head are the voxels brighter than the head threshold times the
 *    median, and the cavity: the largest piece, closed with the closing
 *    radius, with everything that cannot be reached from the sides and the
 *    top.
 * 4. Skull are the head voxels within the skull thickness of the cavity,
 *    except where the scalp would be thinner than its least thickness.
 * 5. Scalp is the rest of the head, including face and neck.
 *
 * @throws InputError for an empty mask or an entirely dark image
 */
std::vector<HeadLabel> segment_head(const VoxelImage &image,
                                    const VoxelImage &mask,
                                    const HeadRules &rules);
} // namespace contrecoup
