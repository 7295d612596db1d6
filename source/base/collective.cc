// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/collective.h>
#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/gather.h>
#include <contrecoup/base/signals.h>
#include <contrecoup/base/text.h>

#include <deal.II/base/exceptions.h>

#include <chrono>
#include <iostream>
#include <new>
#include <sstream>
#include <thread>

namespace contrecoup
{
namespace
{
  constexpr int first_stop = 128;

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

Collective::Collective(const MPI_Comm communicator, const double patience)
  : communicator_(communicator)
  , patience_(patience)
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
  return agree(own, flags);
}

unsigned int Collective::agree(const Failure &own, const unsigned int flags)
{
  if (n_ranks_ == 1)
  {
    if (own.code != ExitCode::done)
      throw_failure(own);
    return flags;
  }

  // The largest code wins, among equal ones the lowest rank.
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
    using Clock = std::chrono::steady_clock;
    const auto give_up =
      Clock::now() + std::chrono::duration<double>(patience_);
    int finished = 0;
    MPI_Test(&request, &finished, MPI_STATUS_IGNORE);
    while (finished == 0)
    {
      if (Clock::now() > give_up)
      {
        std::cerr << "error: " << own.message << std::endl;
        MPI_Abort(MPI_COMM_WORLD, code);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
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
} // namespace contrecoup
