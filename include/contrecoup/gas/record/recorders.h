// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/open_sides.h>
#include <contrecoup/gas/record/probe_rasters.h>
#include <contrecoup/gas/record/probe_set.h>
#include <contrecoup/gas/record/wall_loads.h>

#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace contrecoup::gas
{
/// All recorder classes, in the order in which checkpoints and summary list
/// them.
template <int dim>
using RecorderList = std::tuple<ProbeSet<dim>,
                                ProbeRasters<dim>,
                                BlastMaps<dim>,
                                OpenSides<dim>,
                                WallLoads<dim>>;


/// The recorders of a run.
template <int dim>
class Recorders
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm)
  {
    declare(prm, static_cast<RecorderList<dim> *>(nullptr));
  }

  /// The recorder of class @p Kind, for functions beyond the Recorder
  /// interface.
  template <typename Kind>
  Kind &get()
  {
    return std::get<Kind>(recorders_);
  }
  template <typename Kind>
  const Kind &get() const
  {
    return std::get<Kind>(recorders_);
  }

  /// Adds a recorder that is not in RecorderList; it comes last.
  void add(std::shared_ptr<Recorder<dim>> recorder)
  {
    added_.push_back(std::move(recorder));
  }

  /// Calls @p function with each recorder.
  template <typename Function>
  void for_each(const Function &function)
  {
    std::apply([&](auto &...recorder) { (function(recorder), ...); },
               recorders_);
    for (const auto &recorder : added_)
      function(*recorder);
  }

  /// Concatenates the lists that @p function returns for each recorder.
  template <typename Item>
  std::vector<Item>
  collect(std::vector<Item> (Recorder<dim>::*function)(const GasSnapshot<dim> &)
            const,
          const GasSnapshot<dim> &gas) const
  {
    std::vector<Item> result;
    const auto add = [&](const Recorder<dim> &recorder) {
      for (Item &item : (recorder.*function)(gas))
        result.push_back(std::move(item));
    };
    std::apply([&](auto &...recorder) { (add(recorder), ...); }, recorders_);
    for (const auto &recorder : added_)
      add(*recorder);
    return result;
  }

private:
  template <typename... Kinds>
  static void declare(dealii::ParameterHandler &prm, std::tuple<Kinds...> *)
  {
    (Kinds::declare_parameters(prm), ...);
  }

  RecorderList<dim> recorders_;
  std::vector<std::shared_ptr<Recorder<dim>>> added_;
};
} // namespace contrecoup::gas
