// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/coupling/scene/first_answer.h>
#include <contrecoup/coupling/scene/scene_files.h>
#include <contrecoup/coupling/task/task_files.h>
#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/body/body_description.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/expected_blast.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

#include <gtest/gtest.h>

#include <map>
#include <utility>

using namespace contrecoup;
using namespace contrecoup::coupling;
using dealii::Point;

namespace
{
/// 2.268 kg of C-4 before a body that stands on the ground.
SceneParameters scene_with(const double distance, const double height)
{
  SceneParameters scene;
  scene.accuracy = SceneParameters::accuracies.back();
  scene.element_size = scene.accuracy.element_size;
  scene.end_time = 0.1;
  scene.symmetry = "auto";
  scene.explosive = find_explosive("c-4");
  scene.mass = 2.268;
  scene.place = Point<3>(0.15 + distance, 0., height);
  return scene;
}


/// As tall, wide and deep as a man.
RoundedBox standing_box()
{
  return {Point<3>(0., 0., 0.88), Point<3>(0.15, 0.25, 0.88), 0.05};
}


double number(const std::vector<Assignment> &entries,
              const std::string &limit,
              const std::string &entry)
{
  for (const Assignment &assignment : entries)
    if (assignment.sections.size() == 2 && assignment.sections[1] == limit &&
        assignment.entry == entry)
      return std::stod(assignment.value);
  ADD_FAILURE() << limit << " has no " << entry;
  return 0.;
}


/// Values by "Section/Entry"; of several for one, the last, which counts.
std::map<std::string, std::string>
values_of(const std::vector<Assignment> &entries)
{
  std::map<std::string, std::string> values;
  for (const Assignment &assignment : entries)
  {
    std::string path;
    for (const std::string &section : assignment.sections)
      path += section + "/";
    values[path + assignment.entry] = assignment.value;
  }
  return values;
}


/// From a place to the nearest ball of a limit of adaptation; negative: within.
double distance_to_balls(const Point<3> &place,
                         const std::vector<Assignment> &entries,
                         const std::string &limit)
{
  double least = 1e9;
  for (const std::string &center :
       split(values_of(entries).at("Adaptation/" + limit + "/Center"), ';'))
    least = std::min(least, place.distance(point_of(center).value()));
  return least - number(entries, limit, "Radius");
}


/// The body of that box, without landmarks.
ShapeBody standing_body()
{
  const auto surface = std::make_shared<RoundedBox>(standing_box());
  return {surface, {{{"all", Tissue::soft_tissue}, surface}}};
}
} // namespace


TEST(SceneFiles, RecordsOfANewerFormatAreRefused)
{
  const io::TemporaryFolder folder;
  const TaskFiles files(folder.path(), "blast");
  files.write_record(false, {"key", "finished", 1.5, 3., 1e9, 2e6});
  EXPECT_EQ(files.read_record(false).key, "key");
  io::write_file(folder.path() + "/blast.stage.json",
                 [](std::ostream &out) { out << R"({"format": 2})"; });
  EXPECT_THROW(files.read_record(false), InputError);
}

TEST(SceneFiles, LimitsOfLeavesThatBeginAfterTheEndAreLeftOut)
{
  SceneParameters scene = scene_with(10., 1.);
  scene.end_time = 0.05;
  const auto values =
    values_of(blast_entries(scene, SceneLayout(scene, standing_box()), 78.5));
  for (const char *limit : {"later", "at last", "gone"})
    EXPECT_EQ(
      values.count(std::string("Adaptation/Limit ") + limit + "/Largest level"),
      0u);
}


