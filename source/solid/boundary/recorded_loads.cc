// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/boundary/facet_search.h>
#include <contrecoup/solid/boundary/load_alignment.h>
#include <contrecoup/solid/boundary/recorded_loads.h>

#include <deal.II/base/mpi.h>

#include <limits>
#include <tuple>

namespace contrecoup::solid
{
namespace
{
  using dealii::Point;
  using dealii::Tensor;

  /// Number of samples read at once.
  constexpr std::size_t samples_at_once = 64;

  /// Least fraction of the recorded impulse, summed as magnitudes, that must
  /// arrive on this surface.
  constexpr double least_arriving = 0.5;

  /// Least part of the same sum that the body as a whole is pushed with, for
  /// impulses to be compared by that push.
  constexpr double least_push = 0.1;

  const std::vector<std::string>
    mirrors{"none", "x", "y", "z", "x and y", "x and z", "y and z"};

  void declare_correction(ParameterHandler &prm)
  {
    declare_bool(prm,
                 "Keep impulse",
                 "true",
                 "Whether one factor on all pressures makes the impulse, "
                 "along the direction of the recorded impulse and until the "
                 "time when that is largest, equal to the recorded one. Later "
                 "impulses may cancel, as by suction or a wall behind. A body "
                 "that is pushed from opposite sides alike has no impulse to "
                 "keep, and the factor is 1.");
    declare_double(
      prm,
      "Largest correction",
      "0.1",
      0.,
      1.,
      "-",
      "The factor applies only if the impulses differ by less than this part: "
      "a larger difference, of which a WARNING tells, means different surfaces, "
      "and the factor would change peaks that are right. 0: neither.");
  }

  /// Bounding box of the points of all ranks.
  dealii::BoundingBox<3> box_of(const std::vector<Point<3>> &points,
                                const MPI_Comm communicator)
  {
    constexpr double far = std::numeric_limits<double>::max();
    Point<3> lower(far, far, far), upper(-far, -far, -far);
    for (const Point<3> &point : points)
      for (unsigned int d = 0; d < 3; ++d)
      {
        lower[d] = std::min(lower[d], point[d]);
        upper[d] = std::max(upper[d], point[d]);
      }
    for (unsigned int d = 0; d < 3; ++d)
    {
      lower[d] = dealii::Utilities::MPI::min(lower[d], communicator);
      upper[d] = dealii::Utilities::MPI::max(upper[d], communicator);
    }
    return {{lower, upper}};
  }
} // namespace


void RecordedLoads::declare_parameters(ParameterHandler &prm)
{
  declare_file(prm,
               "File",
               "",
               "loads.h5 that a blast on a rigid body recorded; empty: none.");
  const UsedWith used("Loads/Recorded/File not empty");
  declare_double(prm,
                 "Time offset",
                 "0",
                 -bounds::time,
                 bounds::time,
                 "s",
                 "Recorded time at which this run begins.");
  declare_double(prm,
                 "Averaging interval",
                 "0",
                 0.,
                 bounds::time,
                 "s",
                 "Samples are averaged over this time, which keeps "
                 "impulses; it shows the effect of sparse recording. 0, or "
                 "below the sampling interval: as recorded.");
  declare_double(
    prm,
    "Largest distance",
    "0.05",
    0.,
    bounds::length,
    "m",
    "Facets farther than this from every recorded facet are not loaded.");
  declare_selection(prm,
                    "Mirror",
                    "none",
                    mirrors,
                    "Directions normal to the symmetry planes through 0, on "
                    "one side of which loads were recorded.");
  declare_double(prm,
                 "Largest misfit",
                 "0.2",
                 0.,
                 1e6,
                 "-",
                 "Loads are refused when the mean distance of the recorded "
                 "facets from the surface of the body to mesh, in facet "
                 "edges, exceeds this value: they belong to another body or "
                 "place. A man at the recorded place has 0; turned by 180 "
                 "degrees, 0.3 for facets 34 mm wide and 0.6 for 17 mm.");
  declare_correction(prm);
}


std::shared_ptr<RecordedLoads>
RecordedLoads::parse_parameters(ParameterHandler &prm)
{
  if (prm.get("File").empty())
    return nullptr;
  auto loads = std::make_shared<RecordedLoads>();
  loads->reader_ = std::make_unique<io::LoadReader>(
    prm.get("File"), read_double(prm, "Averaging interval"));
  if (loads->reader_->n_facets() == 0 || loads->reader_->times().empty())
    throw InputError("Loads/Recorded/File = \"" + prm.get("File") +
                     "\" has no facets or no times");
  loads->offset_ = read_double(prm, "Time offset");
  if (loads->offset_ >= loads->reader_->times().back())
    throw InputError("Loads/Recorded/Time offset = " + brief(loads->offset_) +
                     " s: the record ends at " +
                     brief(loads->reader_->times().back()) +
                     " s, before this run begins");
  loads->largest_distance_ = read_double(prm, "Largest distance");
  const std::string mirror = prm.get("Mirror");
  if (mirror != "none")
    for (unsigned int d = 0; d < 3; ++d)
      loads->mirrored_[d] = mirror.find("xyz"[d]) != std::string::npos;
  loads->keeps_impulse_ = prm.get_bool("Keep impulse");
  loads->largest_correction_ = read_double(prm, "Largest correction");
  return loads;
}


void RecordedLoads::reinit(const std::vector<Point<3>> &middles,
                           const std::vector<Tensor<1, 3>> &areas,
                           const MPI_Comm communicator)
{
  communicator_ = communicator;
  middles_ = middles;
  areas_ = areas;
  require_mirror(*reader_, mirrored_, box_of(middles, communicator));
  const io::LoadFile::Facets &facets = reader_->facets();
  const FacetSearch search(facets, largest_distance_);
  Tensor<1, 3> side;
  for (std::size_t i = 0; i < reader_->n_facets(); ++i)
    side += Tensor<1, 3>(io::LoadFile::point_at(facets.centroids, i));
  source_.assign(middles.size(), no_index);
  distances_.assign(middles.size(), 0.);
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    Point<3> place = middles[i];
    Tensor<1, 3> area = areas[i];
    for (unsigned int d = 0; d < 3; ++d)
      if (mirrored_[d] && place[d] * side[d] < 0.)
      {
        place[d] *= -1.;
        area[d] *= -1.;
      }
    source_[i] = static_cast<std::uint32_t>(search.find(place, area));
    distances_[i] =
      place.distance(io::LoadFile::point_at(facets.centroids, source_[i]));
    if (distances_[i] > largest_distance_)
      source_[i] = no_index;
  }
  first_ = count_ = 0;
  measure_impulses();
}


