// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/coupling/scene/scene_plan.h>
#include <contrecoup/io/run/plan_table.h>

#include <algorithm>

namespace contrecoup::coupling
{
PlannedScene::PlannedScene(dealii::ParameterHandler &prm)
{
  parameters_.parse_parameters(prm);
  {
    const Section section(prm, "Body");
    description_.parse_parameters(prm);
  }
  body_ = description_.create();
  layout_.emplace(parameters_, *body_->surface());
  parameters_.fit_elements(layout_->body);
  find_body();
  plan_ = scene_plan(parameters_, *layout_, body_mass_, has_lung());
}


bool PlannedScene::has_lung() const
{
  const auto &parts = body_->parts();
  return std::any_of(parts.begin(), parts.end(), [](const BodyPart &part) {
    return part.tissue == Tissue::lung;
  });
}


void PlannedScene::find_body()
{
  const double element_size = parameters_.element_size;
  try
  {
    body_mass_ = body_kind() == "phantom" ? description_.reference_mass()
                                          : estimate_mass(*body_, element_size);
    if (parameters_.wants_injury())
      tissue_places_ =
        find_tissue_places(*body_, layout_->charge, element_size);
  }
  catch (const InputError &error)
  {
    throw InputError("Scene/Element size: " + std::string(error.what()));
  }
}


void PlannedScene::print() const
{
  log_line("scene " + version() + " (" + git_revision() +
           "): " + brief(parameters_.mass) + " kg of " + parameters_.explosive +
           ", " + brief(layout_->distance) + " m from the " + body_kind() +
           ", " + brief(layout_->charge[2]) + " m above the ground; cells of " +
           brief(1e3 * layout_->cell_size()) + " mm at the skin" +
           (parameters_.wants_injury()
              ? ", elements of " + brief(1e3 * parameters_.element_size) + " mm"
              : ""));
  log_line(layout_->is_far(parameters_)
             ? "  expected in free air: the front reaches the body at " +
                 brief(1e3 * layout_->arrival, 3) + " ms with " +
                 brief(1e-3 * layout_->overpressure, 3) + " kPa"
             : "  the front reaches the body before it has swept the charge's "
               "mass of air; what it has there is not known beforehand");
  for (const std::string &remark : body_->remarks())
    log_line("  " + remark);
  for (const std::string &line : io::plan_lines(plan_))
    log_line(line);
}
} // namespace contrecoup::coupling
