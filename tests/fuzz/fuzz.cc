// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "fuzz.h"

#include <contrecoup/base/system/exceptions.h>

#include <deal.II/base/mpi.h>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace contrecoup::fuzz
{
namespace
{
  namespace fs = std::filesystem;

  constexpr unsigned int longest = 60; // s, for one file
  [[maybe_unused]] constexpr std::uint64_t memory = 2ull << 30; // bytes
  constexpr unsigned int most_failures = 20;                    // of one reader
  constexpr std::uint64_t default_inputs = 10000;               // with number 0
  constexpr int exit_of_failure = 99, exit_of_prepare = 98;

  struct Options
  {
    std::uint64_t inputs = default_inputs;
    double seconds = 1e9;
    std::uint64_t least = 100; // inputs, however long they take
    std::string reader;
    std::string replay;
  };

  /// Report of the reading process to its parent.
  struct Progress
  {
    std::uint64_t number;
    std::uint64_t loaded;
    std::uint64_t refused;
    char problem[512];
  };

  double now()
  {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
  }

  std::string version_of(const Reader &reader,
                         const std::string &content,
                         const std::uint64_t number)
  {
    return reader.mutate ? reader.mutate(content, number)
                         : mutate(content, number);
  }

  /// Number of inputs with that of the file itself.
  std::uint64_t inputs_of(const Reader &reader, const Options &options)
  {
    return reader.versions == 0 ? options.inputs
                                : std::min(options.inputs, reader.versions + 1);
  }

  std::string content_of(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void put(const std::string &path, const std::string &content)
  {
    std::ofstream(path, std::ios::binary) << content;
  }

  void tell(Progress &progress, const std::string &problem)
  {
    std::strncpy(progress.problem, problem.c_str(), 511);
  }

  /// Reads one file. @return whether the reader behaved
  bool read(const Reader &reader, const std::string &path, Progress &progress)
  {
    try
    {
      reader.read(path);
      ++progress.loaded;
      return true;
    }
    catch (const InputError &error)
    {
      ++progress.refused;
      const std::string message = error.what();
      if (message.empty() || message.find('\n') != std::string::npos)
      {
        tell(progress, "refused, but not in one line: " + message);
        return false;
      }
      return true;
    }
    catch (const std::exception &error)
    {
      tell(progress, std::string("threw ") + error.what());
      return false;
    }
  }

  /// Not with the address sanitizer, whose shadow of all addresses counts.
  void limit_memory()
  {
#ifndef __SANITIZE_ADDRESS__
    rlimit limit{};
    limit.rlim_cur = limit.rlim_max = memory;
    setrlimit(RLIMIT_DATA, &limit);
#endif
  }

  /// The process that reads, from a number on.
  [[noreturn]] void read_all(const Reader &reader,
                             const std::string &folder,
                             const std::string &content,
                             const Options &options,
                             const double end,
                             Progress &progress)
  {
    // Output and dumps of libraries are of no interest.
    std::freopen("/dev/null", "w", stdout);
    std::freopen("/dev/null", "w", stderr);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL})
      std::signal(signal, SIG_DFL);
    limit_memory();
    const std::string path = folder + "/" + reader.file;
    const std::uint64_t inputs = inputs_of(reader, options);
    while (progress.number < inputs &&
           (now() < end || progress.number < options.least))
    {
      put(path, version_of(reader, content, progress.number));
      alarm(longest);
      const bool is_good = read(reader, path, progress);
      alarm(0);
      if (!is_good || (progress.number == 0 && progress.loaded == 0))
        _exit(is_good ? exit_of_prepare : exit_of_failure);
      ++progress.number;
    }
    _exit(0);
  }

  std::string words_of(const int status, const Progress &progress)
  {
    if (WIFSIGNALED(status))
      return WTERMSIG(status) == SIGALRM
               ? "took more than " + std::to_string(longest) + " s"
               : std::string("died: ") + strsignal(WTERMSIG(status));
    if (WEXITSTATUS(status) == exit_of_prepare)
      return "refused the valid file";
    if (WEXITSTATUS(status) == exit_of_failure)
      return progress.problem;
    return "ended with exit code " + std::to_string(WEXITSTATUS(status));
  }

  /// A child that calls a function; its status.
  template <typename Function>
  int in_child(const Function &function)
  {
    std::cout.flush();
    const pid_t child = fork();
    if (child == 0)
    {
      // Some readers are collective.
      int argc = 0;
      char **argv = nullptr;
      MPI_Init(&argc, &argv);
      function();
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }

  std::string keep(const Reader &reader,
                   const std::string &content,
                   const std::uint64_t number)
  {
    fs::create_directories("fuzz_failures");
    const std::string path = "fuzz_failures/" + reader.name + "_" +
                             std::to_string(number) +
                             fs::path(reader.file).extension().string();
    put(path, version_of(reader, content, number));
    return path;
  }

  /// @return number of files that a reader could not cope with
  unsigned int
  try_reader(const Reader &reader, const Options &options, Progress &progress)
  {
    std::memset(&progress, 0, sizeof(progress));
    const double begin = now();
    const std::string folder = (fs::temp_directory_path() /
                                ("contrecoup_fuzz_" + std::to_string(getpid())))
                                 .string();
    fs::remove_all(folder);
    fs::create_directories(folder);
    in_child([&]() { reader.prepare(folder); });
    const std::string content = content_of(folder + "/" + reader.file);
    unsigned int failures = 0;
    const std::uint64_t inputs = inputs_of(reader, options);
    while (progress.number < inputs && failures < most_failures &&
           (now() < begin + options.seconds || progress.number < options.least))
    {
      const int status = in_child([&]() {
        read_all(
          reader, folder, content, options, begin + options.seconds, progress);
      });
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        break;
      ++failures;
      std::cout << reader.name << ": input " << progress.number << " "
                << words_of(status, progress) << "; kept as "
                << keep(reader, content, progress.number) << "\n";
      ++progress.number;
    }
    std::cout << reader.name << ": " << progress.number << " inputs, "
              << progress.loaded << " loaded, " << progress.refused
              << " refused, " << failures << " failures, " << now() - begin
              << " s" << std::endl;
    fs::remove_all(folder);
    return failures;
  }

  /// Reads one kept file in this process, for a debugger.
  int replay(const Reader &reader, const std::string &file)
  {
    int argc = 0;
    char **argv = nullptr;
    MPI_Init(&argc, &argv);
    const std::string folder = "fuzz_replay";
    fs::create_directories(folder);
    reader.prepare(folder);
    put(folder + "/" + reader.file, content_of(file));
    try
    {
      reader.read(folder + "/" + reader.file);
      std::cout << "loaded\n";
    }
    catch (const std::exception &error)
    {
      std::cout << "threw " << error.what() << "\n";
    }
    MPI_Finalize();
    return 0;
  }

  Options parse(const int argc, char **argv)
  {
    Options options;
    for (int i = 1; i + 1 < argc; i += 2)
    {
      const std::string name = argv[i], value = argv[i + 1];
      if (name == "--inputs")
        options.inputs = std::stoull(value);
      else if (name == "--seconds")
        options.seconds = std::stod(value);
      else if (name == "--least")
        options.least = std::stoull(value);
      else if (name == "--reader")
        options.reader = value;
      else if (name == "--replay")
        options.replay = value;
    }
    return options;
  }
} // namespace


int run(const int argc, char **argv, const std::vector<Reader> &readers)
{
  const Options options = parse(argc, argv);
  auto *const progress =
    static_cast<Progress *>(mmap(nullptr,
                                 sizeof(Progress),
                                 PROT_READ | PROT_WRITE,
                                 MAP_SHARED | MAP_ANONYMOUS,
                                 -1,
                                 0));
  unsigned int failures = 0;
  std::uint64_t inputs = 0;
  for (const Reader &reader : readers)
    if (options.reader.empty() || options.reader == reader.name)
    {
      if (!options.replay.empty())
        return replay(reader, options.replay);
      failures += try_reader(reader, options, *progress);
      inputs += progress->number;
    }
  std::cout << inputs << " inputs in all, " << failures << " failures\n";
  if (inputs == 0)
    std::cout << "there is no such reader\n";
  return failures == 0 && inputs > 0 ? 0 : 1;
}
} // namespace contrecoup::fuzz
