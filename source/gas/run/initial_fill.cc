// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/hand_over/profile_mapping.h>
#include <contrecoup/gas/run/initial_fill.h>
#include <contrecoup/gas/state/leaf_sampling.h>

namespace contrecoup::gas
{
namespace
{
  template <int dim>
  dealii::Point<dim> centre_of(const LeafBox<dim> &box)
  {
    return box.origin + dealii::Tensor<1, dim>(box.extents * 0.5);
  }


  template <int dim>
  std::vector<std::string> fill_from_profile(const GasScene<dim> &scene,
                                             const LeafMesh<dim> &mesh,
                                             GasField &field,
                                             const bool rough)
  {
    const ProfileField<dim> &profile = *scene.initial_state.profile();
    const auto mapping =
      map_profile(profile, mesh, scene.points, scene.material, field, rough);
    const auto &data = profile.profile().data();
    std::vector<std::string> lines = {"profile of time " + brief(data.time, 6) +
                                      " s mapped:"};
    if (!data.material.empty() && data.material != scene.material_words)
      lines.push_back("  WARNING: it was made with material \"" +
                      data.material + "\", this one is \"" +
                      scene.material_words + "\"");
    lines.push_back(to_text(mapping, scene.material.has_products()));
    return lines;
  }
} // namespace


template <int dim>
std::vector<std::string> fill_initial_state(const GasScene<dim> &scene,
                                            const LeafMesh<dim> &mesh,
                                            GasField &field,
                                            const bool rough)
{
  const InitialState<dim> &initial = scene.initial_state;
  if (initial.profile() != nullptr)
    return fill_from_profile(scene, mesh, field, rough);
  const auto value = [&](const dealii::Point<dim> &p) {
    return initial.value(p);
  };
  const unsigned int n_samples = dim == 3 ? 4 : 8;
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const LeafBox<dim> box = leaf_box(mesh, leaf);
    const double distance = initial.distance_to_feature(centre_of(box));
    const bool near_feature =
      distance > 0. && distance <= 0.5 * box.extents.norm();
    field.set_leaf(leaf,
                   sample_leaf<dim>(value,
                                    box,
                                    scene.points,
                                    scene.material,
                                    scene.layout.n_components,
                                    near_feature,
                                    n_samples));
  }
  return scene.charges.fill(mesh, scene.points, field);
}


template <int dim>
bool varies_in_leaf(const GasScene<dim> &scene,
                    const LeafMesh<dim> &mesh,
                    const unsigned int leaf)
{
  const LeafBox<dim> box = leaf_box(mesh, leaf);
  if (const auto *profile = scene.initial_state.profile())
    return is_steep_in(*profile, box, scene.layout.n);
  const dealii::Point<dim> centre = centre_of(box);
  const double half_diagonal = 0.5 * box.extents.norm() * (1. + 1e-10);
  if (scene.charges.signed_distance(centre) < half_diagonal)
    return true;
  const double distance = scene.initial_state.distance_to_feature(centre);
  return distance > 0. && distance < half_diagonal;
}


#define CONTRECOUP_INSTANTIATE(dim)                                  \
  template std::vector<std::string> fill_initial_state(              \
    const GasScene<dim> &, const LeafMesh<dim> &, GasField &, bool); \
  template bool varies_in_leaf(                                      \
    const GasScene<dim> &, const LeafMesh<dim> &, unsigned int)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
