// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/mesh_description.h>
#include <contrecoup/ale/record/head_measures.h>
#include <contrecoup/base/parameters/parameter_tree.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/physics/transformations.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

using namespace contrecoup;
using namespace contrecoup::ale;

namespace
{
using Point = dealii::Point<3>;
using Vector = dealii::Tensor<1, 3>;

constexpr double bulk_modulus = 2e9;
constexpr double gravity = 9.80665;

/// A box whose nodes are moved by hand, so that what is to be found is known:
/// eight layers of cells of 1 cm along x, the first of which are brain, and the
/// others skull.
class MovedHead
{
public:
  using Entries = std::map<std::string, std::string>;

  /// @param entries of "Injury" and "Mesh"
  explicit MovedHead(const unsigned int n_layers_of_brain = 4,
                     const std::map<std::string, Entries> &entries = {},
                     const std::vector<ContactPlane> &planes = {})
  {
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh_, {8, 4, 2}, Point(), Point(0.08, 0.04, 0.02), true);
    for (const auto &cell : mesh_.active_cell_iterators())
      cell->set_material_id(cell->center()[0] < 0.01 * n_layers_of_brain ? 0
                                                                         : 1);
    space_.reinit(mesh_, MPI_COMM_WORLD);
    SolidMaterial material;
    material.density = 1000.;
    material.bulk_modulus = bulk_modulus;
    material.instantaneous_shear = 1e6;
    regions_[0].name = "brain";
    regions_[1].name = "skull";
    for (Region &region : regions_)
      region.law = material;
    step_.reinit(space_, regions_, {}, [](double) { return Vector(); });
    state_.position = start_ = space_.positions(node_width);
    state_.velocity.resize(start_.size());
    state_.mass.resize(space_.n_cells());
    state_.mass.fill(1e-3);
    state_.energy.resize(space_.n_cells());
    state_.products.resize(space_.n_cells());
    step_.start(state_);

    dealii::ParameterHandler prm;
    MeshDescription::declare_parameters(prm);
    HeadMeasures::declare_parameters(prm);
    apply_assignments({{{"Injury"}, "Every steps", "1", "test"}}, prm);
    for (const auto &[section, list] : entries)
      for (const auto &[entry, value] : list)
        apply_assignments({{{section}, entry, value, "test"}}, prm);
    measures_.parse_parameters(prm, impact_);
    measures_.find(regions_, planes);
    measures_.reinit(snapshot());
  }

  /// Follows the head at a time at which nodes are at @p place, with
  /// @p velocity, both functions of where they began.
  template <typename Place, typename Velocity>
  void follow(const double time, const Place &place, const Velocity &velocity)
  {
    state_.time = time;
    for (std::size_t n = 0; n < space_.n_nodes(); ++n)
    {
      const double *x = &start_[node_width * n];
      const Point start(x[0], x[1], x[2]);
      const Point now(place(start));
      const Vector speed(velocity(start));
      for (unsigned int d = 0; d < 3; ++d)
      {
        state_.position[node_width * n + d] = now[d];
        state_.velocity[node_width * n + d] = speed[d];
      }
    }
    measures_.record(snapshot());
  }

  /// Stretches each layer along x by its own strain, at rest.
  void stretch(const double time, const std::array<double, 8> &strains)
  {
    follow(
      time,
      [&](Point x) {
        double way = 0.;
        for (unsigned int layer = 0; layer < 8; ++layer)
          if (x[0] > 0.01 * (layer + 0.5))
            way += 0.01 * strains[layer];
        x[0] += way;
        return x;
      },
      [](const Point &) { return Vector(); });
  }

  std::map<std::string, double> found() const
  {
    std::map<std::string, double> result;
    for (const auto &measure : measures_.measures(MPI_COMM_WORLD))
      result[measure.value.name] = measure.value.value;
    return result;
  }

  HeadMeasures &measures()
  {
    return measures_;
  }

