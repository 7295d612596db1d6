// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_search.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

using namespace contrecoup;

namespace
{
void declare_entries(ParameterHandler &prm)
{
  declare_double(prm, "Density", "1.4", 0., 1e5, "kg/m^3", "Of the gas.");
  declare_double(prm, "Shift", "0", -unbounded, unbounded, "m", "Any.");
  declare_integer(prm, "Degree", "3", 0, 3, "Of the polynomials.");
  declare_bool(prm, "Adapt", "true", "Whether the mesh changes.");
  {
    const Section section(prm, "Flux");
    declare_selection(
      prm, "Kind", "HLLC", {"HLLC", "HLL", "Rusanov"}, "At faces.");
    declare_list(prm, "Weights", "1, 2", 1, 3, 0., 9., "-", "Of each.");
  }
  declare_points(prm, "Places", "0,0; 1,2.5", "m", "Of probes.");
  declare_list(prm, "Normal", "1, 0, 0", 3, 3, -1., 1., "-", "Of all.");
  declare_file(prm, "Table", "", "Numbers.");
  const Section section(prm, "Region *");
  declare_double(prm, "Radius", "1", 0., unbounded, "m", "Of the ball.");
  declare_points(prm, "Centres", "0,0; 1,1", "m", "Of its copies.");
  const Section inner(prm, "State");
  declare_string(prm, "Pressure", "1e5", "An expression.");
}

void set(ParameterHandler &prm, const std::string &text)
{
  apply_assignments({parse_override(text)}, prm);
}

std::string find_text(const ParameterHandler &prm, const std::string &what)
{
  return find_parameters(prm, what, ParameterForm::text);
}

std::string refusal_of_entry(const std::string &text)
{
  ParameterHandler prm;
  declare_entries(prm);
  try
  {
    set(prm, text);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "accepted";
}
} // namespace

TEST(Parameters, ReadsWhatWasSet)
{
  ParameterHandler prm;
  declare_entries(prm);
  set(prm, "Density = 0.1234567890123456789");
  set(prm, "Flux/Weights = 3,4 ,5");
  EXPECT_EQ(read_double(prm, "Density"), 0.1234567890123456789);
  EXPECT_EQ(read_unsigned(prm, "Degree"), 3u);
  EXPECT_EQ(read_points<2>(prm, "Places")[1], dealii::Point<2>(1., 2.5));
  EXPECT_THROW(read_points<3>(prm, "Places"), InputError);
  const Section section(prm, "Flux");
  EXPECT_EQ(read_list(prm, "Weights"), (std::vector<double>{3., 4., 5.}));
  EXPECT_EQ(read_point<3>(prm, "Weights"), dealii::Point<3>(3., 4., 5.));
  EXPECT_THROW(read_point<2>(prm, "Weights"), InputError);
}

// Whatever the pattern of the entry lets through.
TEST(Parameters, ReadsFiniteNumbersOnly)
{
  ParameterHandler prm;
  prm.declare_entry("Any", "0", dealii::Patterns::Anything());
  for (const std::string value : {"nan", "inf", "-inf", "1e400", "1 m"})
  {
    prm.set("Any", value);
    EXPECT_THROW(read_double(prm, "Any"), InputError) << value;
    EXPECT_THROW(read_list(prm, "Any"), InputError) << value;
    EXPECT_THROW(read_points<1>(prm, "Any"), InputError) << value;
  }
  prm.set("Any", "-1e300");
  EXPECT_EQ(read_double(prm, "Any"), -1e300);
}

TEST(Parameters, SaysWhatIsAllowed)
{
  EXPECT_EQ(refusal_of_entry("Density=-1"),
            "--set: entry \"Density\" cannot be \"-1\"; allowed: a number from "
            "0 to 100000");
  EXPECT_EQ(refusal_of_entry("Degree=2.5"),
            "--set: entry \"Degree\" cannot be \"2.5\"; allowed: a whole "
            "number from 0 to 3");
  EXPECT_EQ(refusal_of_entry("Flux/Kind=Rusnov"),
            "--set: entry \"Flux/Kind\" cannot be \"Rusnov\"; did you mean "
            "\"Rusanov\"? Allowed: HLLC, HLL, Rusanov");
  EXPECT_EQ(refusal_of_entry("Flux/Weights=1,10"),
            "--set: entry \"Flux/Weights\" cannot be \"1,10\"; allowed: 1 to 3 "
            "values separated by commas, each a number from 0 to 9");
  EXPECT_EQ(refusal_of_entry("Normal=1,0"),
            "--set: entry \"Normal\" cannot be \"1,0\"; allowed: 3 "
            "values separated by commas, each a number from -1 to 1");
  EXPECT_EQ(refusal_of_entry("Adapt=maybe"),
            "--set: entry \"Adapt\" cannot be \"maybe\"; allowed: true, false");
  EXPECT_NE(
    refusal_of_entry("Places=1,2,3,4").find("points of one to three numbers"),
    std::string::npos);
  for (const char *value : {"nan", "inf", "-inf", "1e400", "1 m", ""})
    EXPECT_NE(refusal_of_entry(std::string("Shift=") + value), "accepted")
      << value;
}

TEST(Parameters, NamesTheNearestForWhatIsUnknown)
{
  EXPECT_EQ(refusal_of_entry("Flux/Kid=HLL"),
            "--set: unknown entry \"Kid\" in \"Flux\"; did you mean \"Kind\"? "
            "Known are: Kind, Weights");
  EXPECT_EQ(refusal_of_entry("Flx/Kind=HLL"),
            "--set: unknown subsection \"Flx\" at the top level; did you mean "
            "\"Flux\"? Known are: Flux, Region *");
  EXPECT_EQ(refusal_of_entry("Region ball/Stat/Pressure=1"),
            "--set: unknown subsection \"Stat\" in \"Region ball\"; did you "
            "mean \"State\"? Known are: State");
  EXPECT_NE(refusal_of_entry("Region */Radius=1"), "accepted");
}

TEST(Parameters, NamedItemsHaveTheEntriesOfTheirPattern)
{
  ParameterHandler prm;
  declare_entries(prm);
  EXPECT_TRUE(item_names(prm, "Region").empty());
  set(prm, "Region outer/Radius = 2");
  set(prm, "Region inner ball/State/Pressure = 3e5");
  EXPECT_EQ(item_names(prm, "Region"),
            (std::vector<std::string>{"outer", "inner ball"}));
  const Section section(prm, "Region inner ball");
  EXPECT_EQ(read_double(prm, "Radius"), 1.);
  EXPECT_EQ(read_points<2>(prm, "Centres").size(), 2u);
  const Section inner(prm, "State");
  EXPECT_EQ(prm.get("Pressure"), "3e5");
}

TEST(Parameters, TextReadBackGivesTheSameValues)
{
  ParameterHandler prm;
  declare_entries(prm);
  set(prm, "Density = 0.12345678901234567");
  set(prm, "Region b/State/Pressure = 1e5*(x < 0.5)");
  set(prm, "Region a/Radius = 4");
  for (const bool annotated : {false, true})
  {
    std::ofstream("written.prm") << parameter_text(prm, annotated);
    ParameterHandler again;
    declare_entries(again);
    apply_assignments(read_assignments("written.prm"), again);
    EXPECT_EQ(parameter_values(prm), parameter_values(again));
    EXPECT_EQ(item_names(again, "Region"), item_names(prm, "Region"));
  }
}

TEST(Parameters, NumbersHaveNeitherUnitsNorCommas)
{
  EXPECT_EQ(refusal_of_entry("Density=1 kg"),
            "--set: entry \"Density\" cannot be \"1 kg\": a number stands "
            "without its unit, here kg/m^3: \"1\"; allowed: a number from 0 to "
            "100000");
  EXPECT_NE(refusal_of_entry("Density=0,5")
              .find(": the decimal separator is a point: \"0.5\"; allowed"),
            std::string::npos);
  EXPECT_NE(
    refusal_of_entry("Places=1 m, 0").find("without its unit, here m: \"1\""),
    std::string::npos);
  EXPECT_NE(refusal_of_entry("Domain.Density=1")
              .find("a \"/\" separates section and entry: \"Domain/Density\""),
            std::string::npos);
}

TEST(Parameters, LettersThatLookLikeOthersAreNamed)
{
  EXPECT_EQ(refusal_of_entry("Density=0.5\u00A0"),
            "--set: the value of entry \"Density\" has U+00A0 (no-break space) "
            "after \"0.5\": write a space instead");
  EXPECT_NE(refusal_of_entry("Density=\u22122").find("U+2212 (minus sign)"),
            std::string::npos);
  EXPECT_NE(
    refusal_of_entry("Den\u200Bsity=2").find("U+200B (invisible letter)"),
    std::string::npos);
  EXPECT_NE(
    refusal_of_entry("Density=\uFF11").find("U+FF11 (full-width letter)"),
    std::string::npos);
  EXPECT_NE(
    refusal_of_entry("Density=\u201C2\u201D").find("U+201C (quotation mark)"),
    std::string::npos);
  EXPECT_NE(refusal_of_entry("Density=2\u00B7").find("U+00B7 after \"2\""),
            std::string::npos);
  EXPECT_NE(refusal_of_entry("Density=\xE9").find("not UTF-8: byte 0xE9"),
            std::string::npos);
}

TEST(Parameters, APatternHasNoValuesOfItsOwn)
{
  ParameterHandler prm;
  declare_entries(prm);
  const auto radius = [](const std::string &value) {
    return Assignment{{"Region *"}, "Radius", value, "\"a.prm\", line 2", ""};
  };
  EXPECT_NO_THROW(apply_assignments({radius("1")}, prm));
  EXPECT_THROW(apply_assignments({radius("7")}, prm), InputError);
  EXPECT_TRUE(item_names(prm, "Region").empty());
}

TEST(Parameters, OneSectionOrTheEntriesWithAWordAreFound)
{
  ParameterHandler prm;
  declare_entries(prm);
  const std::string by_name = find_text(prm, "density");
  EXPECT_NE(by_name.find("set Density = 1.4\n"), std::string::npos);
  EXPECT_EQ(by_name.find("Table"), std::string::npos);
  EXPECT_NE(find_text(prm, "of the gas").find("set Density"),
            std::string::npos);
  EXPECT_NE(find_text(prm, "region").find("subsection Region *\n"),
            std::string::npos);
  try
  {
    find_text(prm, "denisty");
    ADD_FAILURE();
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("did you mean \"Density\"?"),
              std::string::npos);
  }
}

