// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/conditions/profile_file.h>
#include <contrecoup/gas/hand_over/profile_extraction.h>
#include <contrecoup/gas/hand_over/profile_mapping.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/io/file/checked_file.h>

#include "gas_run.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
constexpr double ambient_density = 1.225;
constexpr double ambient_pressure = 101325.;
constexpr double ambient_energy = ambient_pressure / 0.4;

/// A blast: a hot core and a shell behind a front at 0.5 m, in ideal gas.
GasState<1> blast(const double radius)
{
  GasState<1> state;
  const bool inside = radius < 0.5;
  const double x = radius / 0.5;
  state.density = inside ? 0.1 + 5. * std::pow(x, 8) : ambient_density;
  state.pressure = inside ? 4e5 + 1.1e6 * std::pow(x, 6) : ambient_pressure;
  state.velocity[0] = inside ? 900. * x : 0.;
  state.products = inside && x < 0.4 ? 0.8 : 0.;
  return state;
}


ProfileData blast_data(const unsigned int n = 500)
{
  ProfileData data;
  data.time = 2e-4;
  data.material = "ideal gas";
  data.version = "test";
  data.ambient = {{ambient_density, ambient_energy, 0.}};
  data.ambient_pressure = ambient_pressure;
  data.domain_begin = {0.};
  data.domain_end = {1.};
  data.edges.resize(1);
  data.values.resize(4);
  for (unsigned int i = 0; i < n; ++i)
  {
    const double begin = 0.5 * i / n;
    const auto state = blast(begin + 0.25 / n);
    data.edges[0].push_back(begin);
    data.values[0].push_back(state.density);
    data.values[1].push_back(state.density * state.velocity[0]);
    data.values[2].push_back(state.pressure / 0.4 + 0.5 * state.density *
                                                      state.velocity[0] *
                                                      state.velocity[0]);
    data.values[3].push_back(state.density * state.products);
  }
  data.edges[0].push_back(0.5);
  return data;
}


template <int dim>
GasState<dim> background()
{
  GasState<dim> state;
  state.density = ambient_density;
  state.pressure = ambient_pressure;
  return state;
}


/// Maps the blast around @p centre and checks totals: those of the profile's
/// part @p part beyond gas at rest, to round-off.
template <int dim>
ProfileMapping check_mapping(GasRun<dim> &run,
                             const Point<dim> &centre,
                             const double part,
                             const unsigned int refinements)
{
  const auto profile = std::make_shared<const Profile>(blast_data());
  const ProfileField<dim> placed(profile,
                                 centre,
                                 background<dim>(),
                                 run.material,
                                 run.coarse_mesh.geometry());
  for (unsigned int i = 0; i < refinements; ++i)
  {
    for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
      if (is_steep_in(placed, leaf_box(run.mesh, leaf), run.layout.n))
        run.mesh.cell(leaf)->set_refine_flag();
    run.mesh.triangulation().execute_coarsening_and_refinement();
    run.mesh.distribute();
  }
  run.set_state([](const Point<dim> &) { return background<dim>(); });
  const auto before = run.totals();
  const auto mapping =
    map_profile(placed, run.mesh, run.points, run.material, run.field);
  const auto after = run.totals();
  EXPECT_TRUE(mapping.is_complete);
  const auto &totals = profile->totals();
  EXPECT_NEAR(after.at("mass"),
              before.at("mass") + part * totals[0],
              1e-13 * before.at("mass"));
  EXPECT_NEAR(after.at("energy"),
              before.at("energy") + part * totals[2],
              1e-13 * after.at("energy"));
  if (run.material.has_products())
  {
    EXPECT_NEAR(after.at("products_mass"), part * totals[3], 1e-13 * totals[3]);
  }
  EXPECT_GT(after.at("smallest_pressure"), 0.);
  return mapping;
}


