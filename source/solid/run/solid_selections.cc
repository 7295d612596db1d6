// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/run/solid_selections.h>

#include <algorithm>

namespace contrecoup::solid
{
namespace
{
  bool has(const SolidMesh &mesh, const Tissue tissue)
  {
    return std::find(mesh.tissues.begin(), mesh.tissues.end(), tissue) !=
           mesh.tissues.end();
  }

  std::string tissues_in_words(const SolidMesh &mesh)
  {
    std::vector<std::string> names;
    for (const Tissue tissue : mesh.tissues)
      names.push_back(name_of(tissue));
    return "the tissues of the mesh are " + join(names, ", ");
  }

  /// Counts the tissues of a list that are in the mesh, each by itself.
  void add_tissues(const SolidMesh &mesh,
                   const std::string &entry,
                   const std::vector<Tissue> &tissues,
                   Selections &selections)
  {
    for (const Tissue tissue : tissues)
    {
      const std::uint64_t count = has(mesh, tissue) ? 1 : 0;
      selections.add(entry + " (" + name_of(tissue) + ")",
                     name_of(tissue),
                     "element",
                     count);
    }
  }
} // namespace


void require_selections(const SolidMesh &mesh,
                        const SolidSelectors &selectors,
                        const MPI_Comm communicator)
{
  Selections places, tissues;
  selectors.supports.add_selections(mesh, places);
  selectors.loads.add_selections(mesh, places);
  places.require_some(communicator, extent_in_words(mesh, communicator));
  for (const Tissue tissue : selectors.materials.own())
    tissues.add("Materials/Tissue " + name_of(tissue),
                selectors.materials.changes(tissue),
                "element",
                has(mesh, tissue) ? 1 : 0);
  add_tissues(mesh,
              "Materials/Cavitating tissues",
              selectors.materials.cavitating(),
              tissues);
  for (const std::string &measure : selectors.thresholds.measures())
  {
    const InjuryCriterion criterion = selectors.thresholds.criterion(measure);
    const Tissue tissue =
      criterion.of == "chest" ? Tissue::lung : Tissue::brain;
    tissues.add(selectors.thresholds.path(measure),
                criterion.in_words(),
                "element of " + name_of(tissue),
                has(mesh, tissue) ? 1 : 0);
  }
  add_tissues(mesh, "Interface/Tissues", selectors.slip.sliding(), tissues);
  add_tissues(mesh, "Interface/Against", selectors.slip.held(), tissues);
  tissues.require_some(communicator, tissues_in_words(mesh));
  if (selectors.reports_injury && !has(mesh, Tissue::brain) &&
      !has(mesh, Tissue::lung))
    throw InputError("Injury/Active = true: injuries of brain and lung are "
                     "reported, but " +
                     tissues_in_words(mesh));
}


std::vector<Tissue> find_held_tissues(const SolidMesh &mesh,
                                      const Supports &supports,
                                      const MPI_Comm communicator)
{
  if (supports.selecting_entries().empty())
    return {};
  const auto held = supports.find_held_nodes(mesh);
  std::vector<std::uint64_t> n_free(mesh.tissues.size(), 0);
  for (std::size_t i = 0; i < mesh.elements.size(); ++i)
    for (const std::uint32_t node : mesh.elements[i])
      n_free[mesh.tissue[i]] += held[node] == 0 ? 1 : 0;
  dealii::Utilities::MPI::sum(n_free, communicator, n_free);
  std::vector<Tissue> tissues;
  for (std::size_t i = 0; i < n_free.size(); ++i)
    if (n_free[i] == 0)
      tissues.push_back(mesh.tissues[i]);
  return tissues;
}


void warn_of_supports(const SolidMesh &mesh,
                      const SolidSelectors &selectors,
                      const MPI_Comm communicator)
{
  const auto entries = selectors.supports.selecting_entries();
  const auto held = find_held_tissues(mesh, selectors.supports, communicator);
  std::vector<std::string> names;
  for (const Tissue tissue : held)
    if (selectors.reports_injury &&
        (tissue == Tissue::brain || tissue == Tissue::lung))
      names.push_back(name_of(tissue));
  if (!held.empty() && held.size() == mesh.tissues.size())
    names = {"the body"};
  if (!names.empty())
    log_line("WARNING: " + join(entries, ", ") +
             (entries.size() > 1 ? " select" : " selects") + " all nodes of " +
             join(names, " and ") +
             " in x, y and z: no load moves or strains what is held so, and "
             "its measures of injury say nothing");
}
} // namespace contrecoup::solid