TEST(Parameters, JsonHasUnitRangeAndChoices)
{
  ParameterHandler prm;
  declare_entries(prm);
  const auto json = nlohmann::ordered_json::parse(
    find_parameters(prm, "", ParameterForm::json));
  const auto &density = json.at("Density");
  EXPECT_EQ(density.at("value"), "1.4");
  EXPECT_EQ(density.at("unit"), "kg/m^3");
  EXPECT_EQ(density.at("range"), nlohmann::ordered_json({0, 100000}));
  EXPECT_EQ(density.at("allowed"), "a number from 0 to 100000");
  EXPECT_FALSE(density.contains("choices"));
  EXPECT_EQ(find_parameters(prm, "Density", ParameterForm::json),
            nlohmann::ordered_json({{"Density", density}}).dump(2));
}

TEST(Parameters, AnnotationHasMeaningUnitAndRange)
{
  ParameterHandler prm;
  declare_entries(prm);
  EXPECT_NE(parameter_text(prm, true).find(
              "# [kg/m^3] Of the gas. Allowed: a number from 0 to 100000.\n"
              "set Density = 1.4\n"),
            std::string::npos);
}

TEST(Parameters, FilesAreFoundBesideTheParameterFile)
{
  std::filesystem::create_directories("beside");
  std::ofstream("beside/table.csv") << "1\n";
  std::ofstream("beside/scene.prm") << "set Table = table.csv\n";
  ParameterHandler prm;
  declare_entries(prm);
  apply_assignments(read_assignments("beside/scene.prm"), prm);
  EXPECT_EQ(prm.get("Table"),
            (std::filesystem::current_path() / "beside/table.csv").string());
  set(prm, "Table=nowhere.csv");
  EXPECT_EQ(prm.get("Table"), "nowhere.csv");
}
