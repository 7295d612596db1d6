// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/study/child_process.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

namespace contrecoup::study
{
namespace
{
  constexpr int stop_signals[] = {SIGTERM, SIGINT, SIGXFSZ, SIGPIPE};

  /// Whether a variable makes an MPI library join a running job. Settings of
  /// the user are kept.
  bool belongs_to_mpi_job(const std::string &variable)
  {
    for (const char *kept : {"OMPI_ALLOW_RUN_AS_ROOT",
                             "PMIX_MCA_",
                             "PRTE_MCA_rmaps",
                             "PRTE_MCA_hwloc"})
      if (begins_with(variable, kept))
        return false;
    for (const char *of_job : {"OMPI_MCA_orte",
                               "OMPI_MCA_ess",
                               "OMPI_MCA_pmix",
                               "OMPI_MCA_initial",
                               "PMIX_",
                               "PMI_",
                               "PRTE_",
                               "HYDI_"})
      if (begins_with(variable, of_job))
        return true;
    return begins_with(variable, "OMPI_") &&
           !begins_with(variable, "OMPI_MCA_");
  }

  bool has_variable(const std::vector<std::string> &variables,
                    const std::string &name)
  {
    for (const std::string &variable : variables)
      if (begins_with(variable, name + "="))
        return true;
    return false;
  }

  /// Environment of a child. Concurrent runs must not all bind their ranks to
  /// the first cores; Open MPI 5 has other names for these settings.
  std::vector<std::string>
  child_variables(const std::vector<std::string> &further)
  {
    std::vector<std::string> variables = further;
    for (char **entry = environ; *entry != nullptr; ++entry)
    {
      const std::string text = *entry;
      if (!belongs_to_mpi_job(text) &&
          !has_variable(further, text.substr(0, text.find('='))))
        variables.push_back(text);
    }
    std::vector<std::string> defaults = {
      "OMPI_MCA_hwloc_base_binding_policy=none",
      "OMPI_MCA_rmaps_base_oversubscribe=1",
      "PRTE_MCA_hwloc_default_binding_policy=none",
      "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe",
      "OMP_NUM_THREADS=1"};
    if (geteuid() == 0)
      defaults.insert(
        defaults.end(),
        {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
    for (const std::string &variable : defaults)
      if (!has_variable(variables, variable.substr(0, variable.find('='))))
        variables.push_back(variable);
    return variables;
  }

  std::vector<char *> pointers(const std::vector<std::string> &texts)
  {
    std::vector<char *> result;
    for (const std::string &text : texts)
      result.push_back(const_cast<char *>(text.c_str()));
    result.push_back(nullptr);
    return result;
  }

  /// Code of the new process before exec(): only async-signal-safe calls.
  /// Returns if one fails.
  void exec_child(char *const *command,
                  char *const *variables,
                  const char *output_file,
                  const char *error_file,
                  const pid_t parent)
  {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
      _exit(1);
    for (const int number : stop_signals)
      std::signal(number, SIG_DFL);
    const int input = open("/dev/null", O_RDONLY);
    const int output =
      open(output_file, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    const int errors =
      open(error_file, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    if (input >= 0 && output >= 0 && errors >= 0 && dup2(input, 0) >= 0 &&
        dup2(output, 1) >= 0 && dup2(errors, 2) >= 0)
      execvpe(command[0], command, variables);
  }

  ProcessEnd to_end(const int status)
  {
    ProcessEnd end;
    if (WIFSIGNALED(status))
      end.signal = WTERMSIG(status);
    else
      end.exit_code = WEXITSTATUS(status);
    return end;
  }
} // namespace

ChildProcess::ChildProcess(const std::vector<std::string> &command,
                           const std::string &output_file,
                           const std::string &error_file,
                           const std::vector<std::string> &further)
  : begin_(std::chrono::steady_clock::now())
{
  const std::vector<std::string> variables = child_variables(further);
  const std::vector<char *> words = pointers(command);
  const std::vector<char *> environment = pointers(variables);
  const pid_t parent = getpid();
  // The write end closes when exec() succeeds.
  int pipe_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC) != 0)
    throw SystemError("cannot start \"" + command.front() +
                      "\": " + std::strerror(errno));
  id_ = fork();
  if (id_ == 0)
  {
    exec_child(words.data(),
               environment.data(),
               output_file.c_str(),
               error_file.c_str(),
               parent);
    const int reason = errno;
    const ssize_t ignored = write(pipe_ends[1], &reason, sizeof(reason));
    _exit(ignored > 0 ? 127 : 126);
  }
  int reason = id_ < 0 ? errno : 0;
  close(pipe_ends[1]);
  if (id_ > 0)
    while (read(pipe_ends[0], &reason, sizeof(reason)) < 0 && errno == EINTR)
      ;
  close(pipe_ends[0]);
  if (reason == 0)
    return;
  if (id_ > 0)
    waitpid(id_, nullptr, 0);
  // The most likely reason is that the output file cannot be opened.
  throw SystemError("cannot start \"" + command.front() +
                    "\" with its output in \"" + output_file +
                    "\": " + std::strerror(reason));
}

ChildProcess::~ChildProcess()
{
  terminate(0.);
}

std::optional<ProcessEnd> ChildProcess::poll()
{
  int status = 0;
  if (!end_ && waitpid(id_, &status, WNOHANG) == id_)
    end_ = to_end(status);
  return end_;
}

ProcessEnd ChildProcess::wait()
{
  int status = 0;
  while (!end_)
    if (waitpid(id_, &status, 0) == id_)
      end_ = to_end(status);
  return *end_;
}

void ChildProcess::terminate(const double grace_period)
{
  if (poll())
    return;
  const double last = seconds() + grace_period;
  if (grace_period > 0.)
    signal_group(SIGTERM);
  while (!poll() && seconds() < last)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  if (poll())
    return;
  signal_group(SIGKILL);
  wait();
}

double ChildProcess::seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                       begin_)
    .count();
}

void ChildProcess::signal_group(const int signal) const
{
  // The child may not have created its process group yet.
  kill(id_, signal);
  kill(-id_, signal);
}

std::string last_line(const std::string &text)
{
  const std::string mark = "error: ";
  std::string last;
  for (const std::string &line : split(text, '\n'))
  {
    // An application's own message is more informative than mpirun's.
    if (begins_with(line, mark))
      return line.substr(mark.size());
    if (!line.empty())
      last = line;
  }
  return last;
}

ProcessText run_process(const std::vector<std::string> &command,
                        const std::string &folder)
{
  const std::string output = folder + "/output.txt";
  const std::string errors = folder + "/errors.txt";
  ProcessText text;
  text.end = ChildProcess(command, output, errors).wait();
  text.output = io::read_file(output);
  text.errors = last_line(io::read_file(errors));
  return text;
}
} // namespace contrecoup::study
