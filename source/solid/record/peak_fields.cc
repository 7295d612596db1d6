// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/record/peak_fields.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace contrecoup::solid
{
namespace
{
  /// The peaks of an element in a checkpoint.
  struct Record
  {
    std::uint32_t number; ///< of the cell in the whole mesh
    std::array<float, 4> peaks;
  };

  /// The share of a tissue that strain_95() leaves out.
  constexpr double tail = 0.05;

  /// Extends an extreme, and @p newest by its magnitude if it changes.
  void
  extend(const bool is_beyond, const float value, float &extreme, float &newest)
  {
    if (!is_beyond)
      return;
    extreme = value;
    newest = std::max(newest, std::abs(value));
  }

} // namespace


template <typename Real>
const std::array<std::string, PeakFields<Real>::n_fields>
  PeakFields<Real>::names{{"highest_pressure",
                           "lowest_pressure",
                           "largest_von_mises_stress",
                           "largest_principal_strain"}};


template <typename Real>
const std::array<std::string, PeakFields<Real>::n_fields>
  PeakFields<Real>::units{{"Pa", "Pa", "Pa", "-"}};


template <typename Real>
void PeakFields<Real>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Peaks");
  declare_bool(prm,
               "Active",
               "false",
               "Whether fields hold the extreme values of each element over "
               "time: highest and lowest pressure, largest von Mises stress "
               "and principal strain. The summary then has their extremes "
               "in each tissue, and the 95th percentile of strain.");
  const UsedWith used("Peaks/Active = true");
  declare_selection(prm,
                    "Pressure",
                    "averaged",
                    peak_pressure_names(),
                    "Pressure of each element, or averaged over its corners "
                    "and the elements of the same tissue around them, as in "
                    "Injury/Pressure.");
  declare_integer(prm,
                  "Every steps",
                  "10",
                  1,
                  1000000,
                  "Steps between evaluations; peaks in between are missed.");
}


template <typename Real>
void PeakFields<Real>::parse_parameters(ParameterHandler &prm,
                                        const MeshDescription & /*mesh*/)
{
  const Section section(prm, "Peaks");
  active_ = prm.get_bool("Active");
  averaged_ = prm.get("Pressure") == peak_pressure_names()[0];
  interval_ = read_unsigned(prm, "Every steps");
}


template <typename Real>
void PeakFields<Real>::reinit(const SolidBody<Real> &body)
{
  if (!active_)
    return;
  for (std::vector<float> &field : fields_)
    field.assign(body.mesh().elements.size(), 0.F);
  averages_.assign(body.mesh().tissues.size(), {});
  for (unsigned int k = 0; k < averages_.size(); ++k)
    averages_[k].reinit(body.mesh(), body.exchange(), k);
  newest_.assign(averages_.size(), {});
  straining_.assign(averages_.size(), 0.);
  n_steps_ = 0;
}


template <typename Real>
void PeakFields<Real>::record(const SolidBody<Real> &body)
{
  if (!active_ || ++n_steps_ % interval_ != 0)
    return;
  const TimerScope timer("peaks");
  std::vector<float> pressures(body.mesh().elements.size(), 0.F);
  std::vector<char> is_straining(pressures.size(), 0);
  for (unsigned int k = 0; k < averages_.size(); ++k)
  {
    std::array<float, n_fields> &newest = newest_[k];
    newest = {};
    body.elements().visit_active(
      body.nodes(),
      body.times(),
      [&](const std::uint32_t cell, const ElementValues &element) {
        pressures[cell] = static_cast<float>(pressure_of(element.stress));
        float &largest = fields_[2][cell], &strain = fields_[3][cell];
        const auto stress = static_cast<float>(von_mises(element.stress));
        extend(stress > largest, stress, largest, newest[2]);
        const auto raised =
          static_cast<float>(raised_to_principal(strain, element.strain));
        is_straining[cell] = raised > strain;
        extend(raised > strain, raised, strain, newest[3]);
      },
      k);
    const std::vector<std::uint32_t> &elements = averages_[k].elements();
    std::vector<double> values(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
      values[i] = pressures[elements[i]];
    if (averaged_)
      values = averages_[k].average(values);
    straining_[k] = 0.;
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      if (is_straining[elements[i]] != 0)
        straining_[k] += averages_[k].volumes()[i];
      const auto pressure = static_cast<float>(values[i]);
      float &highest = fields_[0][elements[i]],
            &lowest = fields_[1][elements[i]];
      extend(pressure > highest, pressure, highest, newest[0]);
      extend(pressure < lowest, pressure, lowest, newest[1]);
    }
  }
}