  AleSnapshot snapshot() const
  {
    return {{impact_, MPI_COMM_WORLD, state_.time},
            space_,
            step_,
            state_,
            regions_,
            probe_cells_};
  }

private:
  ImpactScene impact_;
  std::vector<Region> regions_ = std::vector<Region>(2);
  std::vector<std::uint32_t> probe_cells_;
  dealii::Triangulation<3> mesh_;
  HexSpace space_;
  LagrangeStep step_;
  AleState state_;
  dealii::AlignedVector<double> start_;
  HeadMeasures measures_;
};

const auto at_rest = [](const Point &x) { return x; };
} // namespace

// A body that turns has no strain, wherever it has come to.
TEST(HeadMeasures, AreThoseOfABodyThatTurns)
{
  MovedHead head;
  const Vector spin({30., -20., 10.});
  for (unsigned int i = 0; i <= 10; ++i)
  {
    const double time = 1e-3 * i;
    const auto turned =
      dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
        Point(spin / spin.norm()), spin.norm() * time);
    const auto place = [&](const Point &x) {
      return Point(turned * Vector(x));
    };
    head.follow(time, place, [&](const Point &x) {
      return cross_product_3d(spin, Vector(place(x)));
    });
  }
  const auto found = head.found();
  EXPECT_NEAR(found.at("injury_bric"),
              std::sqrt(std::pow(30. / 66.25, 2) + std::pow(20. / 56.45, 2) +
                        std::pow(10. / 42.87, 2)),
              1e-9);
  EXPECT_LT(found.at("injury_strain_95"), 1e-14);
  EXPECT_EQ(found.at("injury_csdm_15"), 0.);
  EXPECT_LT(found.at("injury_intracranial_pressure_peak"), 1e-4);
  EXPECT_GT(found.at("injury_intracranial_pressure_lowest"), -1e-4);
  // The skull's velocity at the centre of the head goes around, in chords that
  // the filter rounds off.
  const Vector speed = cross_product_3d(spin, Vector({0.04, 0.02, 0.01}));
  const double chord = 2. * speed.norm() * std::sin(0.5e-3 * spin.norm());
  const double expected = 0.01 * std::pow(chord / 1e-3 / gravity, 2.5);
  EXPECT_NEAR(found.at("injury_hic15"), expected, 2e-3 * expected);
}

// The criterion counts 15 of the 40 ms of 100 g; the head does not turn.
TEST(HeadMeasures, AreThoseOfABodyThatIsStopped)
{
  MovedHead head;
  for (unsigned int i = 0; i <= 40; ++i)
    head.follow(1e-3 * i, at_rest, [&](const Point &) {
      return Vector({0.6, 0., -0.8}) * (0.1 * i * gravity);
    });
  const auto found = head.found();
  EXPECT_NEAR(found.at("injury_hic15"), 0.015 * std::pow(100., 2.5), 0.1);
  EXPECT_NEAR(found.at("injury_bric"), 0., 1e-11);
}

// Pressures that alternate are left out but at the ends of the brain, where a
// cell counts three times as much as its neighbour.
TEST(HeadMeasures, AverageThePressuresOfNeighbours)
{
  const double strain = 1.5e-4, pressure = bulk_modulus * strain;
  for (const bool averaged : {true, false})
  {
    MovedHead head(
      8, {{"Injury", {{"Pressure", averaged ? "averaged" : "of elements"}}}});
    head.stretch(0., {});
    head.stretch(
      1e-3,
      {{-strain, strain, -strain, strain, -strain, strain, -strain, strain}});
    const auto found = head.found();
    const double part = averaged ? 0.5 : 1.;
    EXPECT_NEAR(found.at("injury_intracranial_pressure_peak"),
                part * pressure,
                1e-8 * pressure);
    EXPECT_NEAR(found.at("injury_intracranial_pressure_lowest"),
                -part * pressure,
                1e-8 * pressure);
    EXPECT_NEAR(
      found.at("injury_cavitating_fraction"), averaged ? 0.125 : 0.5, 1e-12);
    EXPECT_NEAR(
      found.at("injury_cavitation_dose"), averaged ? 0.125e-3 : 0.5e-3, 1e-14);
    // Averages keep half the pressure at both ends, none in six other layers.
    EXPECT_NEAR(found.at("injury_pressure_roughness"), std::sqrt(13.), 1e-6);
  }
}

