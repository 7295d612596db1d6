// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_record.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/body/tissue_measures.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  namespace mpi = dealii::Utilities::MPI;

  const std::string brain_entry = "Brain", skull_entry = "Skull";

  /// Number of the region with this name, else of the one whose layer has it;
  /// the number of regions if there is none.
  std::size_t number_of(const std::vector<Region> &regions,
                        const std::string &name)
  {
    for (const std::string Region::*text : {&Region::name, &Region::layer})
      for (std::size_t i = 0; i < regions.size(); ++i)
        if (boost::algorithm::iequals(regions[i].*text, name))
          return i;
    return regions.size();
  }

  /// @param usual name that need not exist
  unsigned int find_solid(const std::vector<Region> &regions,
                          const std::string &entry,
                          const std::string &name,
                          const std::string &usual,
                          const unsigned int none)
  {
    if (name.empty())
      return none;
    const std::size_t found = number_of(regions, name);
    if (found == regions.size())
    {
      std::vector<std::string> names;
      for (const Region &region : regions)
        names.push_back(region.name);
      if (name != usual)
        throw InputError("Injury/" + entry + ": there is no region \"" + name +
                         "\"" + suggestion(name, names));
      return none;
    }
    if (regions[found].solid() == nullptr)
      throw InputError("Injury/" + entry + ": region \"" + regions[found].name +
                       "\" is a fluid; name a solid, or leave the entry empty");
    return static_cast<unsigned int>(found);
  }
} // namespace


void HeadRecord::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Injury");
  declare_string(
    prm,
    brain_entry,
    "brain",
    selecting("Region, by name or Layer, whose strains and pressures are "
              "recorded for injury.csv. Empty: none."));
  declare_string(
    prm,
    skull_entry,
    "skull",
    selecting("Region, by name or Layer, whose mean motion is recorded for "
              "injury.csv. Empty, or none is called skull: the brain."));
  declare_selection(prm,
                    "Pressure",
                    "averaged",
                    solid::peak_pressure_names(),
                    "Pressure in the brain: of each cell or particle, or "
                    "averaged: over the corners of a cell and the brain cells "
                    "around them, or as the grid smooths that of particles. "
                    "Averaging removes checkerboard pressures, and a tenth of "
                    "waves as short as ten cells.");
  declare_integer(prm,
                  "Every steps",
                  "10",
                  1,
                  1000000,
                  "Steps between evaluations; peaks in between are missed.");
  OwnThresholds::declare_parameters(prm);
}


void HeadRecord::parse_parameters(ParameterHandler &prm)
{
  own_.parse_parameters(prm, "Injury");
  {
    const Section section(prm, "Injury");
    brain_name_ = trim(prm.get(brain_entry));
    skull_name_ = trim(prm.get(skull_entry));
    averaged_ = prm.get("Pressure") == solid::peak_pressure_names()[0];
    interval_ = read_unsigned(prm, "Every steps");
  }
  const Section section(prm, "Mesh");
  if (prm.get("Kind") == "layered head" || prm.get("Kind") == "file")
    is_mirrored_ = read_symmetry_planes(prm);
}


void HeadRecord::find(const std::vector<Region> &regions,
                      const std::vector<ContactPlane> &planes)
{
  brain_ = find_solid(regions, brain_entry, brain_name_, "brain", none);
  skull_ = find_solid(regions, skull_entry, skull_name_, "skull", none);
  if (brain_ != none)
    own_.require(injury_measures_of({"head"}), "");
  else if (skull_ != none)
    own_.require({"injury_bric", "injury_hic15"}, "there is no brain");
  else
    own_.require({}, "there is neither brain nor skull");
  liquids_.clear();
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (std::holds_alternative<Tait>(regions[i].law))
      liquids_.push_back(i);
  normal_ = planes.empty() ? dealii::Tensor<1, 3>() : planes.front().normal;
}


void HeadRecord::check_interval(const double steps) const
{
  if (active() && interval_ > steps)
    throw InputError("Injury/Every steps = " + std::to_string(interval_) +
                     " selects no step after the start: the run has about " +
                     brief(steps, 3));
}


void HeadRecord::record_brain(const double time,
                              const std::vector<double> &pressures,
                              const std::vector<double> &averages,
                              const std::vector<double> &heights,
                              std::vector<solid::BrainSample> &samples)
{
  solid::record_pressures(time - record_.last_time,
                          pressures,
                          averages,
                          averaged_,
                          samples,
                          record_.sums);
  record_.last_time = time;
  const std::vector<double> &chosen = averaged_ ? averages : pressures;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const bool is_far = heights[i] > 0.;
    Extreme &extreme = extremes_[is_far ? 1 : 0];
    if (is_far ? chosen[i] < extreme.pressure : chosen[i] > extreme.pressure)
      extreme = {chosen[i], time};
  }
}


