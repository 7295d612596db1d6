// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_answer.h>
#include <contrecoup/ale/run/ale_simulation.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/run/time_parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
/// Plan for a head of 80, 4 and 7 mm against a wall at 3 m/s, 5 ms.
std::map<std::string, Assumption>
plan_of(const std::vector<std::string> &overrides,
        const bool is_checked = false)
{
  ParameterHandler prm;
  TimeParameters::declare_parameters(prm);
  AleSimulation::declare_parameters(prm);
  std::vector<Assignment> assignments;
  for (const std::string text : {"Time/End time=5e-3",
                                 "Mesh/Kind=layered head",
                                 "Mesh/Semi-axes=0.08, 0.08, 0.08",
                                 "Mesh/CSF thickness=0.004",
                                 "Mesh/Skull thickness=0.007",
                                 "Region brain/Layer=brain",
                                 "Region brain/Material=tissue",
                                 "Region brain/Tissue=brain",
                                 "Region CSF/Layer=csf",
                                 "Region CSF/Material=tait",
                                 "Region CSF/Density=1000",
                                 "Region skull/Layer=skull",
                                 "Region skull/Material=elastic",
                                 "Region skull/Density=1100",
                                 "Region skull/Young modulus=1.25e9",
                                 "Region skull/Poisson ratio=0.3",
                                 "Region brain/Velocity z=-3",
                                 "Region CSF/Velocity z=-3",
                                 "Region skull/Velocity z=-3",
                                 "Plane wall/Point=0, 0, -0.091",
                                 "Plane wall/Normal=0, 0, 1"})
    assignments.push_back(parse_override(text));
  for (const std::string &text : overrides)
    assignments.push_back(parse_override(text));
  apply_assignments(assignments, prm);
  AleSimulation simulation(MPI_COMM_WORLD);
  simulation.parse_parameters(prm);
  if (is_checked)
    simulation.estimate();
  std::map<std::string, Assumption> result;
  for (const Assumption &item : simulation.plan())
    result[item.name] = item;
  return result;
}

double value_of(const std::map<std::string, Assumption> &plan,
                const std::string &name)
{
  return plan.count(name) > 0 ? plan.at(name).value
                              : std::numeric_limits<double>::quiet_NaN();
}
} // namespace


// 2.14 kg of brain, 0.34 kg of CSF and 0.74 kg of skull on 1.69e6 N/m.
TEST(ImpactPlan, tells_what_a_head_is_expected_to_do)
{
  const auto plan = plan_of({});
  EXPECT_NEAR(value_of(plan, "contact"), 4.34e-3 / 5e-3, 0.01);
  EXPECT_NEAR(value_of(plan, "cavitation_CSF"), -183e3, 3e3);
  EXPECT_TRUE(plan.at("cavitation_CSF").fails());
  EXPECT_FALSE(plan.at("contact").fails());
  // Too short to see the head leave, or its pressure fall.
  const auto brief = plan_of({"Time/End time=1e-3"});
  EXPECT_TRUE(brief.at("contact").fails());
  EXPECT_TRUE(std::isnan(value_of(brief, "cavitation_CSF")));
  // On its way for 1 ms, or for 36 ms.
  const auto near = plan_of({"Plane wall/Point=0, 0, -0.094"});
  EXPECT_NEAR(value_of(near, "contact"), 5.34e-3 / 5e-3, 0.01);
  EXPECT_NEAR(value_of(near, "cavitation_CSF"), -183e3, 3e3);
  const auto far = plan_of({"Plane wall/Point=0, 0, -0.2"});
  EXPECT_TRUE(far.at("contact").fails());
  EXPECT_TRUE(std::isnan(value_of(far, "cavitation_CSF")));
}

TEST(ImpactPlan, weighs_the_scalp_that_is_left_out)
{
  // A shell of 5 mm around 91 mm, 0.604 kg, on 3.2 kg.
  EXPECT_NEAR(value_of(plan_of({}), "scalp"), 0.188, 0.003);
  EXPECT_EQ(plan_of({"Mesh/Scalp thickness=0.005",
                     "Region scalp/Layer=scalp",
                     "Region scalp/Material=tissue",
                     "Region scalp/Tissue=skin"})
              .count("scalp"),
            0u);
}

TEST(ImpactPlan, tells_of_a_head_without_a_brain)
{
  EXPECT_EQ(plan_of({}, true).count("brain"), 0u);
  EXPECT_EQ(value_of(plan_of({"Injury/Brain="}, true), "brain"), 0.);
}

TEST(ImpactPlan, bounds_the_friction_that_is_left_out)
{
  const auto normal = plan_of({});
  EXPECT_EQ(normal.at("friction").decision, "left out");
  EXPECT_EQ(value_of(normal, "friction"), 0.);
  // At 45 degrees both components are v / sqrt(2): 4 mu v_n v_t / v^2 = 2 mu.
  const auto oblique = plan_of({"Plane wall/Normal=1, 0, 1"});
  EXPECT_NEAR(value_of(oblique, "friction"), 0.5, 1e-12);
  EXPECT_TRUE(oblique.at("friction").fails());
  const auto rough =
    plan_of({"Plane wall/Normal=1, 0, 1", "Plane wall/Friction=0.1"});
  EXPECT_EQ(rough.at("friction").decision, "as asked for");
  EXPECT_NEAR(value_of(rough, "friction"), 0.2, 1e-12);
  EXPECT_FALSE(rough.at("friction").fails());
}