TEST(HeadMeasures, CountTheBrainThatWasStrained)
{
  MovedHead head;
  head.stretch(0., {{0.16, 0.2, 0., 0., 0.4, 0.4}});
  head.stretch(1e-3, {{0., 0., 0., 0.3}});
  const auto found = head.found();
  EXPECT_NEAR(found.at("injury_csdm_15"), 0.75, 1e-12);
  EXPECT_NEAR(found.at("injury_csdm_25"), 0.25, 1e-12);
  EXPECT_GT(found.at("injury_strain_95"), 0.29);
}

// Half of a head whose other half is its mirror image: it turns about the
// normal of the plane alone and does not move along it.
TEST(HeadMeasures, OfAHalfAreThoseOfTheWhole)
{
  MovedHead half(
    4, {{"Mesh", {{"Kind", "layered head"}, {"Symmetry planes", "x"}}}});
  MovedHead quarter(
    4, {{"Mesh", {{"Kind", "layered head"}, {"Symmetry planes", "x, y"}}}});
  for (unsigned int i = 0; i < 2; ++i)
    for (MovedHead *head : {&half, &quarter})
      head->follow(1e-3 * i, at_rest, [&](const Point &x) {
        Vector v = cross_product_3d(Vector({20., 0., 0.}), Vector(x));
        v[0] = 100. * i + 50. * x[1];
        v[2] += 50. * gravity * 1e-3 * i;
        return v;
      });
  EXPECT_NEAR(half.found().at("injury_bric"), 20. / 66.25, 1e-12);
  EXPECT_NEAR(half.found().at("injury_hic15"), 1e-3 * std::pow(50., 2.5), 0.02);
  EXPECT_EQ(quarter.found().at("injury_bric"), 0.);
  for (MovedHead *head : {&half, &quarter})
    for (const auto &measure : head->measures().measures(MPI_COMM_WORLD))
      if (measure.value.name == "injury_bric")
      {
        EXPECT_EQ(measure.limits.find("symmetry keep the head from turning") !=
                    std::string::npos,
                  head == &quarter)
          << measure.limits;
      }
}

// A brain without a skull moves, too.
TEST(HeadMeasures, OfABrainAloneAreThoseOfItsMotion)
{
  MovedHead head(8, {{"Injury", {{"Skull", ""}}}});
  for (unsigned int i = 0; i < 2; ++i)
    head.follow(1e-3 * i, at_rest, [&](const Point &) {
      return Vector({0.1 * gravity * i, 0., 0.});
    });
  EXPECT_NEAR(head.found().at("injury_hic15"), 1e-3 * std::pow(100., 2.5), 0.1);
}

// The head is stretched, and later compressed along x.
TEST(HeadMeasures, AreLowerLimitsOfARunThatEndsEarly)
{
  const std::vector<ContactPlane> planes(
    1, {"wall", Point(), Vector({1., 0., 0.}), 0.});
  MovedHead head(8, {{"Injury", {{"Skull", ""}}}}, planes);
  std::array<double, 8> strains{};
  head.stretch(0., strains);
  strains.fill(1e-4);
  head.stretch(1e-3, strains);
  const auto marks = [&](const RunEnd &end) {
    std::set<std::string> found;
    for (const auto &value :
         solid::values_of(head.measures().measures(MPI_COMM_WORLD, end)))
      found.insert(value.name);
    for (const auto &value : head.measures().coup(MPI_COMM_WORLD, end))
      found.insert(value.name);
    std::string list;
    for (const char *name : {"injury_intracranial_pressure_peak",
                             "injury_intracranial_pressure_lowest",
                             "injury_cavitating_fraction",
                             "injury_csdm_15",
                             "injury_hic15",
                             "injury_pressure_roughness",
                             "coup_pressure",
                             "contrecoup_pressure"})
      list += found.count(std::string(name) + "_cut_off") > 0 ? '1' : '0';
    return list;
  };
  EXPECT_EQ(marks({}), "01010001");
  strains.fill(-1e-4);
  head.stretch(2e-3, strains);
  EXPECT_EQ(marks({}), "10000010");
  strains.fill(0.);
  head.stretch(3e-3, strains);
  EXPECT_EQ(marks({}), "00000000");
  EXPECT_EQ(marks({false, true}), "01000001");
  EXPECT_EQ(marks({true, false}), "11111011");
}

