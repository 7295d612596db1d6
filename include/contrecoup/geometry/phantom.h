// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// What the literature says of an organ or of several together.
struct OrganReference
{
  std::string name;
  std::vector<std::string> parts; ///< that belong to it; empty: all
  double volume;                  ///< [m^3]
  double tolerance;               ///< relative difference that is accepted
  std::string source;
};

/**
 * A standing man of smooth shapes: x forward, y to his left, z up; the soles
 * stand on z = 0, the origin is between the feet. Arms hang a hand's breadth
 * from the hips.
 *
 * The 50th-percentile male has the dimensions of the ANSUR-88 survey (Gordon
 * et al. 1989, means, recalled) and organs as heavy as in ICRP publication 89
 * (2002); the shapes between the measured places are ours. Skeleton and organs
 * grow with the stature alone, all lengths alike; flesh is thickened or thinned
 * until the volume is the mass over 990 kg/m^3, the mean density of a man with
 * his lungs half full (recalled).
 */
class Phantom
{
public:
  /// Declares the entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries of the current subsection.
  /// @throws InputError when stature and mass do not go together
  void parse_parameters(dealii::ParameterHandler &prm);

  /// The body; parts are brain, spinal cord, cerebrospinal fluid, skull,
  /// spine, ribs, shoulders, arm bones, pelvis, leg bones, heart, liver,
  /// lungs, skin (if it has a thickness) and soft tissue; landmarks are those
  /// of phantom::find_landmarks().
  BodyPointer create() const;

  /// What the literature says of the organs, scaled to this stature and head.
  std::vector<OrganReference> references() const;

  double mass() const
  {
    return mass_;
  }

private:
  /// The factor of the thickness of the flesh that gives the volume.
  double find_girth() const;

  double stature_ = 1.756;     ///< [m]
  double mass_ = 78.5;         ///< [kg]
  double head_scale_ = 1.;     ///< [-]
  double skin_thickness_ = 0.; ///< [m]
};

namespace phantom
{
  /// How the shapes of a phantom are made of those of the 50th percentile.
  struct Frame
  {
    double height; ///< stature over 1.756 m
    double girth;  ///< factor of the radii of flesh
    double head;   ///< factor of all of the head

    /// A point of the body below the head [m].
    dealii::Point<3> at(double x, double y, double z) const;

    /// A point given by its place relative to the centre of the cranium [m].
    dealii::Point<3> at_head(double x, double y, double z) const;
  };

  /// A node of a rod: its place for the 50th percentile, and its radius [m].
  struct Stop
  {
    double x, y, z, radius;
  };

  /**
   * A rod of flesh or bone below the head.
   *
   * @param side 1 is left, -1 mirrors it
   * @param stops the rod goes through these
   * @param thickness factor of the radii beside the stature's
   * @param n_between nodes of a smooth curve between two stops; 0 leaves the
   * rod straight
   */
  ShapePointer make_rod(const Frame &frame,
                        double side,
                        const std::vector<Stop> &stops,
                        double thickness,
                        unsigned int n_between);

  /// The outer surface.
  ShapePointer make_flesh(const Frame &frame);

  /// The bones by name: skull, spine, ribs, shoulders, arm bones, pelvis, leg
  /// bones. They do not leave room for brain, cord and fluid.
  std::vector<ShapeBody::Piece> make_skeleton(const Frame &frame);

  /// Brain, spinal cord, cerebrospinal fluid.
  std::vector<ShapeBody::Piece> make_nerves(const Frame &frame);

  /// Heart, liver, lungs.
  std::vector<ShapeBody::Piece> make_organs(const Frame &frame);

  /// Places on the skin where blast loads are usually told: forehead, vertex,
  /// occiput, throat, chest (breast bone), abdomen, back, and left and right
  /// eye, temple, ear, thigh, shin and calf.
  std::vector<Landmark> find_landmarks(const Frame &frame, const Shape &skin);
} // namespace phantom
} // namespace contrecoup