template <typename Real>
std::vector<NamedValue>
PeakFields<Real>::results(const SolidBody<Real> &body) const
{
  std::vector<NamedValue> list;
  for (unsigned int k = 0; k < averages_.size(); ++k)
  {
    const Tissue tissue = body.mesh().tissues[k];
    const std::vector<std::uint32_t> &elements = averages_[k].elements();
    for (unsigned int n = 0; n < n_fields; ++n)
    {
      // All fields but the lowest pressure start from zero and grow.
      const float sign = n == 1 ? -1.F : 1.F;
      std::vector<float> found{0.F, newest_[k][n]};
      for (const std::uint32_t cell : elements)
        found[0] = std::max(found[0], sign * fields_[n][cell]);
      dealii::Utilities::MPI::max(found, body.communicator(), found);
      const std::string name = tissue_column(names[n], tissue);
      list.push_back({name, units[n], sign * found[0]});
      if (found[0] > 0.F && found[1] == found[0])
        list.push_back({name + "_cut_off", "-", 1.});
    }
    const std::string name = tissue_column("principal_strain_95", tissue);
    list.push_back({name, "-", strain_95(body, k)});
    if (is_straining(body, k))
      list.push_back({name + "_cut_off", "-", 1.});
  }
  return list;
}


template <typename Real>
double PeakFields<Real>::strain_95(const SolidBody<Real> &body,
                                   const unsigned int tissue) const
{
  std::vector<double> strains;
  for (const std::uint32_t cell : averages_[tissue].elements())
    strains.push_back(fields_[3][cell]);
  return percentile(
    strains, averages_[tissue].volumes(), 1. - tail, body.communicator());
}


template <typename Real>
bool PeakFields<Real>::is_straining(const SolidBody<Real> &body,
                                    const unsigned int tissue) const
{
  const std::vector<double> &volumes = averages_[tissue].volumes();
  std::vector<double> sums{straining_[tissue],
                           std::accumulate(volumes.begin(), volumes.end(), 0.)};
  dealii::Utilities::MPI::sum(sums, body.communicator(), sums);
  return sums[0] > tail * sums[1];
}


template <typename Real>
StrainedTissue
PeakFields<Real>::most_strained(const SolidBody<Real> &body) const
{
  StrainedTissue most;
  for (unsigned int k = 0; k < averages_.size(); ++k)
    if (const double strain = strain_95(body, k); !(strain <= most.strain))
      most = {name_of(body.mesh().tissues[k]), strain, is_straining(body, k)};
  return most;
}


template <typename Real>
void PeakFields<Real>::save(const SolidBody<Real> &body,
                            const std::string &folder) const
{
  if (!active_)
    return;
  io::save_part(
    folder, "peaks", body.communicator(), [&](io::StateWriter &out) {
      out.put(n_steps_);
      out.put_records(fields_[0].size(), [&](const std::size_t i) {
        return Record{
          body.mesh().global_element[i],
          {{fields_[0][i], fields_[1][i], fields_[2][i], fields_[3][i]}}};
      });
    });
}


template <typename Real>
void PeakFields<Real>::restore(const SolidBody<Real> &body,
                               const std::string &folder)
{
  if (!active_)
    return;
  const auto &numbers = body.mesh().global_element;
  const io::NumberIndex here =
    io::index_by_number(body.mesh().elements.size(),
                        [&](const std::size_t i) { return numbers[i]; });
  io::restore_parts(folder, "peaks", [&](io::StateReader &in) {
    in.take(n_steps_);
    in.take_records<Record>(here,
                            [&](const std::size_t i, const Record &record) {
                              for (unsigned int k = 0; k < n_fields; ++k)
                                fields_[k][i] = record.peaks[k];
                            });
  });
}


template class PeakFields<double>;
template class PeakFields<float>;
} // namespace contrecoup::solid
