// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/solid/injury/injury_report.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
const double gravity = 9.80665;

/// Follows a box whose upper half is brain, and whose nodes are moved by hand:
/// what it must find is then known exactly.
class Head
{
public:
  explicit Head(const solid::Supports &supports = {},
                const solid::SurfaceLoads &loads = {})
  {
    body.reinit(half_brain(false),
                materials_of("paper"),
                solid::ElementOptions(),
                supports,
                loads,
                MPI_COMM_WORLD);
    dealii::ParameterHandler prm;
    solid::InjuryReport<double>::declare_parameters(prm);
    apply_assignments({{{"Injury"}, "Active", "true", "test"},
                       {{"Injury"}, "Every steps", "1", "test"},
                       {{"Injury"}, "Pressure", "of elements", "test"}},
                      prm);
    report.parse_parameters(prm, {});
    report.reinit(body);
  }

  /// Stretches each of the six layers of elements along x by its own strain,
  /// and follows what is there at a time, at rest.
  void stretch(const double time, const std::array<double, 6> &strains)
  {
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
    {
      double way = 0.;
      for (unsigned int layer = 0; layer < 6; ++layer)
        if (body.mesh().nodes[i][0] > 0.01 * (layer + 0.5))
          way += 0.01 * strains[layer];
      body.nodes().displacement_of(i)[0] = way;
      for (unsigned int d = 0; d < 3; ++d)
        body.nodes().velocity_of(i)[d] = 0.;
    }
    record(time);
  }

  /// Follows the head at a time, undeformed, with this velocity and turning of
  /// the brain.
  void move(const double time,
            const Tensor<1, 3> &velocity,
            const Tensor<1, 3> &angular_velocity)
  {
    const Point<3> middle(0.03, 0.02, 0.03);
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
    {
      const Tensor<1, 3> all =
        velocity +
        cross_product_3d(angular_velocity,
                         Tensor<1, 3>(body.mesh().nodes[i] - middle));
      for (unsigned int d = 0; d < 3; ++d)
      {
        body.nodes().displacement_of(i)[d] = 0.;
        body.nodes().velocity_of(i)[d] = all[d];
      }
    }
    record(time);
  }

  std::map<std::string, double> measures() const
  {
    std::map<std::string, double> found;
    for (const auto &measure : report.measures(body))
      found[measure.value.name] = measure.value.value;
    return found;
  }

  solid::SolidBody<double> body;
  solid::InjuryReport<double> report;

private:
  void record(const double time)
  {
    body.start(time);
    report.record(body);
  }
};

/// The brain of the paper under a uniaxial strain [Pa].
double pressure(const double strain)
{
  return -find_tissue_properties("paper", Tissue::brain).bulk_modulus * strain;
}
} // namespace


TEST(InjuryReport, CountsTheBrainThatWasStrained)
{
  Head head;
  head.stretch(1e-3, {{0.02, 0.05, 0.1, 0.18, 0.2, 0.05}});
  head.stretch(2e-3, {{0., 0., 0., 0., 0., 0.3}});
  const auto found = head.measures();
  EXPECT_NEAR(found.at("injury_strain_95"), 0.3, 1e-12);
  EXPECT_NEAR(found.at("injury_csdm_15"), 0.5, 1e-12);
  EXPECT_NEAR(found.at("injury_csdm_25"), 1. / 6., 1e-12);
}


// Two of six layers are below -100 kPa, for one of three milliseconds.
TEST(InjuryReport, FollowsPressuresInTheBrain)
{
  Head head;
  head.stretch(1e-3, {{-5e-5, 0., 2e-5, 4.4e-5, 4.8e-5, 1e-4}});
  head.stretch(3e-3, {{0., 0., 0., 0., 0., 2e-5}});
  const auto found = head.measures();
  EXPECT_NEAR(
    found.at("injury_intracranial_pressure_peak"), pressure(-5e-5), 1e-3);
  EXPECT_NEAR(
    found.at("injury_intracranial_pressure_lowest"), pressure(1e-4), 1e-3);
  EXPECT_NEAR(found.at("injury_cavitating_fraction"), 1. / 3., 1e-12);
  EXPECT_NEAR(found.at("injury_cavitation_dose"), 1e-3 / 3., 1e-15);
}


// The criterion counts 15 of the 40 ms of 100 g: 0.015 * 100^2.5.
TEST(InjuryReport, FollowsTheMotionOfTheHead)
{
  Head moved, turned;
  for (unsigned int i = 0; i <= 400; ++i)
  {
    const double time = 1e-4 * i;
    moved.move(
      time, Point<3>(0.6, 0., -0.8) * (time * 100. * gravity), Tensor<1, 3>());
    turned.move(time,
                Tensor<1, 3>(),
                Point<3>(20., -30., 10.) * std::sin(0.5 * M_PI * i / 200.));
  }
  EXPECT_NEAR(
    moved.measures().at("injury_hic15"), 0.015 * std::pow(100., 2.5), 0.1);
  const auto found = turned.measures();
  const double bric =
    std::sqrt(std::pow(20. / 66.25, 2) + std::pow(30. / 56.45, 2) +
              std::pow(10. / 42.87, 2));
  EXPECT_NEAR(found.at("injury_bric"), bric, 1e-3);
  EXPECT_NEAR(found.at("injury_bric_ais2"),
              1. - std::exp(-std::pow(found.at("injury_bric") / 0.602, 2.84)),
              1e-12);
}


