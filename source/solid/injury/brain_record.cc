// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/binary_records.h>
#include <contrecoup/solid/injury/brain_record.h>

#include <deal.II/base/mpi.h>

#include <unordered_map>

namespace contrecoup::solid
{
void BrainRecord::save(std::ostream &out) const
{
  io::put_list(out,
               std::vector<double>{double(n_steps),
                                   last_time,
                                   sums.cavitation_dose,
                                   sums.fluctuation_square,
                                   sums.average_square});
  io::put_list(out, samples);
  io::put_list(out, motion.times);
  io::put_list(out, motion.velocities);
  io::put_list(out, motion.angular_velocities);
}


void BrainRecord::restore(std::istream &in,
                          const std::string &file,
                          const unsigned int rank,
                          const MPI_Comm communicator)
{
  std::vector<double> numbers;
  std::vector<BrainSample> saved;
  io::take_list(in, file, numbers);
  io::take_list(in, file, saved);
  io::take_list(in, file, motion.times);
  io::take_list(in, file, motion.velocities);
  io::take_list(in, file, motion.angular_velocities);
  if (numbers.size() != 5 || motion.times.size() != motion.velocities.size() ||
      motion.times.size() != motion.angular_velocities.size())
    throw InputError("Checkpoint file " + file + " belongs to another scene");
  n_steps = static_cast<std::uint64_t>(numbers[0]);
  last_time = numbers[1];
  // Rank r continues the sums of the saved rank r. A restart on as many ranks
  // thus adds in the same order.
  if (rank % dealii::Utilities::MPI::n_mpi_processes(communicator) ==
      dealii::Utilities::MPI::this_mpi_process(communicator))
  {
    sums.cavitation_dose += numbers[2];
    sums.fluctuation_square += numbers[3];
    sums.average_square += numbers[4];
  }
  std::unordered_map<std::uint32_t, std::size_t> here;
  for (std::size_t i = 0; i < samples.size(); ++i)
    here[samples[i].cell] = i;
  for (const BrainSample &sample : saved)
    if (here.count(sample.cell) > 0)
      samples[here[sample.cell]] = sample;
}
} // namespace contrecoup::solid
