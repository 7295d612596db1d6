// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/system/exceptions.h>

#include <gtest/gtest.h>

#include <string>

using namespace contrecoup;

namespace
{
/// The message of an expression at (0.5, 0, -1) m, 0 s.
std::string refusal(const std::string &text)
{
  try
  {
    return std::to_string(
      Expression("Load/Pressure", text).value({0.5, 0., -1.}));
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}
} // namespace

TEST(Expression, HasValuesInPlaceAndTime)
{
  const Expression expression("Load/Pressure", " x + 2*y + 3*z + 4*t*pi ");
  EXPECT_DOUBLE_EQ(expression.value({1., 1., 1.}, 0.), 6.);
  EXPECT_NEAR(expression.value({0., 0., 0.}, 1.), 12.566370614359172, 1e-14);
  EXPECT_TRUE(expression.depends_on_place());
  EXPECT_FALSE(Expression("Load/Pressure", "exp(t)").depends_on_place());
  EXPECT_TRUE(Expression("Load/Pressure", "0").is_zero());
}

TEST(Expression, SaysWhatCannotBeRead)
{
  for (const char *text : {"", "x +", "u", "sin", "1 2"})
    EXPECT_EQ(refusal(text),
              "Load/Pressure = \"" + std::string(text) +
                "\" is no muParser expression of x, y, z, t and pi");
}

TEST(Expression, IsRefusedWhereItIsNotFinite)
{
  EXPECT_EQ(refusal("1/t"),
            "Load/Pressure = \"1/t\" is infinite at (0.5, 0, -1) m and 0 s; a "
            "finite number is wanted");
  EXPECT_NE(refusal("sqrt(z)").find("is not a number at (0.5, 0, -1) m"),
            std::string::npos);
  EXPECT_NO_THROW(Expression("Load/Pressure", "1/t").value({0., 0., 0.}, 1.));
}

TEST(Expression, IsRefusedAtOnceWhenItIsNeverFinite)
{
  EXPECT_NO_THROW(Expression("Load/Pressure", "1/x"));
  for (const char *text : {"sqrt(-1)", "1/0", "log(-pi)", "-1e308*10"})
    EXPECT_THROW(Expression("Load/Pressure", text), InputError) << text;
}