TEST(ImpactPlan, knows_which_planes_of_symmetry_would_do)
{
  const auto whole = plan_of({});
  // 32^3 cells of the cube and 15 layers of 6 * 32^2 around it, of which the
  // wedge has 16 * 32 and 15 * 2 * 32.
  constexpr double wedge = 1472. / 124928.;
  EXPECT_NEAR(value_of(whole, "unused_symmetry"), 1. - wedge, 1e-14);
  EXPECT_EQ(whole.at("unused_symmetry").decision,
            "a wedge about z would suffice");
  EXPECT_EQ(whole.count("symmetry"), 0u);
  const auto half = plan_of({"Mesh/Symmetry planes=x"});
  EXPECT_EQ(value_of(half, "symmetry"), 0.5);
  EXPECT_NEAR(value_of(half, "unused_symmetry"), 1. - 2. * wedge, 1e-14);
  const auto quarter = plan_of({"Mesh/Symmetry planes=x, y"});
  EXPECT_EQ(value_of(quarter, "symmetry"), 0.75);
  EXPECT_EQ(value_of(quarter, "asymmetry"), 0.);
  EXPECT_NEAR(value_of(quarter, "unused_symmetry"), 1. - 4. * wedge, 1e-14);
  const auto thin = plan_of({"Mesh/Wedge axis=z"});
  EXPECT_NEAR(value_of(thin, "symmetry"), 1. - wedge, 1e-14);
  EXPECT_EQ(thin.at("symmetry").decision, "a wedge about z is computed");
  EXPECT_EQ(value_of(thin, "asymmetry"), 0.);
  EXPECT_EQ(thin.count("unused_symmetry"), 0u);
  // A body that is not round needs a quarter.
  EXPECT_EQ(
    value_of(plan_of({"Mesh/Semi-axes=0.08, 0.07, 0.08"}), "unused_symmetry"),
    0.75);
  // Cases that are not symmetric in x need a half.
  for (const char *const text : {"Plane wall/Normal=1, 0, 1",
                                 "Region CSF/Velocity x=1",
                                 "Body force/x=t"})
  {
    EXPECT_EQ(value_of(plan_of({text}), "unused_symmetry"), 0.5) << text;
    for (const char *const part :
         {"Mesh/Symmetry planes=x, y", "Mesh/Wedge axis=z"})
      EXPECT_TRUE(plan_of({text, part}).at("asymmetry").fails()) << text;
  }
  // A function of the place may have any symmetry or none.
  EXPECT_EQ(plan_of({"Region CSF/Velocity x=y"}).count("unused_symmetry"), 0u);
}

TEST(ImpactPlan, audits_friction_and_contact)
{
  ImpactPlan plan;
  plan.end_time = 2.;
  plan.velocity[2] = -1.;
  plan.planes = {
    {"wall", dealii::Point<3>(), dealii::Tensor<1, 3>({0., 0., 1.}), 0.}};
  const auto find = [&](const ImpactPlan::ImpactResults &found,
                        const std::string &name) {
    for (const Assumption &item : plan.audit(found))
      if (item.name == name)
        return item;
    return Assumption();
  };
  ImpactPlan::ImpactResults found{{}, {}, 0., 3., 6.};
  found.contact.begin = 0.3;
  found.contact.end = 1.;
  EXPECT_NEAR(find(found, "friction").value, 0.15, 1e-15);
  EXPECT_TRUE(find(found, "friction").fails());
  EXPECT_EQ(find(found, "contact").value, 0.5);
  found.contact.end = 2.;
  EXPECT_TRUE(find(found, "contact").fails());
  // A run that stops early has seen the end of a contact or not.
  for (const double end : {-1., 0.5, 1.})
  {
    found.time = 1.;
    found.contact.begin = end < 0. ? -1. : 0.3;
    found.contact.end = end;
    EXPECT_EQ(std::isnan(find(found, "contact").value), end != 0.5) << end;
  }
  plan.planes[0].friction = 0.5;
  found.friction_work = -1.5;
  EXPECT_NEAR(find(found, "friction").value, 0.25, 1e-15);
  EXPECT_FALSE(find(found, "friction").fails());
}

