// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/study/factor.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::study;

namespace
{
/// Factors from overrides such as "a/Entry=Method/CFL number".
std::vector<Factor> read(const std::vector<std::string> &overrides)
{
  ParameterHandler prm;
  {
    const Section section(prm, "Vary *");
    Factor::declare_parameters(prm);
  }
  set_entries(prm, overrides, "Vary ");
  return parse_factors(prm);
}
} // namespace

TEST(Factor, VariesOneEntry)
{
  const auto factors = read({"cells/Entry=Domain/Coarse leaves",
                             "cells/Values=25, 25; 50, 50;",
                             "cells/Refinement=by count"});
  ASSERT_EQ(factors.size(), 1u);
  EXPECT_EQ(factors[0].name, "cells");
  EXPECT_EQ(factors[0].labels, (std::vector<std::string>{"25, 25", "50, 50"}));
  EXPECT_EQ(factors[0].settings(1),
            (Settings{{"Domain/Coarse leaves", "50, 50"}}));
  EXPECT_EQ(factors[0].number(1), 50.);
  EXPECT_EQ(factors[0].refinement, Refinement::by_count);
}

TEST(Factor, RefinesBySize)
{
  const auto factors = read({"cells/Entry=Mesh/Cell size",
                             "cells/Values=0.01; 0.005",
                             "cells/Labels=10 mm; 5 mm",
                             "cells/Refinement=by size"});
  EXPECT_EQ(factors[0].refinement, Refinement::by_size);
  EXPECT_EQ(factors[0].number(1), 0.005);
  for (const std::string value : {"0", "-0.01", "small"})
    EXPECT_THROW(read({"cells/Entry=Mesh/Cell size",
                       "cells/Values=0.01; " + value,
                       "cells/Refinement=by size"}),
                 InputError)
      << value;
}

TEST(Factor, VariesEntriesTogether)
{
  const auto factors =
    read({"scheme/Entry=Method/Scheme | Method/Degree",
          "scheme/Values=finite volume | ; discontinuous galerkin | 3",
          "scheme/Labels=FV; DG 3"});
  EXPECT_EQ(factors[0].settings(0),
            (Settings{{"Method/Scheme", "finite volume"}}));
  EXPECT_EQ(factors[0].settings(1),
            (Settings{{"Method/Scheme", "discontinuous galerkin"},
                      {"Method/Degree", "3"}}));
  EXPECT_EQ(factors[0].labels[1], "DG 3");
  EXPECT_TRUE(std::isnan(factors[0].number(0)));
}

TEST(Factor, ReadsRanges)
{
  const auto factors = read({"a/Entry=A",
                             "a/Values=0.1 to 0.9",
                             "b/Entry=B",
                             "b/Values=1 to 1e6 logarithmic"});
  EXPECT_TRUE(factors[0].is_range);
  EXPECT_EQ(factors[0].upper, 0.9);
  EXPECT_FALSE(factors[0].logarithmic);
  EXPECT_TRUE(factors[1].logarithmic);
  EXPECT_EQ(factors[1].upper, 1e6);
}

TEST(Factor, RefusesWhatDoesNotFit)
{
  EXPECT_THROW(read({}), InputError);
  EXPECT_THROW(read({"a/Values=1; 2"}), InputError);
  EXPECT_THROW(read({"a/Entry=A"}), InputError);
  EXPECT_THROW(read({"a/Entry=A | B", "a/Values=1; 2"}), InputError);
  EXPECT_THROW(read({"a/Entry=A", "a/Values=1; 2", "a/Labels=x"}), InputError);
  EXPECT_THROW(read({"a/Entry=A", "a/Values=5 to 1"}), InputError);
  EXPECT_THROW(read({"a/Entry=A", "a/Values=-1 to 1 logarithmic"}), InputError);
  EXPECT_THROW(read({"a/Entry=A", "a/Values=x", "a/Refinement=by level"}),
               InputError);
  EXPECT_THROW(read({"a/Entry=A", "a/Values=1", "b/Entry=A", "b/Values=2"}),
               InputError);
  EXPECT_THROW(read({"a/Entry=A",
                     "a/Values=1",
                     "a/Refinement=by level",
                     "b/Entry=B",
                     "b/Values=2",
                     "b/Refinement=by level"}),
               InputError);
}

TEST(Factor, ReadsSettings)
{
  EXPECT_EQ(parse_settings("A/B = 1; C=x=y;", "here"),
            (Settings{{"A/B", "1"}, {"C", "x=y"}}));
  EXPECT_TRUE(parse_settings("", "here").empty());
  EXPECT_THROW(parse_settings("A/B", "here"), InputError);
}
