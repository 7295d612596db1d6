// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>

#include <deal.II/base/exceptions.h>

#include <chrono>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <thread>

namespace contrecoup
{
namespace
{
  constexpr int first_stop = 128;

  using Clock = std::chrono::steady_clock;

  Clock::time_point seconds_from_now(const double seconds)
  {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(seconds));
  }

  void sleep_a_little()
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  constexpr int failure_tag = 1; ///< tag of messages from failed ranks

  /// Rank of a message from a failed rank, if there is one.
  std::optional<int> sender_of_failure(const MPI_Comm communicator)
  {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, failure_tag, communicator, &there, &status);
    if (there == 0)
      return std::nullopt;
    MPI_Recv(nullptr,
             0,
             MPI_INT,
             status.MPI_SOURCE,
             failure_tag,
             communicator,
             MPI_STATUS_IGNORE);
    return status.MPI_SOURCE;
  }

  /// Whether another failed rank reports the error: one that announced it
  /// earlier, or a lower rank at the same time.
  bool other_rank_reports(const MPI_Comm communicator,
                          const int rank,
                          const int n_ranks)
  {
    if (sender_of_failure(communicator))
      return true;
    for (int other = 0; other < n_ranks; ++other)
      if (other != rank)
      {
        MPI_Request request;
        MPI_Isend(
          nullptr, 0, MPI_INT, other, failure_tag, communicator, &request);
        MPI_Request_free(&request);
      }
    constexpr double delay = 0.5; // upper bound of message latency [s]
    for (const auto end = seconds_from_now(delay); Clock::now() < end;)
    {
      if (const auto other = sender_of_failure(communicator); !other)
        sleep_a_little();
      else if (*other < rank)
        return true;
    }
    return false;
  }

  std::string deal_ii_message(const dealii::ExceptionBase &exception)
  {
    std::ostringstream information;
    exception.print_info(information);
    const std::string name = exception.get_exc_name();
    return one_line("deal.II says: " + information.str() +
                    (name.empty() ? "" : " (" + name + ")"));
  }
} // namespace

bool is_stop(const Failure &failure)
{
  return static_cast<int>(failure.code) > first_stop;
}

Failure to_failure(const std::exception_ptr &exception,
                   const ExitCode otherwise)
{
  try
  {
    std::rethrow_exception(exception);
  }
  catch (const InputError &error)
  {
    return {ExitCode::bad_input, one_line(error.what())};
  }
  catch (const NumericsError &error)
  {
    return {ExitCode::numerics_failed, one_line(error.what())};
  }
  catch (const SystemError &error)
  {
    return {ExitCode::system_failed, one_line(error.what())};
  }
  catch (const Stopped &stop)
  {
    return {static_cast<ExitCode>(first_stop + stop.signal()), stop.what()};
  }
  catch (const std::bad_alloc &)
  {
    return {ExitCode::system_failed, "out of memory"};
  }
  catch (const dealii::StandardExceptions::ExcIO &error)
  {
    return {otherwise == ExitCode::bad_input ? otherwise
                                             : ExitCode::system_failed,
            deal_ii_message(error)};
  }
  catch (const dealii::ExceptionBase &error)
  {
    return {otherwise, deal_ii_message(error)};
  }
  catch (const std::exception &error)
  {
    return {otherwise, one_line(error.what())};
  }
  catch (...)
  {
    return {otherwise, "an unknown exception"};
  }
}

void throw_failure(const Failure &failure)
{
  if (is_stop(failure))
    throw Stopped(static_cast<int>(failure.code) - first_stop);
  if (failure.code == ExitCode::bad_input)
    throw InputError(failure.message);
  if (failure.code == ExitCode::numerics_failed)
    throw NumericsError(failure.message);
  throw SystemError(failure.message);
}

Collective::Collective(const MPI_Comm communicator, const double timeout)
  : communicator_(communicator)
  , timeout_(timeout)
{
  MPI_Comm_dup(communicator, &agreement_);
  MPI_Comm_rank(agreement_, &rank_);
  MPI_Comm_size(agreement_, &n_ranks_);
}

Collective::~Collective()
{
  MPI_Comm_free(&agreement_);
}

MPI_Comm Collective::communicator() const
{
  return communicator_;
}

void Collective::run(const std::function<void()> &function,
                     const ExitCode otherwise)
{
  run_with_flags(
    [&]() {
      function();
      return 0u;
    },
    otherwise);
}

unsigned int
Collective::run_with_flags(const std::function<unsigned int()> &function,
                           const ExitCode otherwise)
{
  Failure own;
  unsigned int flags = 0;
  try
  {
    flags = function();
  }
  catch (...)
  {
    own = to_failure(std::current_exception(), otherwise);
  }
  return combine_failures(own, flags);
}

unsigned int Collective::combine_failures(const Failure &own,
                                          const unsigned int flags)
{
  if (n_ranks_ == 1)
  {
    if (own.code != ExitCode::done)
      throw_failure(own);
    return flags;
  }

  // The largest code wins; among equal codes the lowest rank.
  constexpr int n_flags = 8;
  const int code = static_cast<int>(own.code);
  int send[1 + n_flags] = {code == 0 ? 0
                                     : code * n_ranks_ + n_ranks_ - 1 - rank_};
  for (int i = 0; i < n_flags; ++i)
    send[1 + i] = static_cast<int>((flags >> i) & 1u);
  int received[1 + n_flags];
  MPI_Request request;
  MPI_Iallreduce(
    send, received, 1 + n_flags, MPI_INT, MPI_MAX, agreement_, &request);
  if (code == 0)
    MPI_Wait(&request, MPI_STATUS_IGNORE);
  else
  {
    const auto deadline = seconds_from_now(timeout_);
    int finished = 0;
    MPI_Test(&request, &finished, MPI_STATUS_IGNORE);
    while (finished == 0)
    {
      if (Clock::now() > deadline)
        abort_all(own);
      sleep_a_little();
      MPI_Test(&request, &finished, MPI_STATUS_IGNORE);
    }
  }

  if (received[0] != 0)
  {
    const int root = n_ranks_ - 1 - received[0] % n_ranks_;
    throw_failure({static_cast<ExitCode>(received[0] / n_ranks_),
                   broadcast_text(agreement_, own.message, root)});
  }
  unsigned int all = 0;
  for (int i = 0; i < n_flags; ++i)
    all |= static_cast<unsigned int>(received[1 + i]) << i;
  return all;
}

void Collective::abort_all(const Failure &own) const
{
  if (other_rank_reports(agreement_, rank_, n_ranks_))
    // The reporting rank aborts this rank as well.
    for (const auto end = seconds_from_now(10. * timeout_); Clock::now() < end;)
      sleep_a_little();
  if (!is_stop(own))
    std::cerr << "error: " << own.message << std::endl;
  MPI_Abort(MPI_COMM_WORLD, static_cast<int>(own.code));
}
} // namespace contrecoup