void HeadRecord::record_motion(const double time,
                               const MPI_Comm communicator,
                               solid::MeanMotion &moving,
                               solid::MeanMotion &head)
{
  head.find(communicator, is_mirrored_);
  if (!moving.find(communicator, is_mirrored_))
    return;
  // The skull's motion at the centre of brain and skull.
  record_.motion.add(
    time, moving.velocity_at(head.centre()), moving.angular_velocity());
}


RunEnd HeadRecord::end_at(const double time,
                          const ContactRecord &contact,
                          const ExtremeRecord &extremes) const
{
  return {contact.lasts(time),
          std::any_of(
            liquids_.begin(), liquids_.end(), [&](const std::size_t region) {
              return extremes.is_least_last(region);
            })};
}


std::vector<solid::InjuryMeasure>
HeadRecord::measures(const MPI_Comm communicator, const RunEnd &end) const
{
  auto list = solid::brain_measures(
    record_.samples, record_.sums, communicator, end.tension_grows);
  if (!averaged_)
    for (solid::InjuryMeasure &measure : list)
      if (measure.value.unit == "Pa")
        measure.limits += "; of single " + object_;
  const std::string moving = skull_ == none ? "the mean motion of the brain"
                             : brain_ == none
                               ? "the mean motion of the skull"
                               : "the skull, at the centre of brain and skull";
  const bool turns =
    std::count(is_mirrored_.begin(), is_mirrored_.end(), true) < 2;
  for (const solid::InjuryMeasure &measure : solid::head_motion_measures(
         record_.motion, moving + ", until the end of the run"))
  {
    list.push_back(measure);
  }
  for (solid::InjuryMeasure &measure : list)
  {
    // A ratio, which does not grow.
    if (measure.value.name != "injury_pressure_roughness")
      measure.is_cut = measure.is_cut || end.contact_lasts;
    if (measure.value.name.rfind("injury_bric", 0) == 0 && !turns)
      measure.is_cut = false;
    if (measure.value.name == "injury_bric" && !turns)
      measure.limits = "zero, as planes of symmetry keep the head from turning";
  }
  solid::apply(own_, list);
  solid::limit_to_impact(list);
  return list;
}


std::vector<NamedValue> HeadRecord::coup(const MPI_Comm communicator,
                                         const RunEnd &end) const
{
  std::vector<NamedValue> result;
  if (brain_ == none || !(normal_.norm() > 0.))
    return result;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const std::string name = i == 0 ? "coup" : "contrecoup";
    const Extreme &mine = extremes_[i];
    const double size = mpi::max(std::abs(mine.pressure), communicator);
    const double time = mpi::min(std::abs(mine.pressure) == size
                                   ? mine.time
                                   : std::numeric_limits<double>::max(),
                                 communicator);
    result.push_back({name + "_pressure", "Pa", i == 0 ? size : -size});
    result.push_back({name + "_pressure_time", "s", time});
    const bool is_last = size > 0. && time == record_.last_time;
    if (is_last || end.contact_lasts || (i == 1 && end.tension_grows))
      result.push_back({name + "_pressure_cut_off", "-", 1.});
  }
  return result;
}


std::string HeadRecord::pressures_in_words(const bool is_smoothed) const
{
  return (averaged_ && is_smoothed ? "averaged over neighbouring "
                                   : "of single ") +
         object_ +
         (interval_ > 1 ? ", in one of " + std::to_string(interval_) + " steps"
                        : "");
}


void HeadRecord::write(const std::string &folder,
                       const MPI_Comm communicator,
                       const RunEnd &end) const
{
  if (!active())
    return;
  const auto list = measures(communicator, end);
  if (mpi::this_mpi_process(communicator) == 0)
    io::write_file(folder + "/injury.csv",
                   [&](std::ostream &out) { out << solid::to_csv(list); });
}


std::vector<NamedValue> HeadRecord::results(const MPI_Comm communicator,
                                            const RunEnd &end) const
{
  std::vector<NamedValue> values = coup(communicator, end);
  for (const NamedValue &value : solid::values_of(measures(communicator, end)))
    values.push_back(value);
  return values;
}


void HeadRecord::save_record(io::StateWriter &out) const
{
  if (!active())
    return;
  record_.save(out);
  out.put(extremes_);
}


void HeadRecord::restore_record(io::StateReader &in,
                                const MPI_Comm communicator)
{
  if (!active())
    return;
  record_.restore(in, communicator);
  auto extremes = extremes_;
  in.take(extremes);
  // Each rank keeps the extremes of all.
  for (unsigned int i = 0; i < extremes.size(); ++i)
    if (std::abs(extremes[i].pressure) > std::abs(extremes_[i].pressure))
      extremes_[i] = extremes[i];
}
} // namespace contrecoup::ale