void RecordedLoads::set_time(const double time)
{
  const std::vector<double> &ends = reader_->times();
  const double now = time + offset_;
  const auto middle = [&](const std::size_t i) {
    return i == 0 ? 0.5 * ends[0] : 0.5 * (ends[i - 1] + ends[i]);
  };
  // The load is zero before the first and after the last sample.
  is_loaded_ = now <= ends.back() ? 1. : 0.;
  if (is_loaded_ == 0.)
    return;
  after_ = std::upper_bound(ends.begin(), ends.end() - 1, now) - ends.begin();
  if (after_ + 1 < ends.size() && middle(after_) <= now)
    ++after_;
  before_ = after_ == 0 ? 0 : after_ - 1;
  const double begin = after_ == 0 ? 0. : middle(before_);
  // The last sample holds from its middle to its end.
  weight_ = std::min(1., (now - begin) / (middle(after_) - begin));
  if (before_ < first_ || after_ >= first_ + count_)
  {
    first_ = before_;
    count_ = std::min(samples_at_once, ends.size() - first_);
    samples_ = reader_->read(first_, count_);
  }
}


double RecordedLoads::pressure(const std::size_t facet) const
{
  if (is_loaded_ == 0. || source_[facet] == no_index)
    return 0.;
  const float *row = &samples_[source_[facet] * count_];
  const double now = row[after_ - first_];
  const double old = after_ == 0 ? 0. : double(row[before_ - first_]);
  return factor_ * ((1. - weight_) * old + weight_ * now);
}


