// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/study/design.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace contrecoup::study;

namespace
{
Factor factor(const std::string &entry, const std::vector<std::string> &values)
{
  Factor result;
  result.name = entry;
  result.entries = {entry};
  for (const std::string &value : values)
    result.values.push_back({value});
  result.labels = values;
  return result;
}

std::string text_of(const Variant &variant)
{
  std::string text;
  for (const auto &[entry, value] : variant.settings)
    text += entry + value + " ";
  return text;
}

std::vector<std::string> text_of(const std::vector<Variant> &variants)
{
  std::vector<std::string> texts;
  for (const Variant &variant : variants)
    texts.push_back(text_of(variant));
  return texts;
}

const std::vector<Factor> factors = {factor("a", {"1", "2"}),
                                     factor("b", {"3", "4", "5"})};
} // namespace

TEST(Design, FullGridHasEveryCombination)
{
  EXPECT_EQ(text_of(make_design(factors, {})),
            (std::vector<std::string>{
              "a1 b3 ", "a1 b4 ", "a1 b5 ", "a2 b3 ", "a2 b4 ", "a2 b5 "}));
}

TEST(Design, OneAtATimeLeavesTheOthersAtTheirFirst)
{
  EXPECT_EQ(text_of(make_design(factors, {"one at a time"})),
            (std::vector<std::string>{"a1 b3 ", "a2 b3 ", "a1 b4 ", "a1 b5 "}));
}

TEST(Design, LatinHypercubeHitsEachPartOnce)
{
  Factor range;
  range.name = "r";
  range.entries = {"r"};
  range.is_range = true;
  range.lower = 1.;
  range.upper = 1e4;
  range.logarithmic = true;
  const unsigned int n = 20;
  const std::vector<Factor> both = {range, factor("c", {"x", "y"})};
  const auto variants = make_design(both, {"latin hypercube", n, 5});
  ASSERT_EQ(variants.size(), n);
  std::set<int> parts;
  unsigned int n_x = 0;
  for (const Variant &variant : variants)
  {
    parts.insert(static_cast<int>(std::log10(variant.numbers[0]) / 4. * n));
    n_x += variant.labels[1] == "x";
  }
  EXPECT_EQ(parts.size(), n);
  EXPECT_EQ(n_x, n / 2);
  EXPECT_EQ(text_of(make_design(both, {"latin hypercube", n, 5})),
            text_of(variants));
  EXPECT_NE(text_of(make_design(both, {"latin hypercube", n, 6})),
            text_of(variants));
  EXPECT_THROW(make_design(both, {}), contrecoup::InputError);
}

TEST(Design, RefusesTooManyVariants)
{
  const std::vector<Factor> many(
    6, factor("a", std::vector<std::string>(10, "1")));
  EXPECT_THROW(make_design(many, {}), contrecoup::InputError);
}