std::string scratch(const std::string &name)
{
  const auto folder = std::filesystem::temp_directory_path() /
                      ("contrecoup_profile_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  return (folder / name).string();
}


void expect_equal(const ProfileData &a, const ProfileData &b)
{
  EXPECT_EQ(a.geometry, b.geometry);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.version, b.version);
  EXPECT_EQ(a.ambient, b.ambient);
  EXPECT_EQ(a.ambient_pressure, b.ambient_pressure);
  EXPECT_EQ(a.domain_begin, b.domain_begin);
  EXPECT_EQ(a.domain_end, b.domain_end);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.maps, b.maps);
}
} // namespace


TEST(Profile, MeansAreExactIntegralsOfTheCells)
{
  ProfileData data = blast_data(4);
  for (unsigned int i = 0; i < 4; ++i)
    data.values[0][i] = ambient_density + i + 1.;
  const Profile profile(data);
  std::array<double, 4> means;
  // From the middle of cell 1 to a quarter of a cell beyond the raster.
  profile.mean({{0.1875, 0.}}, {{0.53125, 0.}}, means.data());
  EXPECT_NEAR(
    means[0], (0.0625 * 2. + 0.125 * 3. + 0.125 * 4.) / 0.34375, 1e-14);
  // Only what is in the domain counts.
  profile.mean({{-0.125, 0.}}, {{0.125, 0.}}, means.data());
  EXPECT_NEAR(means[0], 1., 1e-14);
  profile.mean({{0.6, 0.}}, {{0.7, 0.}}, means.data());
  EXPECT_NEAR(means[0], 0., 1e-15);

  double mass = 0.;
  for (unsigned int i = 0; i < 4; ++i)
    mass += 4. / 3. * dealii::numbers::PI * (i + 1.) *
            (std::pow((i + 1) * 0.125, 3) - std::pow(i * 0.125, 3));
  EXPECT_NEAR(profile.totals()[0], mass, 1e-14);
}


TEST(Profile, VariationSumsTheLogarithms)
{
  ProfileData data = blast_data(4);
  data.values[0] = {1., 2., 2., ambient_density};
  data.values[2] = {
    ambient_energy, ambient_energy, 3. * ambient_energy, ambient_energy};
  const Profile profile(data);
  const double whole = profile.variation({{0., 0.}}, {{0.5, 0.}});
  EXPECT_NEAR(whole,
              std::log(2.) + std::log(2. / ambient_density) + 2. * std::log(3.),
              1e-13);
}


TEST(Profile, RefusesWhatIsNone)
{
  ProfileData data = blast_data(4);
  data.values[2][1] = -1.;
  EXPECT_THROW(Profile{data}, InputError);
  data = blast_data(4);
  data.values.pop_back();
  EXPECT_THROW(Profile{data}, InputError);
  data = blast_data(4);
  std::swap(data.edges[0][1], data.edges[0][2]);
  EXPECT_THROW(Profile{data}, InputError);
}


TEST(ProfileFile, BothFormatsKeepEveryBit)
{
  ProfileData data = blast_data(37);
  data.maps["peak"] = std::vector<double>(37, 1. / 3.);
  for (const std::string name : {"blast.h5", "blast.csv"})
  {
    write_profile(scratch(name), data);
    expect_equal(data, read_profile(scratch(name)));
  }
  // Two directions.
  data.geometry = Geometry::axisymmetric;
  data.edges.push_back({-1., 0.25, 1.});
  data.domain_begin.push_back(-1.);
  data.domain_end.push_back(2.);
  data.values.insert(data.values.begin() + 1, data.values[1]);
  for (auto &values : data.values)
    values.insert(values.end(), values.begin(), values.begin() + 37);
  data.maps["peak"].resize(74, 0.1);
  for (const std::string name : {"blast.h5", "blast.csv"})
  {
    write_profile(scratch(name), data);
    expect_equal(data, read_profile(scratch(name)));
  }
}


TEST(ProfileFile, RefusesOtherFiles)
{
  EXPECT_THROW(read_profile(scratch("missing.h5")), InputError);
  std::ofstream(scratch("text.h5")) << "no HDF5\n";
  EXPECT_THROW(read_profile(scratch("text.h5")), InputError);
  std::ofstream(scratch("text.csv")) << "# geometry = spherical\na,b\n1,x\n";
  EXPECT_THROW(read_profile(scratch("text.csv")), InputError);
}