// A charge near the body or high above the ground has its first front pass
// long before the ground's.
TEST(SceneFiles, LeavesGetCoarserAfterTheGroundsReflectionHasPassed)
{
  const RoundedBox body = standing_box();
  const Point<3> top(-0.15, 0.25, 1.76);
  unsigned int n_waits = 0;
  for (const auto &[distance, height] :
       {std::pair{0.5, 1.27}, {1.5, 3.}, {2.337, 1.27}, {10., 1.}})
  {
    const SceneParameters scene = scene_with(distance, height);
    const SceneLayout layout(scene, body);
    const auto entries = blast_entries(scene, layout, 78.5);
    const JwlParameters jwl = find_explosive("c-4").jwl;
    const ExpectedBlast blast(
      scene.mass * jwl.energy_density / jwl.reference_density, 101325., 1.225);
    const Point<3> image(layout.charge[0], 0., -height);
    const double reflection = blast.arrival(image.distance(top));
    for (const char *limit : {"Limit later", "Limit at last", "Limit gone"})
      EXPECT_GE(number(entries, limit, "From time"), reflection * (1. - 1e-12))
        << limit << " at " << distance << " m, " << height << " m";
    const double later = number(entries, "Limit later", "From time");
    EXPECT_GT(number(entries, "Limit at last", "From time"), later);
    EXPECT_GE(later, 2.8 * layout.earliest_arrival * (1. - 1e-12));
    n_waits += later > 2.81 * layout.earliest_arrival ? 1 : 0;
    const double radius = number(entries, "Limit gone", "Radius");
    EXPECT_GE(radius, body.bounding_box().center().distance(top) + 0.6);
    EXPECT_EQ(number(entries, "Limit gone", "Largest level"), 0.);
  }
  EXPECT_GE(n_waits, 1U);
  EXPECT_LE(n_waits, 3U);
}


// Behind the charge fronts are then as fine as at the body, until they have
// passed.
TEST(SceneFiles, KeepFrontsFineAtGaugesOfTheUser)
{
  SceneParameters scene = scene_with(2.337, 1.27);
  const auto entries_for = [&](const std::vector<GaugeRaster> &gauges) {
    scene.gauges = gauges;
    return blast_entries(scene, SceneLayout(scene, standing_box()), 78.5);
  };
  const Point<3> far(9., 1., 1.5);
  const auto usual = entries_for({}),
             with = entries_for({{Point<3>(3., -1., 1.5), far}});
  for (const char *limit :
       {"Limit not at the body", "Limit far away", "Limit gone"})
  {
    EXPECT_GT(distance_to_balls(far, usual, limit), 0.) << limit;
    EXPECT_LT(distance_to_balls(far, with, limit), 0.) << limit;
  }
  const double arrival =
    SceneLayout(scene, standing_box())
      .incident_wave(scene)
      .value(BlastQuantity::arrival, far.distance(*scene.place));
  EXPECT_LT(number(usual, "Limit later", "From time"), arrival);
  EXPECT_GT(number(with, "Limit later", "From time"), arrival);
}


TEST(SceneFiles, HandOnMassesPlacesAndTimesOfTheScene)
{
  SceneParameters scene = scene_with(2.337, 1.27);
  scene.tissues = "physiological";
  const SceneLayout layout(scene, standing_box());
  const auto blast = values_of(blast_entries(scene, layout, 78.5));
  EXPECT_EQ(blast.at("Material/Explosive"), "c-4");
  EXPECT_EQ(std::stod(blast.at("Charges/Charge 1/Mass")), 2.268);
  const std::string &center = blast.at("Charges/Charge 1/Center");
  EXPECT_NEAR(std::stod(center), 2.487, 1e-12);
  // The plan announces what the report compares with.
  const KingeryBulmash tables_of_c4("spherical", 1.37 * scene.mass);
  EXPECT_DOUBLE_EQ(layout.arrival,
                   tables_of_c4.value(BlastQuantity::arrival, layout.distance));
  EXPECT_DOUBLE_EQ(
    layout.overpressure,
    tables_of_c4.value(BlastQuantity::overpressure, layout.distance));
  EXPECT_NEAR(layout.earliest_arrival, layout.arrival, 0.15 * layout.arrival);
  EXPECT_EQ(center.substr(center.find(',')), ", 0, 1.27");
  EXPECT_EQ(std::stod(blast.at("Loads/Body mass")), 78.5);
  EXPECT_EQ(std::stod(blast.at("Time/End time")), scene.end_time);
  EXPECT_EQ(blast.at("Boundaries/z low"), "wall");
  const std::string tables = "Reference/Kingery Bulmash/";
  EXPECT_EQ(std::stod(blast.at(tables + "Mass")), 2.268);
  EXPECT_EQ(std::stod(blast.at(tables + "TNT equivalence of pressure")), 1.37);
  EXPECT_EQ(std::stod(blast.at(tables + "TNT equivalence of impulse")), 1.19);
  const auto body =
    values_of(biomechanics_entries(scene, layout, standing_body(), {}, 78.5));
  EXPECT_EQ(body.at("Materials/Set"), "physiological");
  EXPECT_EQ(std::stod(body.at("Mesh/Element size")), scene.element_size);
  EXPECT_EQ(std::stod(body.at("Injury/Body mass")), 78.5);
  EXPECT_EQ(std::stod(body.at("Time/End time")), scene.end_time);
}


