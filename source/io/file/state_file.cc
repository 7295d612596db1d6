// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/state_file.h>

#include <filesystem>

namespace contrecoup::io
{
namespace
{
  std::string file_of(const std::string &folder,
                      const std::string &name,
                      const unsigned int rank)
  {
    return folder + "/" + name + "." + std::to_string(rank) + ".bin";
  }
} // namespace


StateReader::StateReader(const std::string &file, const unsigned int rank)
  : file_(file)
  , rank_(rank)
  , in_(file, std::ios::binary)
{
  std::error_code problem;
  left_ = std::filesystem::file_size(file, problem);
  if (problem || !in_)
    throw InputError("Checkpoint file " + file + " is missing");
}


void StateReader::refuse() const
{
  throw InputError("Checkpoint file " + file_ + " belongs to another scene");
}


void StateReader::take_bytes(void *const to, const std::size_t n)
{
  if (n > left_ ||
      !in_.read(static_cast<char *>(to), static_cast<std::streamsize>(n)))
    throw InputError("Checkpoint file " + file_ + " ends too early");
  left_ -= n;
}


std::uint64_t StateReader::take_size(const std::size_t bytes)
{
  std::uint64_t size = 0;
  take(size);
  if (size > left_ / bytes)
    throw InputError("Checkpoint file " + file_ + " ends too early");
  return size;
}


void save_state(const std::string &file,
                const std::function<void(StateWriter &)> &write)
{
  write_file(file, [&](std::ostream &out) {
    StateWriter writer(out);
    write(writer);
  });
}


void save_part(const std::string &folder,
               const std::string &name,
               const MPI_Comm communicator,
               const std::function<void(StateWriter &)> &write)
{
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(communicator);
  save_state(file_of(folder, name, rank), write);
}


void restore_parts(const std::string &folder,
                   const std::string &name,
                   const std::function<void(StateReader &)> &read)
{
  unsigned int rank = 0;
  do
  {
    StateReader reader(file_of(folder, name, rank), rank);
    read(reader);
  } while (std::filesystem::exists(file_of(folder, name, ++rank)));
}
} // namespace contrecoup::io