// The motion of a head that supports hold is no answer to the load alone.
TEST(InjuryReport, RemarksOnTheMotionOfAHeldHead)
{
  dealii::ParameterHandler prm;
  solid::Supports::declare_parameters(prm);
  apply_assignments({{{"Supports", "Support neck"}, "Where", "z < 0.001", ""}},
                    prm);
  solid::Supports supports;
  supports.parse_parameters(prm);
  for (const bool is_held : {false, true})
  {
    Head head(is_held ? supports : solid::Supports());
    for (const double time : {1e-3, 2e-3})
      head.move(time, {}, {});
    unsigned int n_remarks = 0;
    for (const solid::InjuryMeasure &measure : head.report.measures(head.body))
      if (measure.limits.find("in a body that Supports hold") !=
          std::string::npos)
        ++n_remarks;
    // The remarks are on HIC and BrIC.
    EXPECT_EQ(n_remarks, is_held ? 2u : 0u);
  }
}


// After a strike the values are whole, a blast strains the brain later still.
TEST(InjuryReport, HasLowerLimitsOfShortRunsUnderLoadsAlone)
{
  dealii::ParameterHandler prm;
  solid::SurfaceLoads::declare_parameters(prm);
  apply_assignments({{{"Loads", "Load pulse"}, "Pressure", "1e5", ""}}, prm);
  solid::SurfaceLoads loads;
  loads.parse_parameters(prm);
  for (const bool is_loaded : {false, true})
  {
    Head head({}, is_loaded ? loads : solid::SurfaceLoads());
    head.stretch(1e-3, {{0.02, 0.05, 0.1, 0.18, 0.2, 0.05}});
    head.stretch(2e-3, {});
    for (const solid::InjuryMeasure &measure : head.report.measures(head.body))
    {
      if (measure.value.name == "injury_hic15")
      {
        EXPECT_EQ(measure.limits.find("blast") == std::string::npos,
                  !is_loaded);
      }
      for (const char *name : {"injury_strain_95",
                               "injury_csdm_15",
                               "injury_hic15",
                               "injury_bric"})
        if (measure.value.name == name)
        {
          EXPECT_EQ(measure.is_cut, is_loaded) << name;
        }
    }
  }
}


// Motion faster than a head's channel lets through does not count, slow motion
// does.
TEST(HeadMotion, IsFiltered)
{
  const auto measures_of = [](const double frequency, const double shaken) {
    solid::HeadMotion motion;
    for (unsigned int i = 0; i <= 4000; ++i)
    {
      const double time = 5e-6 * i,
                   phase = std::sin(2. * M_PI * frequency * time);
      motion.add(time,
                 Point<3>(50. * gravity * time + shaken * phase, 0., 0.),
                 Point<3>(0., 20. + 10. * shaken * phase, 0.));
    }
    std::map<std::string, double> found;
    for (const auto &measure : solid::head_motion_measures(motion, "it"))
      found[measure.value.name] = measure.value.value;
    return found;
  };
  const auto quiet = measures_of(20e3, 0.), noisy = measures_of(20e3, 1.);
  EXPECT_NEAR(quiet.at("injury_hic15"), 0.015 * std::pow(50., 2.5), 0.1);
  EXPECT_NEAR(quiet.at("injury_bric"), 20. / 56.45, 1e-9);
  EXPECT_NEAR(noisy.at("injury_hic15") / quiet.at("injury_hic15"), 1., 0.01);
  EXPECT_NEAR(noisy.at("injury_bric") / quiet.at("injury_bric"), 1., 0.01);
  EXPECT_NEAR(measures_of(300., 1.).at("injury_bric"), 30. / 56.45, 0.01);
  EXPECT_TRUE(solid::head_motion_measures({}, "it").empty());
}


TEST(InjuryReport, GoesOnFromACheckpoint)
{
  const std::string folder = "injury_checkpoint";
  std::filesystem::create_directories(folder);
  Head head, other;
  head.stretch(1e-3, {{-5e-5, 0., 0.16, 0.2, 4.8e-5, 0.3}});
  head.move(2e-3, Point<3>(1., 0., 0.), Point<3>(3., 2., 1.));
  head.report.save(head.body, folder);
  MPI_Barrier(MPI_COMM_WORLD);
  other.report.restore(other.body, folder);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(other.measures(), head.measures());
  for (Head *one : {&head, &other})
  {
    one->stretch(4e-3, {{0., 0., 0., 0., 0., 1e-4}});
    one->move(5e-3, Point<3>(3., 0., 0.), Point<3>(0., 0., 5.));
  }
  EXPECT_EQ(other.measures(), head.measures());
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::remove_all(folder);
}
