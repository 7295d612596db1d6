// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/geometry/body/inserted_organs.h>
#include <contrecoup/geometry/body/phantom.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

#include <gtest/gtest.h>

#include <map>

using namespace contrecoup;
using dealii::Point;

namespace
{
BodyPointer make_man()
{
  dealii::ParameterHandler prm;
  Phantom::declare_parameters(prm);
  Phantom description;
  description.parse_parameters(prm);
  return description.create();
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
} // namespace


TEST(InsertedOrgans, GrowWithThePersonAndStayInPlace)
{
  const BodyPointer man = make_man();
  const auto donor = std::dynamic_pointer_cast<const ShapeBody>(man);
  ASSERT_TRUE(donor);
  const dealii::Tensor<1, 3> shift({2., -1., 0.});
  const auto larger = std::make_shared<PlacedShape>(
    man->surface(), Placement(1.1, dealii::Tensor<1, 3>(), shift));
  const BodyPointer person = insert_organs(filled(larger), *donor, 0.01);
  const auto before = volumes(*man, 0.01), after = volumes(*person, 0.011);
  for (const std::string name : {"brain", "lungs", "liver", "pelvis"})
    EXPECT_NEAR(
      after.at(name), std::pow(1.1, 3) * before.at(name), 0.02 * after.at(name))
      << name;
  ASSERT_EQ(person->landmarks().size(), man->landmarks().size());
  for (std::size_t i = 0; i < man->landmarks().size(); ++i)
    EXPECT_LT(person->landmarks()[i].place.distance(
                1.1 * man->landmarks()[i].place + shift),
              1e-3);
  ASSERT_EQ(person->remarks().size(), 1U);
  EXPECT_NE(person->remarks()[0].find("not this person's"), std::string::npos);
}


TEST(InsertedOrgans, ThatDoNotFitAreRefused)
{
  const auto donor = std::dynamic_pointer_cast<const ShapeBody>(make_man());
  const auto ball = std::make_shared<Sphere>(Point<3>(0., 0., 1.), 0.9);
  EXPECT_NO_THROW(insert_organs(filled(ball), *donor, 1.));
  const auto needle =
    std::make_shared<Ellipsoid>(Point<3>(0., 0., 1.), Point<3>(0.1, 0.1, 0.9));
  EXPECT_THROW(insert_organs(filled(needle), *donor, 0.1), InputError);
}