TEST(HeadAnswer, SaysWhichPressuresAreThoseSoFar)
{
  std::vector<NamedValue> values{
    {"injury_intracranial_pressure_peak", "Pa", 5e5},
    {"injury_intracranial_pressure_lowest", "Pa", -4e4}};
  const auto line = [&](const std::string &cut_off) {
    auto list = values;
    list.push_back({cut_off + "_cut_off", "-", 1.});
    return answer_lines(list, false, "averaged")[0];
  };
  const std::string begin = "Pressure in the brain, averaged: ";
  EXPECT_EQ(line("none"), begin + "from -40 kPa to 500 kPa");
  EXPECT_EQ(line("injury_intracranial_pressure_lowest"),
            begin + "from so far -40 kPa to 500 kPa");
  values.insert(values.end(),
                {{"coup_pressure", "Pa", 5e5},
                 {"coup_pressure_time", "s", 1e-3},
                 {"contrecoup_pressure", "Pa", -3e4},
                 {"contrecoup_pressure_time", "s", 2e-3}});
  EXPECT_EQ(line("coup_pressure"),
            begin + "coup so far 500 kPa at 1 ms, contrecoup -30 kPa at 2 ms");
  EXPECT_EQ(line("contrecoup_pressure"),
            begin + "coup 500 kPa at 1 ms, contrecoup so far -30 kPa at 2 ms");
}

TEST(ContactRecord, KnowsNoEndOfAContactThatLasts)
{
  ContactRecord record;
  ContactMeasures push;
  record.start(
    {"wall", dealii::Point<3>(), dealii::Tensor<1, 3>({0., 0., 1.}), 0.},
    dealii::Tensor<1, 3>({0., 0., -3.}),
    1.,
    {});
  EXPECT_FALSE(record.lasts(0.1));
  EXPECT_NE(answer_lines(record.values(0.1), true, "")[0].find("nothing"),
            std::string::npos);
  push.force = 50.;
  record.add(push, 0.2, 0.1);
  record.add(push, 0.3, 0.1);
  for (const double now : {0.3, 0.4})
  {
    const bool lasts = now < 0.4;
    const auto values = record.values(now);
    const auto find = [&](const std::string &name) {
      for (const NamedValue &value : values)
        if (value.name == name)
          return value.value;
      return 0.;
    };
    EXPECT_EQ(std::isnan(find("contact_end")), lasts);
    EXPECT_EQ(find("contact_cut_off"), lasts ? 1. : 0.);
    EXPECT_NEAR(find("contact_impulse"), 10., 1e-12);
    EXPECT_EQ(answer_lines(values, true, "")[0],
              lasts ? "Impact at 3 m/s: largest contact force so far 50 N, a "
                      "mean over 50 us, at 200 ms, contact from 100 ms, which "
                      "lasts when the run ends"
                    : "Impact at 3 m/s: largest contact force 50 N, a mean "
                      "over 50 us, at 200 ms, contact from 100 ms to 300 ms");
  }
}

TEST(ContactRecord, TellsAForceThatDoesNotGrowAsStepsGetSmaller)
{
  const double pi = std::acos(-1.), duration = 1e-3, caught = 0.2e-3;
  for (const double size : {8e-7, 4e-7, 1e-7, 3e-5})
  {
    ContactRecord record;
    // Half a sine of 7 kN, and 2 mN s of a node that meets the plane.
    bool is_caught = false;
    double time = 0.;
    while (time < 2. * duration)
    {
      ContactMeasures push;
      time += size;
      push.force = std::max(0., 7e3 * std::sin(pi * time / duration));
      if (!is_caught && time > caught)
      {
        push.force += 2e-3 / size;
        is_caught = true;
      }
      record.add(push, time, size);
    }
    std::map<std::string, double> found;
    for (const NamedValue &value : record.values(time))
      found[value.name] = value.value;
    const double middle = 0.5 * duration;
    EXPECT_NEAR(found["peak_contact_force"], 7e3, 15.) << size;
    EXPECT_NEAR(found["peak_contact_force_time"], middle, 0.02 * duration)
      << size;
    EXPECT_EQ(found["peak_contact_force_of_step"], record.step_force);
    if (size < 2e-7)
    {
      EXPECT_GT(found["peak_contact_force_of_step"], 2e4);
      EXPECT_NEAR(found["peak_contact_force_of_step_time"], caught, 2. * size);
    }
  }
}

TEST(ContactRecord, TakesTheMeanOfAShortPushOverTheWholeSpan)
{
  ContactRecord record;
  ContactMeasures push;
  // 10 us with 100 N, in the middle of long and of short steps without.
  record.add(push, 1.3e-3, 1.3e-3);
  push.force = 100.;
  for (unsigned int i = 1; i <= 4; ++i)
    record.add(push, 1.3e-3 + i * 2.5e-6, 2.5e-6);
  push.force = 0.;
  record.add(push, 2e-3, 6.9e-4);
  EXPECT_NEAR(record.mean_force.value, 20., 1e-9);
  EXPECT_NEAR(record.mean_force.time, 1.3e-3, 2.5e-5);
  // That of another push counts alone.
  push.force = 60.;
  record.add(push, 2.01e-3, 1e-5);
  EXPECT_NEAR(record.mean_force.value, 20., 1e-9);
  record.add(push, 2.03e-3, 2e-5);
  EXPECT_NEAR(record.mean_force.value, 36., 1e-9);
}
