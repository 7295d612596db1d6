// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/region_extremes.h>
#include <contrecoup/base/system/exceptions.h>

namespace contrecoup::ale
{
namespace
{
  namespace mpi = dealii::Utilities::MPI;
} // namespace


void ExtremeRecord::reinit(const std::size_t n_regions,
                           const MPI_Comm communicator)
{
  communicator_ = communicator;
  is_empty_ = true;
  extremes_.assign(n_regions, RegionExtremes());
  least_pressures_.assign(n_regions, 0.);
  is_last_.assign(n_regions, 0);
}


void ExtremeRecord::add(std::vector<RegionExtremes> own)
{
  // Extremes of all ranks can wait for the row, sums cannot.
  std::vector<double> voids;
  for (const RegionExtremes &one : own)
    voids.push_back(one.void_volume);
  mpi::sum(voids, communicator_, voids);
  for (std::size_t i = 0; i < extremes_.size(); ++i)
  {
    own[i].void_volume = voids[i];
    extremes_[i].include(own[i]);
  }
  is_empty_ = false;
}


std::vector<RegionExtremes> ExtremeRecord::take()
{
  std::vector<RegionExtremes> result;
  for (std::size_t i = 0; i < extremes_.size(); ++i)
  {
    const RegionExtremes &own = extremes_[i];
    std::vector<double> largest{
      -own.least_pressure, own.largest_pressure, own.shear_strain, own.speed};
    mpi::max(largest, communicator_, largest);
    result.push_back(
      {-largest[0], largest[1], largest[2], largest[3], own.void_volume});
    least_pressures_[i] =
      std::min(least_pressures_[i], result.back().least_pressure);
    is_last_[i] = least_pressures_[i] < 0. &&
                  least_pressures_[i] == result.back().least_pressure;
  }
  is_empty_ = true;
  extremes_.assign(extremes_.size(), RegionExtremes());
  return result;
}


void ExtremeRecord::save(io::StateWriter &out) const
{
  out.put(is_empty_);
  out.put_list(extremes_);
  out.put_list(least_pressures_);
}


void ExtremeRecord::restore(io::StateReader &in)
{
  bool is_empty = true;
  std::vector<RegionExtremes> extremes;
  std::vector<double> least_pressures;
  in.take(is_empty);
  in.take_list(extremes);
  in.take_list(least_pressures);
  if (extremes.size() != extremes_.size() ||
      least_pressures.size() != extremes_.size())
    in.refuse();
  is_empty_ = is_empty;
  least_pressures_ = least_pressures;
  for (std::size_t i = 0; i < extremes.size(); ++i)
    extremes_[i].include(extremes[i]);
}
} // namespace contrecoup::ale
