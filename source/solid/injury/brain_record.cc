// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/injury/brain_record.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::solid
{
void BrainRecord::save(io::StateWriter &out) const
{
  out.put_list(std::vector<double>{double(n_steps),
                                   last_time,
                                   sums.cavitation_dose,
                                   sums.fluctuation_square,
                                   sums.average_square});
  out.put_list(samples);
  out.put_list(motion.times);
  out.put_list(motion.velocities);
  out.put_list(motion.angular_velocities);
}


void BrainRecord::restore(io::StateReader &in, const MPI_Comm communicator)
{
  std::vector<double> numbers;
  std::vector<BrainSample> saved;
  in.take_list(numbers);
  in.take_list(saved);
  in.take_list(motion.times);
  in.take_list(motion.velocities);
  in.take_list(motion.angular_velocities);
  if (numbers.size() != 5 || motion.times.size() != motion.velocities.size() ||
      motion.times.size() != motion.angular_velocities.size())
    in.refuse();
  n_steps = static_cast<std::uint64_t>(numbers[0]);
  last_time = numbers[1];
  // Rank r continues the sums of the saved rank r. A restart on as many ranks
  // thus adds in the same order.
  if (in.rank() % dealii::Utilities::MPI::n_mpi_processes(communicator) ==
      dealii::Utilities::MPI::this_mpi_process(communicator))
  {
    sums.cavitation_dose += numbers[2];
    sums.fluctuation_square += numbers[3];
    sums.average_square += numbers[4];
  }
  const io::NumberIndex here = io::index_by_number(
    samples.size(), [&](const std::size_t i) { return samples[i].cell; });
  for (const BrainSample &sample : saved)
    if (const auto found = here.find(sample.cell); found != here.end())
      samples[found->second] = sample;
}
} // namespace contrecoup::solid
