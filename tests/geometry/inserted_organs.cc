// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/inserted_organs.h>
#include <contrecoup/geometry/body/organ_fit.h>
#include <contrecoup/geometry/body/person_posture.h>
#include <contrecoup/geometry/body/phantom.h>
#include <contrecoup/geometry/mesh/hex_mesh.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <map>

using namespace contrecoup;
using dealii::Point;

namespace
{
BodyPointer make_man(const std::string &stature = "1.756",
                     const std::string &mass = "78.5")
{
  return described<Phantom>({"Stature=" + stature, "Mass=" + mass}).create();
}


std::map<std::string, double> volumes(const Body &body, const double spacing)
{
  std::map<std::string, double> result;
  LabelGrid grid = make_grid(body.surface()->bounding_box(), spacing);
  body.fill(grid);
  for (const unsigned char label : grid.labels)
    if (label != LabelGrid::outside)
      result[body.parts()[label].name] += grid.volume();
  return result;
}


ShapeBody filled(const ShapePointer &surface)
{
  return ShapeBody(surface, {{{"flesh", Tissue::soft_tissue}, surface}});
}

const ShapeBody &donor()
{
  static const auto man =
    std::dynamic_pointer_cast<const ShapeBody>(make_man());
  return *man;
}


ShapePointer turned(const ShapePointer &shape,
                    double x,
                    double y,
                    double z,
                    double shift = 0.)
{
  const double degree = dealii::numbers::PI / 180.;
  return std::make_shared<PlacedShape>(
    shape,
    Placement(1., degree * Point<3>(x, y, z), Point<3>(shift, -shift, shift)));
}


/// Part of a shape within a box.
ShapePointer
cut(const ShapePointer &shape, const Point<3> &lower, const Point<3> &upper)
{
  return std::make_shared<Intersection>(
    shape,
    std::make_shared<RoundedBox>(Point<3>(0.5 * (lower + upper)),
                                 0.5 * (upper - lower)));
}


OrganInsertion allowing(const double largest_loss)
{
  OrganInsertion insertion;
  insertion.largest_loss = largest_loss;
  return insertion;
}


std::string refusal(const ShapePointer &surface)
{
  try
  {
    insert_organs(filled(surface), donor(), allowing(1.));
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace


TEST(InsertedOrgans, OfTheOwnSkinStayAsTheyAre)
{
  ShapeBody man = donor();
  man.set_remarks({"from a man"});
  const BodyPointer person =
    insert_organs(filled(man.surface()), man, allowing(0.01));
  EXPECT_EQ(person->remarks().back(), "from a man");
  const auto before = volumes(donor(), 0.006), after = volumes(*person, 0.006);
  for (const auto &[name, volume] : before)
    if (name != "soft tissue")
    {
      EXPECT_NEAR(after.at(name), volume, 0.01 * volume) << name;
    }
  ASSERT_TRUE(person->organ_fit());
  EXPECT_GT(person->organ_fit()->inside, 0.999);
  EXPECT_TRUE(person->organ_fit()->holds());
}


// The surface that `anatomy` writes has steps as large as its elements.
TEST(InsertedOrgans, OfASkinOfCubesKeepTheirSize)
{
  LabelGrid grid = make_grid(donor().surface()->bounding_box(), 0.012);
  donor().fill(grid);
  const HexMesh hexahedra = make_hex_mesh(grid, donor().parts());
  TriangleMesh skin;
  skin.vertices = hexahedra.nodes;
  for (const HexMesh::Facet &facet : hexahedra.boundary)
    for (const unsigned int v : {1, 2})
      skin.triangles.push_back(
        {{facet.nodes[0], facet.nodes[v], facet.nodes[v + 1]}});
  const BodyPointer person =
    insert_organs(filled(std::make_shared<TriangulatedSurface>(skin)),
                  donor(),
                  allowing(0.02));
  const auto before = volumes(donor(), 0.006), after = volumes(*person, 0.006);
  for (const std::string name : {"brain", "lungs", "liver"})
    EXPECT_NEAR(after.at(name), before.at(name), 0.1 * before.at(name)) << name;
}


TEST(InsertedOrgans, GrowWithThePersonAndStayInPlace)
{
  const dealii::Tensor<1, 3> shift({2., -1., 0.});
  const auto larger = std::make_shared<PlacedShape>(
    donor().surface(), Placement(1.1, dealii::Tensor<1, 3>(), shift));
  const BodyPointer person =
    insert_organs(filled(larger), donor(), allowing(0.01));
  const auto before = volumes(donor(), 0.01), after = volumes(*person, 0.011);
  for (const std::string name : {"brain", "lungs", "liver", "pelvis"})
    EXPECT_NEAR(
      after.at(name), std::pow(1.1, 3) * before.at(name), 0.02 * after.at(name))
      << name;
  ASSERT_EQ(person->landmarks().size(), donor().landmarks().size());
  for (std::size_t i = 0; i < donor().landmarks().size(); ++i)
    EXPECT_LT(person->landmarks()[i].place.distance(
                1.1 * donor().landmarks()[i].place + shift),
              1e-3);
  ASSERT_EQ(person->remarks().size(), 4U);
  EXPECT_NE(person->remarks()[0].find("faces +x, 0 degrees"),
            std::string::npos);
  EXPECT_NE(person->remarks()[1].find("not this person's"), std::string::npos);
}


TEST(InsertedOrgans, FitOtherBuildsInAnyDirection)
{
  struct Case
  {
    std::string stature, mass;
    double angle;
  };
  for (const Case &build : {Case{"1.55", "44", 30.},
                            Case{"1.6", "82", -75.},
                            Case{"2.0", "72", 200.}})
  {
    const BodyPointer man = make_man(build.stature, build.mass);
    const BodyPointer person = insert_organs(
      filled(turned(man->surface(), 0., 0., build.angle, 0.3)), donor(), {});
    const OrganFit &fit = *person->organ_fit();
    EXPECT_TRUE(fit.holds())
      << build.stature << " m, inside " << fit.inside << ", brain "
      << fit.brain_cover << ", lungs " << fit.lung_cover;
    const auto organs = volumes(*person, 0.008);
    EXPECT_GT(organs.at("lungs"), 1.2e-3);
    EXPECT_GT(organs.at("brain"), 0.8e-3);
  }
}


TEST(InsertedOrgans, FollowAPersonWhoLiesOrStandUp)
{
  // On the back, the head to -y.
  const ShapePointer lying = turned(donor().surface(), 90., 0., 90.);
  OrganInsertion insertion;
  const BodyPointer standing = insert_organs(filled(lying), donor(), insertion);
  EXPECT_NEAR(standing->surface()->bounding_box().side_length(2), 1.756, 0.01);
  EXPECT_NE(standing->remarks()[0].find("Body/Surface/Posture = as given"),
            std::string::npos);
  insertion.stands_up = false;
  const BodyPointer person = insert_organs(filled(lying), donor(), insertion);
  EXPECT_LT(person->surface()->bounding_box().side_length(2), 0.8);
  const Posture posture = find_posture(*lying, {}).posture;
  const auto brain =
    std::find_if(donor().parts().begin(),
                 donor().parts().end(),
                 [](const BodyPart &part) { return part.name == "brain"; });
  const Point<3> middle(0., 0., 1.756 - 0.0745);
  EXPECT_EQ(person->part_at(posture.from_standing().apply(middle)),
            brain - donor().parts().begin());
  EXPECT_TRUE(person->organ_fit()->holds());
}


TEST(InsertedOrgans, RequireOneWholeAdult)
{
  const ShapePointer man = donor().surface();
  const double far = 3.;
  EXPECT_NE(refusal(cut(man, {-far, -far, 0.95}, {far, far, far}))
              .find("no ankles were found"),
            std::string::npos);
  EXPECT_NE(refusal(cut(man, {-far, -far, 0.}, {far, far, 1.2}))
              .find("legs do not join below 58 % of its height"),
            std::string::npos);
  EXPECT_NE(refusal(cut(man, {-far, 0., 0.}, {far, far, far}))
              .find("1 ankle(s) were found"),
            std::string::npos);
  const auto two = std::make_shared<Union>(
    std::vector<ShapePointer>{man, turned(man, 0., 0., 0., 1.)});
  EXPECT_NE(refusal(two).find("it must be one person"), std::string::npos);
  EXPECT_NE(refusal(std::make_shared<Sphere>(Point<3>(0., 0., 1.), 0.9))
              .find("one person"),
            std::string::npos);
  EXPECT_NE(refusal(std::make_shared<Ellipsoid>(Point<3>(0., 0., 1.),
                                                Point<3>(0.1, 0.1, 0.9)))
              .find("one person"),
            std::string::npos);
  // Where everything fits but the limit.
  OrganInsertion insertion;
  insertion.largest_loss = 0.;
  const BodyPointer thin = make_man("1.55", "42");
  EXPECT_THROW(insert_organs(filled(thin->surface()), donor(), insertion),
               InputError);
}


namespace
{
ShapePointer moved(const ShapePointer &shape, const Point<3> &shift)
{
  return std::make_shared<PlacedShape>(
    shape, Placement(1., dealii::Tensor<1, 3>(), shift));
}


ShapePointer with_neck(const double radius)
{
  return std::make_shared<Union>(std::vector<ShapePointer>{
    donor().surface(),
    std::make_shared<Cylinder>(
      Point<3>(0., 0., 1.35), Point<3>(0., 0., 1.66), radius)});
}


/// The donor's trunk and head on a seat 0.4 m high, next to which the hands
/// hang, thighs along x at a height, and the donor's lower legs before it.
ShapePointer seated_man(const double thigh)
{
  const double far = 3., seat = 0.4, knee = 0.48;
  std::vector<ShapePointer> parts{
    moved(cut(donor().surface(), {-far, -far, 0.84}, {far, far, far}),
          {0., 0., seat - 0.84}),
    moved(cut(donor().surface(), {-far, -far, 0.}, {far, far, knee}),
          {0.42, 0., 0.})};
  for (const double side : {0.1, -0.1})
    parts.push_back(std::make_shared<RoundedBox>(
      Point<3>(0.22, side, thigh), Point<3>(0.26, 0.08, 0.07), 0.06));
  for (const double from : {-far, 0.2})
    parts.push_back(moved(
      cut(donor().surface(), {-far, from, 0.}, {far, from + far - 0.2, 0.85}),
      {0., 0., seat - 0.84}));
  return std::make_shared<Union>(parts);
}
} // namespace


TEST(InsertedOrgans, FitAThickNeck)
{
  const BodyPointer man =
    insert_organs(filled(with_neck(0.07)), donor(), allowing(0.03));
  EXPECT_TRUE(man->organ_fit()->holds());
  const double brain = volumes(donor(), 0.006).at("brain");
  EXPECT_NEAR(volumes(*man, 0.006).at("brain"), brain, 0.05 * brain);
  // As wide as the head: a person may say where the neck is.
  const ShapePointer wide = with_neck(0.1);
  EXPECT_NE(refusal(wide).find("the least section of trunk and head is at"),
            std::string::npos);
  EXPECT_NE(refusal(wide).find("Body/Surface/Neck height says where it is"),
            std::string::npos);
  OrganInsertion insertion = allowing(0.03);
  insertion.neck_height = 1.49;
  EXPECT_GT(
    insert_organs(filled(wide), donor(), insertion)->organ_fit()->inside, 0.97);
  insertion.neck_height = 0.9;
  EXPECT_THROW(insert_organs(filled(wide), donor(), insertion), InputError);
}


TEST(InsertedOrgans, FitAChild)
{
  dealii::ParameterHandler prm;
  Phantom::declare_parameters(prm);
  prm.set("Stature", "1.4");
  prm.set("Mass", "35");
  prm.set("Head scale", "1.15");
  Phantom description;
  description.parse_parameters(prm);
  const auto skin = std::make_shared<PlacedShape>(
    description.create()->surface(),
    Placement(0.8, dealii::Tensor<1, 3>(), dealii::Tensor<1, 3>()));
  OrganInsertion insertion = allowing(0.05);
  const BodyPointer child = insert_organs(filled(skin), donor(), insertion);
  EXPECT_NEAR(child->surface()->bounding_box().side_length(2), 1.12, 0.05);
  EXPECT_GT(child->organ_fit()->inside, OrganFit::least_inside);
  EXPECT_GT(child->organ_fit()->brain_cover, OrganFit::least_cover);
  // A child's head is large for its height.
  EXPECT_GT(volumes(*child, 0.005).at("brain"), 0.5e-3);
}


// On thighs as low as the trunk, and on lower ones, which are followed as legs
// to the hip.
TEST(InsertedOrgans, BendTheLegsOfWhoSits)
{
  EXPECT_FALSE(find_regions(*donor().surface()).thigh_height);
  unsigned int bones = 0;
  while (donor().parts()[bones].name != "leg bones")
    ++bones;
  for (const double thigh : {0.47, 0.44})
  {
    const ShapePointer skin = seated_man(thigh);
    const PersonRegions regions = find_regions(*skin);
    ASSERT_TRUE(regions.thigh_height);
    EXPECT_NEAR(*regions.thigh_height, thigh, 0.03);
    EXPECT_NEAR(regions.stature(), 1.756, 0.1);
    // Neither hands next to the shins nor parts under the trunk are legs.
    const LabelGrid &grid = regions.grid;
    for (std::size_t v = 0; v < grid.labels.size(); ++v)
      if (regions.is(v, Region::left_leg) || regions.is(v, Region::right_leg))
      {
        ASSERT_LT(
          std::abs(grid.center(0, v / grid.size[0] % grid.size[1], 0)[1]),
          0.24);
        ASSERT_GT(grid.center(v % grid.size[0], 0, 0)[0], 0.2);
      }
    EXPECT_LT(regions.arm_tip[0][2], 0.3);

    const BodyPointer person =
      insert_organs(filled(skin), donor(), allowing(0.1));
    // Bones lie along both thighs and stand in both lower legs, and no others
    // are there.
    for (const double side : {0.1, -0.1})
    {
      const auto is_bone = [&](const double x, const double z) {
        for (double y = side - 0.05; y < side + 0.05; y += 0.004)
          for (double d = -0.05; d < 0.05; d += 0.004)
            if (person->part_at(x > 0.38 ? Point<3>(x + d, y, z)
                                         : Point<3>(x, y, z + d)) == bones)
              return true;
        return false;
      };
      for (const double x : {0.1, 0.2, 0.3})
        EXPECT_TRUE(is_bone(x, thigh)) << x << " " << side;
      for (const double z : {0.1, 0.2, 0.3, 0.4})
        EXPECT_TRUE(is_bone(0.42, z)) << z << " " << side;
    }
    EXPECT_GT(person->organ_fit()->inside, OrganFit::least_inside);
    EXPECT_NE(person->remarks()[1].find("the person sits"), std::string::npos);
    std::map<std::string, Point<3>> places;
    for (const Landmark &landmark : person->landmarks())
      places[landmark.name] = landmark.place;
    EXPECT_NEAR(places.at("left thigh")[0], 0.21, 0.06);
    EXPECT_NEAR(places.at("left thigh")[2], thigh + 0.07, 0.03);
    EXPECT_NEAR(places.at("left shin")[0], 0.48, 0.05);
  }
}


// At angles from those of who stands to those of a cross.
TEST(InsertedOrgans, PutPlacesOfArmsOnArmsThatAreApart)
{
  constexpr double far = 3., length = 0.62, radius = 0.045;
  for (const double degrees : {25., 45., 90.})
  {
    const double angle = degrees * dealii::numbers::PI / 180.;
    std::vector<ShapePointer> parts{
      cut(donor().surface(), {-far, -0.17, 0.}, {far, 0.17, far})};
    std::map<std::string, Point<3>> shoulders;
    std::map<std::string, ShapePointer> arms;
    for (const double side : {1., -1.})
    {
      const std::string name =
        (side > 0. ? "left" : "right") + std::string(" upper arm");
      const Point<3> shoulder(0., 0.17 * side, 1.38);
      const dealii::Tensor<1, 3> along(
        {0., side * std::sin(angle), -std::cos(angle)});
      shoulders[name] = shoulder;
      arms[name] =
        std::make_shared<Cylinder>(shoulder, shoulder + length * along, radius);
      parts.push_back(arms[name]);
    }
    const BodyPointer person = insert_organs(
      filled(std::make_shared<Union>(parts)), donor(), allowing(0.1));
    for (const Landmark &landmark : person->landmarks())
      if (arms.count(landmark.name) > 0)
      {
        const double along = landmark.place.distance(shoulders[landmark.name]);
        EXPECT_NEAR(arms[landmark.name]->value(landmark.place), 0., 0.002)
          << landmark.name << " at " << landmark.place << ", " << degrees;
        EXPECT_GT(along, radius) << degrees;
        EXPECT_LT(along, 0.4 * length) << degrees;
      }
  }
}


TEST(PersonPosture, FacingIsFoundInEightDirections)
{
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 45. * i + 7.;
    const Posture posture =
      find_posture(*turned(donor().surface(), 0., 0., angle, 0.5), {}).posture;
    EXPECT_TRUE(posture.is_standing);
    EXPECT_TRUE(posture.face_agrees);
    EXPECT_NEAR(std::remainder(posture.facing() - angle, 360.), 0., 1.5);
  }
  const Posture given = find_posture(*donor().surface(), 90.).posture;
  EXPECT_NEAR(given.facing(), 90., 1e-9);
  EXPECT_FALSE(given.face_agrees && given.forward[0] > 0.5);
}


TEST(PersonPosture, LyingAndUpsideDownAreTurnedUp)
{
  struct Case
  {
    Point<3> angles; ///< that lay the man down [degrees]
    Point<3> up, forward;
  };
  for (const Case &pose : {Case{{0., 90., 0.}, {1., 0., 0.}, {0., 0., -1.}},
                           Case{{0., -90., 0.}, {-1., 0., 0.}, {0., 0., 1.}},
                           Case{{90., 0., 0.}, {0., -1., 0.}, {1., 0., 0.}},
                           Case{{90., 0., 90.}, {1., 0., 0.}, {0., 1., 0.}},
                           Case{{180., 0., 0.}, {0., 0., -1.}, {1., 0., 0.}}})
  {
    const Posture posture = find_posture(*turned(donor().surface(),
                                                 pose.angles[0],
                                                 pose.angles[1],
                                                 pose.angles[2]),
                                         {})
                              .posture;
    EXPECT_FALSE(posture.is_standing);
    EXPECT_LT((posture.up - pose.up).norm(), 1e-9);
    EXPECT_LT((posture.forward - pose.forward).norm(), 0.02);
    const Point<3> head = posture.to_standing().apply(Point<3>(pose.up));
    EXPECT_LT(head.distance(Point<3>(0., 0., 1.)), 1e-9);
    EXPECT_LT(posture.from_standing().apply(head).distance(Point<3>(pose.up)),
              1e-12);
  }
}
