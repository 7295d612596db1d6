// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/log.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/base/version.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/conditions/profile_file.h>
#include <contrecoup/gas/hand_over/profile_extraction.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/run/gas_simulation.h>

namespace contrecoup::gas
{
namespace
{
  /// Names of the maps that a profile has, with the numbers of a record.
  using Record = BlastRecord<double>;
  const std::vector<std::pair<std::string, double Record::*>> record_maps = {
    {"peak_overpressure", &Record::peak},
    {"arrival", &Record::arrival},
    {"running_impulse", &Record::running},
    {"impulse", &Record::impulse},
    {"end", &Record::end}};

  /// The record of the profile's maps at a place, if it has one.
  template <int dim>
  std::optional<Record> record_at(const ProfileField<dim> &profile,
                                  const dealii::Point<dim> &place)
  {
    const auto here = profile.window(place, {});
    if (profile.profile().data().maps.count(record_maps[0].first) == 0 ||
        profile.is_beyond(here))
      return {};
    Record record;
    for (const auto &[name, number] : record_maps)
      record.*number = profile.profile().map_value(name, here.place, 0.);
    return record;
  }
} // namespace


template <int dim>
void GasSimulation<dim>::parse_profile_file(ParameterHandler &prm)
{
  {
    const Section section(prm, "Output");
    profile_file_ = prm.get("Profile file");
  }
  const Section section(prm, "Material");
  material_words_ = prm.get("Equation of state");
  if (material_.has_products())
    material_words_ += ", " + prm.get("Explosive");
  if (!profile_file_.empty() &&
      (dim == 3 || coarse_mesh_.geometry() == Geometry::plane ||
       !body_.empty()))
    throw InputError("Output/Profile file: only domains with spherical, "
                     "cylindrical or axisymmetric geometry and no rigid body "
                     "have a profile");
}


template <int dim>
void GasSimulation<dim>::start_from(std::shared_ptr<const Profile> profile,
                                    const dealii::Point<dim> &centre)
{
  initial_state_.set_profile(std::move(profile), centre);
  setup();
}


template <int dim>
std::vector<std::string>
GasSimulation<dim>::mapping_report(const ProfileMapping &mapping) const
{
  const auto &data = initial_state_.profile()->profile().data();
  std::vector<std::string> lines = {"profile of time " + brief(data.time, 6) +
                                    " s mapped:"};
  if (!data.material.empty() && data.material != material_words_)
    lines.push_back("  WARNING: it was made with material \"" + data.material +
                    "\", this one is \"" + material_words_ + "\"");
  lines.push_back(to_text(mapping, material_.has_products()));
  return lines;
}


template <int dim>
void GasSimulation<dim>::go_on_burning()
{
  const ProfileField<dim> &profile = *initial_state_.profile();
  const auto part = profile.part_within(coarse_mesh_.lower_corner(),
                                        coarse_mesh_.upper_corner());
  const auto &data = profile.profile().data();
  afterburn_.go_on_from(data.afterburn_fraction,
                        part.value_or(1.) * data.afterburn_released);
}


template <int dim>
void GasSimulation<dim>::go_on_mapping()
{
  const ProfileField<dim> &profile = *initial_state_.profile();
  gauges_.set_records(
    [&](const dealii::Point<dim> &place) { return record_at(profile, place); });
  for (unsigned int leaf = 0; !maps_.empty() && leaf < mesh_.n_owned(); ++leaf)
  {
    const LeafBox<dim> box = leaf_box(mesh_, leaf);
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      const auto index = points_.indices(q);
      dealii::Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = points_.position(index[d]);
      const auto known = record_at(profile, box.place(x));
      if (!known)
        continue;
      typename BlastMaps<dim>::Record record;
      record.peak = known->peak;
      record.arrival = known->arrival;
      record.running = known->running;
      record.impulse = known->impulse;
      record.end = known->end;
      maps_.set_record(leaf, q, record);
    }
  }
}


template <int dim>
GasState<dim> GasSimulation<dim>::ambient() const
{
  return initial_state_.ambient(coarse_mesh_.upper_corner());
}


template <int dim>
ProfileData GasSimulation<dim>::profile() const
{
  if (is_burning())
    throw InputError("The profile cannot be made before all explosive has "
                     "burned; end the run, or hand over, later");
  ProfileData data =
    extract_profile(mesh_, points_, field_, material_, ambient());
  data.time = time_;
  data.material = material_words_;
  data.afterburn_fraction = afterburn_.fraction();
  data.afterburn_released = afterburn_.released();
  // Meshes of 1 dimension are uniform: their cells are those of the profile.
  const std::size_t n = data.values[0].size();
  if (dim == 1 && !maps_.empty())
    for (const auto &[name, number] : record_maps)
    {
      auto &map = data.maps[name];
      for (std::size_t cell = 0; cell < n; ++cell)
      {
        const auto record = maps_.record(cell / layout_.n, cell % layout_.n);
        Record exact{record.peak,
                     record.arrival,
                     record.running,
                     record.impulse,
                     record.end};
        map.push_back(exact.*number);
      }
    }
  data.version = version() + " (" + git_revision() + ")";
  return data;
}


template <int dim>
std::pair<dealii::Point<dim>, dealii::Point<dim>>
GasSimulation<dim>::disturbed_box() const
{
  return gas::disturbed_box(
    mesh_, points_, field_, conserved_state(ambient(), material_, dim + 3));
}


template <int dim>
dealii::Tensor<1, dim> GasSimulation<dim>::smallest_cell() const
{
  dealii::Tensor<1, dim> result =
    coarse_mesh_.upper_corner() - coarse_mesh_.lower_corner();
  const unsigned int level = adaptation_parameters_.active
                               ? adaptation_parameters_.most_level
                               : coarse_mesh_.initial_refinement();
  for (unsigned int d = 0; d < dim; ++d)
    result[d] /= coarse_mesh_.coarse_cells(d) * std::pow(2., level) * layout_.n;
  return result;
}


template <int dim>
void GasSimulation<dim>::finish(const std::string &folder)
{
  loads_.finish();
  if (profile_file_.empty())
    return;
  const ProfileData data = profile();
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    write_profile(folder + "/" + profile_file_, data);
  log_line("profile written: " + profile_file_);
}


#define CONTRECOUP_INSTANTIATE(dim)                                            \
  template void GasSimulation<dim>::parse_profile_file(ParameterHandler &);    \
  template void GasSimulation<dim>::start_from(std::shared_ptr<const Profile>, \
                                               const dealii::Point<dim> &);    \
  template std::vector<std::string> GasSimulation<dim>::mapping_report(        \
    const ProfileMapping &) const;                                             \
  template void GasSimulation<dim>::go_on_burning();                           \
  template void GasSimulation<dim>::go_on_mapping();                           \
  template GasState<dim> GasSimulation<dim>::ambient() const;                  \
  template ProfileData GasSimulation<dim>::profile() const;                    \
  template std::pair<dealii::Point<dim>, dealii::Point<dim>>                   \
  GasSimulation<dim>::disturbed_box() const;                                   \
  template dealii::Tensor<1, dim> GasSimulation<dim>::smallest_cell() const;   \
  template void GasSimulation<dim>::finish(const std::string &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