// Hourglass modes of one point would be what bends bones of few elements.
TEST(SceneFiles, IntegrateLargeElementsFully)
{
  for (const double size : {0.0025, 0.004, 0.005, 0.01})
  {
    SceneParameters scene = scene_with(2.337, 1.27);
    scene.element_size = size;
    const auto body = values_of(biomechanics_entries(
      scene, SceneLayout(scene, standing_box()), standing_body(), {}, 78.5));
    const auto found = body.find("Elements/Integration");
    EXPECT_EQ(found != body.end() && found->second == "full", size >= 0.005)
      << size;
  }
}


TEST(SceneFiles, FitElementsToTheBodyUnlessAnEntryGivesTheirSize)
{
  const auto size_for = [](const double height, const double given) {
    SceneParameters scene = scene_with(2.337, 1.27);
    scene.accuracy = SceneParameters::accuracies[1];
    scene.element_size = given;
    scene.fit_elements({{Point<3>(0., -0.1, 0.), Point<3>(0.2, 0.1, height)}});
    return scene.element_size;
  };
  EXPECT_EQ(size_for(1.76, 0.), 0.01);
  EXPECT_NEAR(size_for(0.255, 0.), 0.0042, 1e-12);
  EXPECT_EQ(size_for(0.255, 0.01), 0.01);
  // The longest side need not be the height.
  EXPECT_NEAR(size_for(0.1, 0.), 0.0033, 1e-12);
}


// Those without a measured equivalence, too, by the ratio of energies.
TEST(SceneFiles, CompareEveryExplosiveWithTheTables)
{
  SceneParameters scene = scene_with(2.337, 1.27);
  for (const Explosive &explosive : explosive_library())
  {
    SCOPED_TRACE(explosive.name);
    scene.explosive = explosive;
    const SceneLayout layout(scene, standing_box());
    const auto blast = values_of(blast_entries(scene, layout, 78.5));
    EXPECT_EQ(blast.at("Reference/Kind"), "kingery bulmash");
    const std::string reference = "Reference/Kingery Bulmash/";
    EXPECT_EQ(std::stod(blast.at(reference + "TNT equivalence of pressure")),
              explosive.tnt.pressure);
    // Plan, first answer and reference of the run are one wave.
    const KingeryBulmash tables("spherical",
                                explosive.tnt.pressure * scene.mass);
    EXPECT_EQ(layout.arrival,
              tables.value(BlastQuantity::arrival, layout.distance));
    EXPECT_EQ(layout.overpressure,
              tables.value(BlastQuantity::overpressure, layout.distance));
    const auto answer = table_answer(scene, layout, 78.5);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->arrival, layout.arrival);
    EXPECT_EQ(answer->in_the_open.overpressure, layout.overpressure);
    // Bowen et al. 1968: dynamic pressure does not load who lies along the
    // wave.
    EXPECT_NEAR(answer->along_body.lung_exposure *
                  standing_load(layout.overpressure, sea_level_pressure),
                answer->in_the_open.lung_exposure * layout.overpressure,
                1e-9 * layout.overpressure);
  }
}


// One wave for plan, comparison and the reference of the run.
TEST(SceneFiles, TakeTheTablesOfASurfaceBurstForAChargeOnTheGround)
{
  SceneParameters scene = scene_with(2.337, 0.1);
  const SceneLayout layout(scene, standing_box());
  const auto blast = values_of(blast_entries(scene, layout, 78.5));
  EXPECT_EQ(blast.at("Reference/Kingery Bulmash/Burst"), "hemispherical");
  const KingeryBulmash tables("hemispherical",
                              scene.explosive.tnt.pressure * scene.mass);
  EXPECT_EQ(layout.overpressure,
            tables.value(BlastQuantity::overpressure, layout.distance));
  // The mesh changes when the stronger wave is there.
  (*scene.place)[2] = 0.2;
  const SceneLayout above(scene, standing_box());
  EXPECT_FALSE(above.is_surface_burst);
  EXPECT_LT(layout.earliest_arrival, 0.85 * above.earliest_arrival);
}


