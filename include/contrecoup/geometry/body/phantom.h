// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/organ_check.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/**
 * A standing man of smooth shapes: x forward, y to his left, z up; the soles
 * are at z = 0, the origin is between the feet. The arms hang a hand's breadth
 * from the hips.
 *
 * The 50th-percentile male has the mean dimensions of the ANSUR-88 survey
 * (Gordon et al. 1989, recalled) and the organ masses of ICRP publication 89
 * (2002); shapes between measured places are our choice. Skeleton and organs
 * scale with stature only, uniformly in all directions. The thickness of flesh
 * is adjusted until the volume is the mass over 990 kg/m^3, the mean density
 * of a man with half-full lungs (recalled).
 */
class Phantom
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError when stature and mass do not fit each other
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Creates the body. Its parts are brain, spinal cord, cerebrospinal fluid,
  /// skull, spine, ribs, shoulders, arm bones, pelvis, leg bones, heart,
  /// liver, lungs, skin (if its thickness is positive) and soft tissue. Its
  /// landmarks are those of phantom::find_landmarks().
  BodyPointer create() const;

  /// Literature data on the organs, scaled to this stature and head.
  std::vector<OrganReference> references() const;

  double mass() const
  {
    return mass_;
  }

private:
  /// Factor on the thickness of flesh that gives the prescribed volume.
  double find_girth() const;

  double stature_ = 1.756;     ///< [m]
  double mass_ = 78.5;         ///< [kg]
  double head_scale_ = 1.;     ///< [-]
  double skin_thickness_ = 0.; ///< [m]
};

namespace phantom
{
  /// Scale factors from the 50th percentile to a phantom.
  struct Frame
  {
    double height; ///< stature over 1.756 m
    double girth;  ///< factor on the radii of flesh
    double head;   ///< factor on the whole head

    /// Scales a point of the body below the head [m].
    dealii::Point<3> at(double x, double y, double z) const;

    /// Scales a point given relative to the centre of the cranium [m].
    dealii::Point<3> at_head(double x, double y, double z) const;
  };

  /// A node of a rod: position in the 50th percentile, and radius [m].
  struct RodNode
  {
    double x, y, z, radius;
  };

  /**
   * Creates a rod of flesh or bone below the head.
   *
   * @param side 1: left, -1: mirrored to the right
   * @param rod_nodes nodes of the rod
   * @param thickness additional factor on the radii
   * @param n_between number of nodes of a smooth curve between two nodes;
   * 0: straight
   */
  ShapePointer make_rod(const Frame &frame,
                        double side,
                        const std::vector<RodNode> &rod_nodes,
                        double thickness,
                        unsigned int n_between);

  /// Creates the outer surface.
  ShapePointer make_flesh(const Frame &frame);

  /// Creates the bones: skull, spine, ribs, shoulders, arm bones, pelvis, leg
  /// bones. Brain, cord and fluid are not cut out.
  std::vector<ShapeBody::PartShape> make_skeleton(const Frame &frame);

  /// Creates brain, spinal cord and cerebrospinal fluid.
  std::vector<ShapeBody::PartShape> make_nerves(const Frame &frame);

  /// Creates heart, liver and lungs.
  std::vector<ShapeBody::PartShape> make_organs(const Frame &frame);

  /// Finds the points of the skin at which blast loads are usually reported:
  /// forehead, vertex, occiput, throat, chest (breast bone), abdomen, back,
  /// and left and right eye, temple, ear, thigh, shin and calf.
  std::vector<Landmark> find_landmarks(const Frame &frame, const Shape &skin);
} // namespace phantom
} // namespace contrecoup
