// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/blast_probes.h>

#include <istream>
#include <ostream>

namespace contrecoup::gas
{
template <int dim>
void BlastProbes<dim>::place(std::vector<dealii::Point<dim>> places,
                             const GasScene<dim> &scene,
                             const std::string &what)
{
  places_ = std::move(places);
  records_.assign(places_.size(), {});
  ambient_.clear();
  for (const auto &place : places_)
  {
    scene.require_inside(place, what);
    ambient_.push_back(scene.initial_state.ambient_pressure(place));
  }
}


template <int dim>
void BlastProbes<dim>::save(std::ostream &stream) const
{
  stream.write(reinterpret_cast<const char *>(records_.data()),
               records_.size() * sizeof(Record));
}


template <int dim>
void BlastProbes<dim>::load(std::istream &stream)
{
  stream.read(reinterpret_cast<char *>(records_.data()),
              records_.size() * sizeof(Record));
}


template class BlastProbes<1>;
template class BlastProbes<2>;
template class BlastProbes<3>;
} // namespace contrecoup::gas
