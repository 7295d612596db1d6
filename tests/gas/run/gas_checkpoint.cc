// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/run/gas_checkpoint.h>

#include "gas_run.h"
#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
unsigned int my_rank()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
}


/// An empty folder that all ranks of this run share, removed at the end.
class Folder
{
public:
  Folder()
    : path_((std::filesystem::temp_directory_path() /
             ("contrecoup_gas_checkpoint_" +
              std::to_string(
                dealii::Utilities::MPI::max(getpid(), MPI_COMM_WORLD))))
              .string())
  {
    if (my_rank() == 0)
    {
      std::filesystem::remove_all(path_);
      std::filesystem::create_directory(path_);
    }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  ~Folder()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (my_rank() == 0)
      std::filesystem::remove_all(path_);
    MPI_Barrier(MPI_COMM_WORLD);
  }

  const std::string &path() const
  {
    return path_;
  }

private:
  const std::string path_;
};


const std::vector<std::string> scene = {"Domain/Coarse leaves=2, 1, 1",
                                        "Domain/Initial refinement=1"};


template <int dim>
std::unique_ptr<GasRun<dim>> make_run(const std::vector<std::string> &method,
                                      const MPI_Comm communicator)
{
  auto run = std::make_unique<GasRun<dim>>(scene + method, communicator);
  if (dim > 1)
    for (unsigned int i = 0; i < 3; ++i)
      run->refine([](const Point<dim> &p) { return p.norm() < 0.4; });
  run->set_state([](const Point<dim> &p) {
    GasState<dim> state;
    state.density = 1.5 + ripple(p[0], 1) * ripple(p[dim - 1], 2);
    state.pressure = 1e5 * (2. + ripple(p[0] + p[dim - 1], 3));
    state.velocity[0] = 100. * ripple(p[dim - 1], 4);
    return state;
  });
  return run;
}


/// Restores into a new mesh.
template <int dim>
std::unique_ptr<GasRun<dim>> restore(const std::vector<std::string> &method,
                                     const std::string &folder,
                                     const MPI_Comm communicator)
{
  auto run = std::make_unique<GasRun<dim>>(
    std::vector<std::string>{scene[0]} + method, communicator);
  restore_leaves(run->mesh, run->field, run->layout, folder);
  return run;
}


/// Leaves of all ranks of a run are those of @p expected, bit for bit.
template <int dim>
void expect_same(const GasRun<dim> &run, const GasRun<dim> &expected)
{
  const auto all = expected.leaves();
  const auto mine = run.leaves();
  EXPECT_EQ(run.mesh.n_global(), expected.mesh.n_global());
  for (const auto &[name, values] : mine)
  {
    ASSERT_TRUE(all.count(name)) << name;
    EXPECT_EQ(values, all.at(name)) << name;
  }
}


template <int dim>
void check(const std::vector<std::string> &method)
{
  const Folder one, all;
  const auto alone = make_run<dim>(method, MPI_COMM_SELF);
  const auto together = make_run<dim>(method, MPI_COMM_WORLD);
  if (my_rank() == 0)
    save_leaves(alone->mesh, alone->field, one.path());
  MPI_Barrier(MPI_COMM_WORLD);
  save_leaves(together->mesh, together->field, all.path());
  MPI_Barrier(MPI_COMM_WORLD);

  expect_same(*restore<dim>(method, one.path(), MPI_COMM_WORLD), *alone);
  expect_same(*restore<dim>(method, all.path(), MPI_COMM_SELF), *alone);
  expect_same(*restore<dim>(method, all.path(), MPI_COMM_WORLD), *alone);
}


/// The message with which a checkpoint is refused; empty when it is not.
template <int dim>
std::string refusal(const std::vector<std::string> &method,
                    const std::string &folder)
{
  try
  {
    restore<dim>(method, folder, MPI_COMM_SELF);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace


TEST(GasCheckpoint, AnyNumberOfRanksGivesTheSameBits)
{
  check<1>(finite_volume(8));
  check<2>(finite_volume(4));
  check<2>(galerkin(3));
  check<3>(finite_volume(2));
}


TEST(GasCheckpoint, GoesOnAsIfNothingHadHappened)
{
  const Folder folder;
  const auto straight = make_run<2>(finite_volume(4), MPI_COMM_WORLD);
  straight->steps(3);
  save_leaves(straight->mesh, straight->field, folder.path());
  MPI_Barrier(MPI_COMM_WORLD);
  const auto resumed =
    restore<2>(finite_volume(4), folder.path(), MPI_COMM_WORLD);
  resumed->stepper->reinit(resumed->field);
  straight->steps(3);
  resumed->steps(3);
  EXPECT_EQ(straight->leaves(), resumed->leaves());
}


TEST(GasCheckpoint, ForeignScenesAreRefused)
{
  const Folder folder;
  const auto run = make_run<2>(finite_volume(4), MPI_COMM_SELF);
  if (my_rank() == 0)
    save_leaves(run->mesh, run->field, folder.path());
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(refusal<2>(finite_volume(4), folder.path()), "");
  for (const std::string &message :
       {refusal<2>(finite_volume(8), folder.path()),
        refusal<3>(finite_volume(4), folder.path()),
        refusal<2>(finite_volume(4) + products_in_air(), folder.path())})
    EXPECT_NE(message.find("belongs to another scene"), std::string::npos)
      << message;
  EXPECT_NE(refusal<2>(finite_volume(4), folder.path() + "/none"), "");
}


TEST(GasCheckpoint, OtherCoarseMeshesAreRefused)
{
  // One octree has leaves that were not saved, the other lacks some.
  const Folder folder;
  const auto run = make_run<2>(finite_volume(4), MPI_COMM_SELF);
  if (my_rank() == 0)
    save_leaves(run->mesh, run->field, folder.path());
  MPI_Barrier(MPI_COMM_WORLD);
  for (const std::string leaves : {"3, 1", "1, 1"})
  {
    GasRun<2> other(std::vector<std::string>{"Domain/Coarse leaves=" + leaves} +
                      finite_volume(4),
                    MPI_COMM_SELF);
    EXPECT_THROW(
      restore_leaves(other.mesh, other.field, other.layout, folder.path()),
      InputError);
  }
}


TEST(GasCheckpoint, TruncatedFilesAreRefused)
{
  const Folder folder;
  const auto run = make_run<2>(finite_volume(4), MPI_COMM_SELF);
  const std::string file = folder.path() + "/octree.0.bin";
  if (my_rank() == 0)
    save_leaves(run->mesh, run->field, folder.path());
  MPI_Barrier(MPI_COMM_WORLD);
  const auto size = std::filesystem::file_size(file);
  for (const double part : {0.9, 0.02, 0.})
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (my_rank() == 0)
      std::filesystem::resize_file(file, size * part);
    MPI_Barrier(MPI_COMM_WORLD);
    EXPECT_NE(refusal<2>(finite_volume(4), folder.path()), "") << part;
  }
}