std::string RecordedLoads::warning(const double end_time) const
{
  // The last samples of a record that ends with the run may miss its end.
  constexpr double missing_intervals = 2.;
  const std::vector<double> &ends = reader_->times();
  const std::size_t last = ends.size() - 1;
  const double interval = last > 0 ? ends[last] - ends[last - 1] : 0.;
  const double end = ends[last] - offset_;
  if (end + missing_intervals * interval >= end_time * (1. - 1e-6))
    return "";
  const std::vector<float> samples = reader_->read(last, 1);
  std::pair<double, std::size_t> largest{0., 0};
  for (std::size_t i = 0; i < source_.size(); ++i)
    if (source_[i] != no_index)
      largest = std::max(largest, {std::abs(factor_ * samples[source_[i]]), i});
  const double left = dealii::Utilities::MPI::max(largest.first, communicator_);
  // The first rank with this pressure tells its place and sign.
  const unsigned int mine =
    dealii::Utilities::MPI::this_mpi_process(communicator_);
  const unsigned int first = dealii::Utilities::MPI::min(
    largest.first == left ? mine : std::numeric_limits<unsigned int>::max(),
    communicator_);
  std::array<double, 4> told{};
  if (mine == first && !source_.empty())
    told = {{middles_[largest.second][0],
             middles_[largest.second][1],
             middles_[largest.second][2],
             left > 0. ? factor_ * samples[source_[largest.second]] : 0.}};
  MPI_Bcast(told.data(), 4, MPI_DOUBLE, static_cast<int>(first), communicator_);
  return "Loads/Recorded: the record ends at " + brief(end) +
         " s, the run at " + brief(end_time) +
         " s; the body bears no load in between, although " + brief(told[3]) +
         " Pa are left at (" +
         coordinates(dealii::Point<3>(told[0], told[1], told[2]), 3) +
         ") m; record longer, or end the run with the record (Time/End time)";
}


void RecordedLoads::measure_impulses()
{
  const std::vector<double> &ends = reader_->times();
  const std::vector<Tensor<1, 3>> recorded_areas = this->recorded_areas();
  std::vector<Tensor<1, 3>> mapped_areas(reader_->n_facets());
  for (std::size_t i = 0; i < source_.size(); ++i)
    if (source_[i] != no_index)
      mapped_areas[source_[i]] += areas_[i];
  std::vector<double> impulse(reader_->n_facets(), 0.); // per area
  // Impulses of each sample, on the recorded surface and on that of this rank.
  std::vector<Tensor<1, 3>> recorded(ends.size()), mapped(ends.size());
  for (std::size_t first = 0; first < ends.size(); first += samples_at_once)
  {
    const std::size_t count = std::min(samples_at_once, ends.size() - first);
    const std::vector<float> samples = reader_->read(first, count);
    for (std::size_t i = 0; i < impulse.size(); ++i)
      for (std::size_t t = 0; t < count; ++t)
      {
        const std::size_t sample = first + t;
        const double part =
          (ends[sample] - (sample == 0 ? 0. : ends[sample - 1])) *
          double(samples[i * count + t]);
        impulse[i] += part;
        recorded[sample] -= part * recorded_areas[i];
        mapped[sample] -= part * mapped_areas[i];
      }
  }
  const auto magnitudes = require_arrival(impulse);
  sum_impulses(recorded, mapped);
  pushes_left_.reset();
  if (largest_recorded_impulse_ < least_push * magnitudes.first)
  {
    pushes_left_ = {largest_recorded_impulse_, largest_mapped_impulse_};
    std::tie(largest_recorded_impulse_, largest_mapped_impulse_) = magnitudes;
  }
  choose_factor();
}


void RecordedLoads::choose_factor()
{
  const double ratio =
    largest_mapped_impulse_ / std::max(largest_recorded_impulse_, 1e-300);
  const bool is_near = std::abs(ratio - 1.) < largest_correction_;
  const bool is_warned = !is_near && largest_correction_ > 0.;
  factor_ = keeps_impulse_ && is_near && !pushes_left_ ? 1. / ratio : 1.;
  log_line((is_warned ? "WARNING: " : "") +
           std::string("Loads/Recorded: the loads on this body have ") +
           brief(ratio) +
           (pushes_left_ ? " times the recorded impulses, of all facets as "
                           "magnitudes, since pushes from opposite sides "
                           "cancel; when most is left of the recorded ones, " +
                             brief(pushes_left_->first, 3) +
                             " N s, the elements received " +
                             brief(pushes_left_->second, 3) + " N s"
                         : " times the recorded impulse at its largest") +
           "; pressures are " +
           (factor_ == 1. ? "as recorded"
                          : "multiplied by " + brief(factor_) +
                              ", which makes the impulses equal") +
           (is_warned ? "; smaller cells of the blast at the skin bring the "
                        "surfaces together"
                      : ""));
}


std::vector<Tensor<1, 3>> RecordedLoads::recorded_areas() const
{
  const io::LoadFile::Facets &facets = reader_->facets();
  std::vector<Tensor<1, 3>> areas;
  for (std::size_t i = 0; i < reader_->n_facets(); ++i)
  {
    areas.push_back(facets.areas[i] *
                    Tensor<1, 3>(io::LoadFile::point_at(facets.normals, i)));
    for (unsigned int d = 0; d < 3; ++d)
      if (mirrored_[d])
      {
        areas.back() *= 2.;
        areas.back()[d] = 0.;
      }
  }
  return areas;
}