TEST(ProfileFile, RefusesANewerFormat)
{
  for (const char *name : {"newer.csv", "newer.h5"})
  {
    write_profile(scratch(name), blast_data(3));
    std::string text = io::read_file(scratch(name));
    const std::string format = "contrecoup profile 1";
    ASSERT_NE(text.find(format), std::string::npos) << name;
    text[text.find(format) + format.size() - 1] = '2';
    io::write_file(scratch(name), [&](std::ostream &out) { out << text; });
    try
    {
      read_profile(scratch(name));
      ADD_FAILURE() << name;
    }
    catch (const InputError &error)
    {
      EXPECT_EQ(error.what(),
                "\"" + scratch(name) +
                  "\" has format 2, this program reads up to 1");
    }
  }
}

TEST(ProfileMapping, KeepsTotalsInSpaceAndItsParts)
{
  const std::vector<std::string> box = {"Domain/Lower corner=-1, -0.8, 0",
                                        "Domain/Upper corner=1, 0.8, 1.2",
                                        "Domain/Coarse leaves=2, 2, 1"};
  {
    GasRun<3> run(box + finite_volume(8));
    const auto mapping = check_mapping<3>(run, {0.1, 0., 0.6}, 1., 1);
    EXPECT_NEAR(mapping.factors[0], 1., 2e-4);
    EXPECT_NEAR(mapping.factors[2], 1., 2e-4);
  }
  {
    GasRun<3> run(box + finite_volume(4) + products_in_air());
    const auto mapping = check_mapping<3>(run, {-1., 0.1, 0.}, 0.25, 2);
    EXPECT_NEAR(mapping.factors[1], 1., 2e-2);
  }
  GasRun<3> run(box + galerkin(3));
  check_mapping<3>(run, {0., 0., 0.}, 0.5, 1);
}


TEST(ProfileMapping, KeepsTotalsAroundTheAxis)
{
  const std::vector<std::string> box = {"Domain/Geometry=axisymmetric",
                                        "Domain/Upper corner=1, 1.5",
                                        "Domain/Coarse leaves=2, 3"};
  GasRun<2> run(box + finite_volume(8));
  const auto mapping = check_mapping<2>(run, {0., 0.75}, 1., 2);
  EXPECT_NEAR(mapping.factors[0], 1., 1e-3);
  GasRun<2> half(box + finite_volume(8) + products_in_air());
  check_mapping<2>(half, {0., 0.}, 0.5, 2);
}


TEST(ProfileMapping, IsScaledOnlyWhereItIsComplete)
{
  GasRun<3> run(finite_volume(8) +
                std::vector<std::string>{"Domain/Coarse leaves=2, 2, 2"});
  const ProfileField<3> placed(std::make_shared<const Profile>(blast_data()),
                               {0.2, 0.5, 0.5},
                               background<3>(),
                               run.material,
                               Geometry::plane);
  run.set_state([](const Point<3> &) { return background<3>(); });
  const auto mapping =
    map_profile(placed, run.mesh, run.points, run.material, run.field);
  EXPECT_FALSE(mapping.is_complete);
  EXPECT_EQ(mapping.factors[0], 1.);
}


TEST(ProfileMapping, SeesABlastInOneCell)
{
  GasRun<3> run(finite_volume(2) +
                std::vector<std::string>{"Domain/Lower corner=-50, -50, -50",
                                         "Domain/Upper corner=50, 50, 50"});
  check_mapping<3>(run, {0., 0., 0.}, 1., 0);
  GasRun<3> off(finite_volume(2) +
                std::vector<std::string>{"Domain/Lower corner=-50, -50, -50",
                                         "Domain/Upper corner=50, 50, 50"});
  const auto mapping = check_mapping<3>(off, {20.1, 30.3, -20.2}, 1., 0);
  EXPECT_NEAR(mapping.factors[2], 1., 0.01);
}