// A symmetric scene is computed on one side, and the loads are mirrored.
TEST(SceneFiles, LoadBothSidesOfASymmetricBody)
{
  for (const double aside : {0., 0.3})
  {
    SceneParameters scene = scene_with(2.337, 1.27);
    (*scene.place)[1] = aside;
    const SceneLayout layout(scene, standing_box());
    const auto blast = values_of(blast_entries(scene, layout, 78.5));
    const auto body =
      values_of(biomechanics_entries(scene, layout, standing_body(), {}, 78.5));
    const bool is_half = aside == 0.;
    EXPECT_EQ(layout.lower[1] == 0., is_half);
    EXPECT_EQ(blast.at("Boundaries/y low"), is_half ? "symmetry" : "open");
    EXPECT_EQ(body.at("Loads/Recorded/Mirror"), is_half ? "y" : "none");
  }
}


// In front, aside, behind and above, also where the body is wider than far.
TEST(SceneFiles, PutTheProbeAsFarFromTheChargeAsTheBodyIsAndBesideIt)
{
  for (const Point<3> &charge : {Point<3>(2.487, 0., 1.27),
                                 Point<3>(0.68, 0., 1.2),
                                 Point<3>(0.6697, 0., 1.2),
                                 Point<3>(0.7131, 0., 1.2),
                                 Point<3>(-1., 0.2, 1.2),
                                 Point<3>(0., -1., 1.2),
                                 Point<3>(0., 0.8, 1.2),
                                 Point<3>(0., 0., 2.4)})
  {
    SceneParameters scene = scene_with(2.337, 1.27);
    scene.mass = 0.1;
    scene.end_time = 0.01;
    scene.place = charge;
    const SceneLayout layout(scene, standing_box());
    SCOPED_TRACE(testing::Message() << charge);
    ASSERT_TRUE(layout.probe);
    EXPECT_NEAR(layout.probe->distance(charge), layout.distance, 1e-9);
    EXPECT_GT(standing_box().value(*layout.probe), 0.3);
    // Its cells make no difference between the run and the tables.
    const auto entries = blast_entries(scene, layout, 78.5);
    for (const char *limit : {"Limit not at the body", "Limit far away"})
      EXPECT_LE(distance_to_balls(*layout.probe, entries, limit), -0.599);
    for (unsigned int d = 0; d < 3; ++d)
    {
      EXPECT_GT((*layout.probe)[d], layout.lower[d]);
      EXPECT_LT((*layout.probe)[d], layout.upper[d]);
    }
  }
}


// A jet runs along the ground, and not where most of the body is.
TEST(SceneFiles, PutTheProbeBesideAChargeOnTheGroundAsHighAsTheMiddleOfTheBody)
{
  for (const auto &[distance, height] :
       {std::pair<double, double>(3., 0.88), {1., 0.63}})
  {
    SceneParameters scene = scene_with(distance, 0.07);
    scene.mass = 0.5;
    scene.end_time = 0.01;
    const SceneLayout layout(scene, standing_box());
    ASSERT_TRUE(layout.is_surface_burst);
    ASSERT_TRUE(layout.probe);
    EXPECT_NEAR(layout.probe->distance(layout.charge), layout.distance, 1e-9);
    EXPECT_NEAR((*layout.probe)[2], height, 0.03);
    EXPECT_GT(standing_box().value(*layout.probe), 0.3);
  }
}


TEST(SceneFiles, KeepReflectionsFromProbesOfTheUserInTheDomain)
{
  SceneParameters scene = scene_with(2.337, 1.27);
  const SceneLayout usual(scene, standing_box());
  const Point<3> probe(
    usual.upper[0] - 0.1, 0.5 * usual.upper[1], 0.5 * usual.upper[2]);
  // Those outside are refused elsewhere.
  scene.gauges = {{probe, probe},
                  {Point<3>(0., 50., 1.), Point<3>(0., 50., 1.)}};
  const SceneLayout watched(scene, standing_box());
  EXPECT_LT(watched.upper[1], 50.);
  Point<3> image = probe;
  image[0] = 2. * watched.upper[0] - probe[0];
  EXPECT_GT(image.distance(watched.charge), watched.front_distance);
  image[0] = 2. * usual.upper[0] - probe[0];
  EXPECT_LT(image.distance(usual.charge), usual.front_distance);
}