// Thresholds found for blunt impacts apply to them.
TEST(HeadMeasures, HaveNoLimitsOfABlast)
{
  MovedHead head(8, {});
  std::array<double, 8> strains{};
  head.stretch(0., strains);
  head.stretch(1e-3, strains);
  unsigned int n_pressures = 0;
  for (const auto &measure : head.measures().measures(MPI_COMM_WORLD, {}))
  {
    EXPECT_EQ(measure.limits.find("blast"), std::string::npos)
      << measure.value.name;
    n_pressures +=
      measure.limits.find("blunt impacts of several") != std::string::npos;
  }
  EXPECT_EQ(n_pressures, 1U);
}

// A contact that lasts, and a liquid whose least pressure is that of the end.
TEST(HeadMeasures, KnowWhatGoesOnWhenTheRunEnds)
{
  Region liquid, solid;
  solid.law = SolidMaterial();
  liquid.law = Tait(1000., 2e9, 7.15, -1e8);
  HeadRecord head;
  head.find({solid, liquid}, {});
  ContactRecord contact;
  ContactMeasures push;
  push.force = 1.;
  contact.add(push, 0.1, 0.1);
  for (const bool is_liquid : {false, true})
  {
    ExtremeRecord extremes;
    extremes.reinit(2, MPI_COMM_SELF);
    std::vector<RegionExtremes> row(2);
    for (RegionExtremes &one : row)
      one.least_pressure = one.largest_pressure = 0.;
    row[is_liquid ? 1 : 0].least_pressure = -1e5;
    extremes.add(row);
    extremes.take();
    EXPECT_EQ(head.end_at(0.1, contact, extremes).tension_grows, is_liquid);
  }
  ExtremeRecord none;
  none.reinit(2, MPI_COMM_SELF);
  EXPECT_TRUE(head.end_at(0.1, contact, none).contact_lasts);
  EXPECT_FALSE(head.end_at(0.2, contact, none).contact_lasts);
}

TEST(HeadMeasures, GoOnFromACheckpoint)
{
  const std::string folder = "head_measures_checkpoint";
  std::filesystem::create_directories(folder);
  MovedHead head, other;
  const auto turn = [](const Point &x) {
    return Vector({1., 0., 0.}) +
           cross_product_3d(Vector({3., 2., 1.}), Vector(x));
  };
  head.stretch(0., {{-5e-5, 1e-4, 0.2, 0.3}});
  head.follow(1e-3, at_rest, turn);
  io::save_part(folder, "records", MPI_COMM_WORLD, [&](io::StateWriter &out) {
    head.measures().save(out);
  });
  MPI_Barrier(MPI_COMM_WORLD);
  io::restore_parts(folder, "records", [&](io::StateReader &in) {
    other.measures().restore(other.snapshot(), in);
  });
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(other.found(), head.found());
  for (MovedHead *one : {&head, &other})
  {
    one->stretch(4e-3, {{0., 0., 0., 1e-4}});
    one->follow(5e-3, at_rest, [](const Point &) { return Vector(); });
  }
  EXPECT_EQ(other.found(), head.found());
  EXPECT_GT(head.found().at("injury_bric"), 0.05);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::remove_all(folder);
}