TEST(ProfileMapping, PointsAwayFromTheCentreAndIsAccurate)
{
  GasRun<3> run(finite_volume(8) +
                std::vector<std::string>{"Domain/Coarse leaves=3, 3, 3"});
  check_mapping<3>(run, {0., 0., 0.}, 0.125, 1);
  double error = 0., norm = 0.;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto box = leaf_box(run.mesh, leaf);
    const auto values = run.field.leaf(leaf);
    const unsigned int n = run.layout.n_points;
    for (unsigned int q = 0; q < n; ++q)
    {
      const auto index = run.points.indices(q);
      Point<3> place = box.origin;
      for (unsigned int d = 0; d < 3; ++d)
        place[d] += box.extents[d] * run.points.position(index[d]);
      const auto exact = blast(place.norm());
      const double volume = point_volume(box, run.points, q);
      error += volume * std::abs(values[q] - exact.density);
      norm += volume * exact.density;
      const dealii::Tensor<1, 3> momentum(
        {values[n + q], values[2 * n + q], values[3 * n + q]});
      if (momentum.norm() > 0.)
      {
        EXPECT_GT(momentum * place / (momentum.norm() * place.norm()), 0.98);
      }
    }
  }
  error = dealii::Utilities::MPI::sum(error, MPI_COMM_WORLD);
  norm = dealii::Utilities::MPI::sum(norm, MPI_COMM_WORLD);
  EXPECT_LT(error / norm, 0.01);
}


TEST(ProfileField, RefusesOtherGasAndOtherShapes)
{
  const auto profile = std::make_shared<const Profile>(blast_data());
  const GasMaterial air;
  auto warm = background<3>();
  warm.pressure *= 1.01;
  EXPECT_THROW(ProfileField<3>(profile, {}, warm, air, Geometry::plane),
               InputError);
  EXPECT_THROW(
    ProfileField<2>(profile, {}, background<2>(), air, Geometry::plane),
    InputError);
  EXPECT_THROW(
    ProfileField<2>(
      profile, {0.1, 0.}, background<2>(), air, Geometry::axisymmetric),
    InputError);
  auto wind = background<3>();
  wind.velocity[0] = 1.;
  EXPECT_THROW(ProfileField<3>(profile, {}, wind, air, Geometry::plane),
               InputError);
}


TEST(ProfileExtraction, HasTheTotalsOfTheField)
{
  GasRun<1> run({"Domain/Geometry=spherical",
                 "Domain/Coarse leaves=40",
                 "Boundaries/x high=open"});
  const auto ball = [](const auto &p) {
    auto state = background<std::decay_t<decltype(p)>::dimension>();
    if (p.norm() < 0.11)
    {
      state.density = 30.;
      state.pressure = 3e7;
    }
    return state;
  };
  run.set_state(ball);
  const auto rest = run.totals();
  run.steps(50);
  const auto data = extract_profile<1>(run.mesh,
                                       run.points,
                                       run.field,
                                       run.material,
                                       background<1>(),
                                       BlastMaps<1>());
  const Profile profile(data);
  EXPECT_LT(profile.end(0), 0.9);
  const double volume = 4. / 3. * dealii::numbers::PI;
  EXPECT_NEAR(profile.totals()[0] + volume * ambient_density,
              rest.at("mass"),
              1e-12 * rest.at("mass"));
  EXPECT_NEAR(profile.totals()[2] + volume * ambient_energy,
              rest.at("energy"),
              1e-12 * rest.at("energy"));

  // The same around an axis, with coarser leaves.
  GasRun<2> flat({"Domain/Geometry=axisymmetric",
                  "Domain/Lower corner=0, -1",
                  "Domain/Coarse leaves=4, 8"});
  flat.refine([](const Point<2> &p) { return p.norm() < 0.3; });
  flat.set_state(ball);
  flat.steps(10);
  const auto totals = flat.totals();
  const Profile raster(extract_profile<2>(flat.mesh,
                                          flat.points,
                                          flat.field,
                                          flat.material,
                                          background<2>(),
                                          BlastMaps<2>()));
  const double cylinder = 2. * dealii::numbers::PI;
  EXPECT_NEAR(raster.totals()[0] + cylinder * ambient_density,
              totals.at("mass"),
              1e-12 * totals.at("mass"));
  EXPECT_NEAR(raster.totals()[3] + cylinder * ambient_energy,
              totals.at("energy"),
              1e-12 * totals.at("energy"));
}