TEST(SceneFiles, GiveShortPositivePhasesFinerCells)
{
  SceneParameters scene = scene_with(2.337, 1.27);
  const auto layout_of = [&](const std::size_t preset) {
    scene.accuracy = SceneParameters::accuracies[preset];
    return SceneLayout(scene, standing_box());
  };
  // 1.97 ms by the tables: 33 cells of 20 mm.
  const KingeryBulmash tables("spherical", 1.19 * scene.mass);
  const SceneLayout usual = layout_of(1);
  EXPECT_EQ(usual.positive_phase,
            tables.value(BlastQuantity::duration, usual.distance));
  EXPECT_EQ(usual.levels, 3U);
  EXPECT_EQ(usual.front_levels, 3U);
  EXPECT_DOUBLE_EQ(usual.cell_size(), 0.02);
  scene.mass = 0.2;
  scene.place = Point<3>(0.95, 0., 1.27);
  for (std::size_t i = 0; i < SceneParameters::accuracies.size(); ++i)
  {
    const SceneLayout near = layout_of(i);
    SCOPED_TRACE(scene.accuracy.name);
    const unsigned int extra = near.levels - scene.accuracy.levels;
    EXPECT_EQ(near.front_levels - scene.accuracy.front_levels, extra);
    EXPECT_LE(extra, SceneLayout::max_extra_levels);
    EXPECT_GE(near.cells_per_phase(), scene.accuracy.cells_per_phase);
    // One level less would not do.
    if (extra > 0)
    {
      EXPECT_LT(near.cells_per_phase() / 2., scene.accuracy.cells_per_phase);
    }
  }
  EXPECT_EQ(layout_of(1).levels, 4U);
  const auto entries = values_of(blast_entries(scene, layout_of(1), 78.5));
  EXPECT_EQ(entries.at("Rigid body/Levels"), "4");
  EXPECT_EQ(entries.at("Adaptation/Largest level"), "4");
}


TEST(SceneFiles, TakeTheLargestCellsUpToTheSizeOfTheUser)
{
  SceneParameters scene = scene_with(2.337, 1.27);
  scene.accuracy = SceneParameters::accuracies[2]; // fronts one level coarser
  const std::vector<std::pair<double, double>> sizes = {
    {0.02, 0.02}, {0.03, 0.02}, {0.005, 0.005}, {0.16, 0.16}};
  for (const auto &[wanted, expected] : sizes)
  {
    scene.cell_size = wanted;
    const SceneLayout layout(scene, standing_box());
    EXPECT_DOUBLE_EQ(layout.cell_size(), expected);
    EXPECT_EQ(layout.front_levels + (layout.levels > 0 ? 1 : 0), layout.levels);
  }
}


// Cells that a body falls between do not see it.
TEST(SceneFiles, CountTheCellsAlongTheBodysShortestSide)
{
  SceneParameters scene = scene_with(2.337, 1.27);
  scene.cell_size = 0.02;
  const Point<3> centre(0., 0., 0.5);
  const auto layout_of = [&](const double half_side) {
    return SceneLayout(
      scene, RoundedBox(centre, Point<3>(half_side, 0.25, 0.4), 0.004));
  };
  EXPECT_DOUBLE_EQ(layout_of(0.07).cells_across(), 7.);
  EXPECT_NO_THROW(layout_of(0.0101));
  EXPECT_THROW(layout_of(0.0099), InputError);
}


// The projection of a charge behind him is not the nearest place of his back.
TEST(SceneFiles, AChargeIsNoFartherThanItsEntrySays)
{
  dealii::ParameterHandler prm;
  BodyDescription::declare_parameters(prm);
  apply_assignments(
    {parse_override("Kind=phantom"), parse_override("Rotation=0, 0, 180")},
    prm);
  BodyDescription description;
  description.parse_parameters(prm);
  const auto body = description.create();
  SceneParameters scene = scene_with(0., 1.27);
  scene.place.reset();
  scene.distance = 2.337;
  scene.height = 1.27;
  const SceneLayout layout(scene, *body->surface());
  EXPECT_LE(layout.distance, 2.337);
  EXPECT_NEAR(layout.distance, 2.337, 0.02);
}