void RecordedLoads::sum_impulses(const std::vector<Tensor<1, 3>> &recorded,
                                 const std::vector<Tensor<1, 3>> &mapped)
{
  recorded_impulse_ = mapped_impulse_ = Tensor<1, 3>();
  Tensor<1, 3> largest, on_elements;
  for (std::size_t t = 0; t < recorded.size(); ++t)
  {
    recorded_impulse_ += recorded[t];
    mapped_impulse_ += mapped[t];
    if (recorded_impulse_.norm_square() > largest.norm_square())
    {
      largest = recorded_impulse_;
      on_elements = mapped_impulse_;
    }
  }
  largest_recorded_impulse_ = largest.norm();
  largest_mapped_impulse_ = dealii::Utilities::MPI::sum(
    on_elements * largest / std::max(largest_recorded_impulse_, 1e-300),
    communicator_);
  mapped_impulse_ = dealii::Utilities::MPI::sum(mapped_impulse_, communicator_);
}


std::pair<double, double>
RecordedLoads::require_arrival(const std::vector<double> &impulse) const
{
  const io::LoadFile::Facets &facets = reader_->facets();
  double recorded = 0., arriving = 0.; // sums of magnitudes
  for (std::size_t i = 0; i < impulse.size(); ++i)
    recorded += std::abs(impulse[i]) * facets.areas[i];
  for (unsigned int d = 0; d < 3; ++d)
    if (mirrored_[d])
      recorded *= 2.;
  for (std::size_t i = 0; i < source_.size(); ++i)
    if (source_[i] != no_index)
    {
      // Voxel stairs overestimate areas, but not their projections.
      const Tensor<1, 3> normal =
        io::LoadFile::point_at(facets.normals, source_[i]);
      double projection = 0.;
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double component = areas_[i][d] * normal[d];
        projection += mirrored_[d] ? std::abs(component) : component;
      }
      arriving += std::abs(impulse[source_[i]]) * std::max(0., projection);
    }
  arriving = dealii::Utilities::MPI::sum(arriving, communicator_);
  if (arriving < least_arriving * recorded)
    throw InputError(
      "Loads/Recorded/File: " + brief(100. * arriving / recorded, 2) +
      " % of the recorded impulse arrives on this body, less than " +
      brief(100. * least_arriving) +
      " %; it must be in the place of the recorded one (Body/Shift and "
      "Rotation, or the mesh's file), and Loads/Recorded/Mirror and Largest "
      "distance, now " +
      brief(largest_distance_) + " m, must reach all facets");
  return {recorded, arriving};
}


std::vector<NamedValue> RecordedLoads::check_values() const
{
  double largest = 0., unmatched = 0., distance = 0.;
  for (std::size_t i = 0; i < source_.size(); ++i)
  {
    largest = std::max(largest, distances_[i]);
    distance += distances_[i];
    unmatched += source_[i] == no_index ? 1. : 0.;
  }
  std::vector<double> sums{distance, unmatched, double(source_.size())};
  dealii::Utilities::MPI::sum(sums, communicator_, sums);
  largest = dealii::Utilities::MPI::max(largest, communicator_);
  std::vector<NamedValue> values{
    {"loads_unmatched_facets", "-", sums[1]},
    {"loads_largest_distance", "m", largest},
    {"loads_mean_distance", "m", sums[0] / std::max(1., sums[2])},
    {"loads_impulse_factor", "-", factor_},
    {"loads_largest_recorded_impulse", "N s", largest_recorded_impulse_},
    {"loads_largest_mapped_impulse", "N s", factor_ * largest_mapped_impulse_}};
  if (pushes_left_)
    values.insert(values.end(),
                  {{"loads_pushes_cancel", "-", 1.},
                   {"loads_largest_recorded_push", "N s", pushes_left_->first},
                   {"loads_largest_mapped_push", "N s", pushes_left_->second}});
  for (unsigned int d = 0; d < 3; ++d)
  {
    const std::string axis(1, "xyz"[d]);
    values.push_back(
      {"loads_recorded_impulse_" + axis, "N s", recorded_impulse_[d]});
    values.push_back(
      {"loads_mapped_impulse_" + axis, "N s", factor_ * mapped_impulse_[d]});
  }
  return values;
}
} // namespace contrecoup::solid
