// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "harness.h"

#include <deal.II/base/mpi.h>

#include "oscillator.h"
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace contrecoup
{
namespace io
{
  namespace fs = std::filesystem;

  Result run_oscillator(const std::vector<std::string> &arguments,
                        const bool verbose)
  {
    std::vector<std::string> words = {"oscillator"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    if (verbose)
      words.push_back("--verbose");
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Result result;
    result.code = run_application(
      static_cast<int>(words.size()), argv.data(), oscillator_application());
    result.out = testing::internal::GetCapturedStdout();
    result.err = testing::internal::GetCapturedStderr();
    MPI_Barrier(MPI_COMM_WORLD);
    return result;
  }

  Result run_scene(const std::string &folder,
                   const std::vector<std::string> &arguments)
  {
    std::vector<std::string> all = {scene(), "--output", folder};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_oscillator(all);
  }

  std::string local(const std::string &name)
  {
    const std::string folder = "ranks_" + std::to_string(n_ranks());
    if (is_first_rank())
      fs::create_directories(folder);
    MPI_Barrier(MPI_COMM_WORLD);
    return folder + "/" + name;
  }

  std::string scene()
  {
    const std::string file = local("scene.prm");
    if (is_first_rank())
      std::ofstream(file) << "subsection Time\n"
                             "  set End time = 3.3\n"
                             "end\n"
                             "subsection Output\n"
                             "  set Fields interval = 1\n"
                             "end\n";
    MPI_Barrier(MPI_COMM_WORLD);
    return file;
  }

  void remove(const std::string &folder)
  {
    if (is_first_rank())
      fs::remove_all(folder);
    MPI_Barrier(MPI_COMM_WORLD);
  }

  std::string content(const std::string &file)
  {
    std::ifstream input(file, std::ios::binary);
    std::ostringstream text;
    text << input.rdbuf();
    return text.str();
  }

  bool exists(const std::string &path)
  {
    return fs::exists(path);
  }

  bool is_first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  int n_ranks()
  {
    return static_cast<int>(
      dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  }

  FullDisk::FullDisk(const unsigned long largest_file)
    : old_handler_(std::signal(SIGXFSZ, SIG_IGN))
  {
    rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    old_limit_ = limit.rlim_cur;
    limit.rlim_cur = largest_file;
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  FullDisk::~FullDisk()
  {
    rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = old_limit_;
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, old_handler_);
  }
} // namespace io
} // namespace contrecoup
