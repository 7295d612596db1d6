// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/gather.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/record/cavity_record.h>


namespace contrecoup::solid
{
namespace
{

  std::array<dealii::Point<3>, 8> corners_of(const SolidMesh &mesh,
                                             const std::uint32_t cell)
  {
    std::array<dealii::Point<3>, 8> corners;
    for (unsigned int c = 0; c < 8; ++c)
      corners[c] = mesh.nodes[mesh.elements[cell][c]];
    return corners;
  }

  /// The volumetric part of a material.
  SolidLaw<double> law_of(const SolidMaterial &material)
  {
    SolidLaw<double> law{};
    law.bulk = material.bulk_modulus;
    law.gas = material.gas;
    law.largest_tension = material.largest_tension;
    law.vapour_dilatation = material.vapour_dilatation();
    return law;
  }
} // namespace


template <typename Real>
void CavityRecord<Real>::reinit(const SolidBody<Real> &body)
{
  tissues_.clear();
  const SolidMesh &mesh = body.mesh();
  for (unsigned int k = 0; k < mesh.tissues.size(); ++k)
    if (body.elements().materials()[k].cavitates())
    {
      Cavities one;
      one.tissue = k;
      for (std::uint32_t cell = 0; cell < mesh.elements.size(); ++cell)
        if (mesh.tissue[cell] == k)
        {
          one.elements.push_back(cell);
          one.volumes.push_back(cell_volume(mesh, cell));
        }
      one.collapses.resize(one.elements.size());
      tissues_.push_back(one);
    }
}


template <typename Real>
void CavityRecord<Real>::record_elements(const SolidBody<Real> &body,
                                         Cavities &one) const
{
  const SolidLaw<double> law = law_of(body.elements().materials()[one.tissue]);
  const auto &smoothing = body.elements().batches().smoothing_pressure;
  one.volume = 0.;
  for (std::size_t i = 0; i < one.elements.size(); ++i)
  {
    const double dilatation = body.elements().dilatation(one.elements[i]);
    Collapse &collapse = one.collapses[i];
    if (dilatation > law.vapour_dilatation)
    {
      collapse.held = 1;
      one.volume += one.volumes[i] * (dilatation - law.vapour_dilatation);
    }
    else if (collapse.held != 0)
    {
      const std::uint32_t slot =
        body.elements().batches().slot(one.elements[i]);
      constexpr unsigned int n = HexBatches<Real>::n;
      const double smooth =
        smoothing.size() > 0 ? double(smoothing[slot / n][slot % n]) : 0.;
      const auto pressure =
        static_cast<float>(smooth - volumetric_stress(law, dilatation));
      if (pressure > collapse.highest)
        collapse = {1, pressure, body.time()};
    }
  }
}


template <typename Real>
void CavityRecord<Real>::record(const SolidBody<Real> &body)
{
  if (tissues_.empty())
    return;
  std::vector<double> volumes;
  for (Cavities &one : tissues_)
  {
    record_elements(body, one);
    volumes.push_back(one.volume);
  }
  dealii::Utilities::MPI::sum(volumes, body.communicator(), volumes);
  for (std::size_t k = 0; k < tissues_.size(); ++k)
  {
    Cavities &one = tissues_[k];
    one.volume = volumes[k];
    if (one.volume > one.largest)
    {
      one.largest = one.volume;
      one.time = body.time();
    }
  }
}


template <typename Real>
std::vector<NamedValue>
CavityRecord<Real>::history(const SolidBody<Real> &body) const
{
  std::vector<NamedValue> values;
  for (const Cavities &one : tissues_)
    values.push_back(
      {tissue_column("vapour_volume", body.mesh().tissues[one.tissue]),
       "m^3",
       one.volume});
  return values;
}


template <typename Real>
std::vector<NamedValue>
CavityRecord<Real>::results(const SolidBody<Real> &body) const
{
  std::vector<NamedValue> list;
  for (const Cavities &one : tissues_)
  {
    std::vector<double> highest(5, 0.); // pressure, time, place
    for (std::size_t i = 0; i < one.elements.size(); ++i)
      if (double(one.collapses[i].highest) > highest[0])
      {
        dealii::Point<3> centre;
        for (const auto &corner : corners_of(body.mesh(), one.elements[i]))
          centre += corner / 8.;
        highest = {one.collapses[i].highest,
                   one.collapses[i].time,
                   centre[0],
                   centre[1],
                   centre[2]};
      }
    for (const auto &other : gather_arrays(body.communicator(), highest))
      if (other[0] > highest[0])
        highest = other;
    const Tissue tissue = body.mesh().tissues[one.tissue];
    const auto add = [&](const std::string &name,
                         const std::string &unit,
                         const double value) {
      list.push_back({tissue_column(name, tissue), unit, value});
    };
    const auto mark = [&](const std::string &name, const bool is_cut) {
      if (is_cut)
        list.push_back({tissue_column(name, tissue) + "_cut_off", "-", 1.});
    };
    add("largest_vapour_volume", "m^3", one.largest);
    mark("largest_vapour_volume", one.largest > 0. && one.time == body.time());
    add("largest_vapour_volume_time", "s", one.time);
    add("collapse_pressure", "Pa", highest[0]);
    // Cavities that are open will collapse.
    mark("collapse_pressure",
         one.volume > 0. || (highest[0] > 0. && highest[1] == body.time()));
    add("collapse_time", "s", highest[1]);
    add("collapse_x", "m", highest[2]);
    add("collapse_y", "m", highest[3]);
    add("collapse_z", "m", highest[4]);
  }
  return list;
}


template <typename Real>
void CavityRecord<Real>::save(const SolidBody<Real> &body,
                              const std::string &folder) const
{
  if (tissues_.empty())
    return;
  io::save_part(
    folder, "cavities", body.communicator(), [&](io::StateWriter &out) {
      for (const Cavities &one : tissues_)
      {
        for (const double value : {one.volume, one.largest, one.time})
          out.put(value);
        out.put_records(one.elements.size(), [&](const std::size_t i) {
          return CollapseRecord{body.mesh().global_element[one.elements[i]],
                                one.collapses[i]};
        });
      }
    });
}


template <typename Real>
void CavityRecord<Real>::restore(const SolidBody<Real> &body,
                                 const std::string &folder)
{
  if (tissues_.empty())
    return;
  io::restore_parts(folder, "cavities", [&](io::StateReader &in) {
    for (Cavities &one : tissues_)
    {
      for (double *value : {&one.volume, &one.largest, &one.time})
        in.take(*value);
      in.take_records<CollapseRecord>(
        io::index_by_number(
          one.elements.size(),
          [&](const std::size_t i) {
            return body.mesh().global_element[one.elements[i]];
          }),
        [&](const std::size_t i, const CollapseRecord &record) {
          one.collapses[i] = record.collapse;
        });
    }
  });
}


template class CavityRecord<double>;
template class CavityRecord<float>;
} // namespace contrecoup::solid
