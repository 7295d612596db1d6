// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/injury/injury_criteria.h>
#include <contrecoup/solid/injury/injury_measure.h>

namespace contrecoup::solid
{
InjuryMeasure known_measure(const std::string &name,
                            const std::string &unit,
                            const double value)
{
  const InjuryCriterion &criterion = injury_criterion(name);
  return {{name, unit, value}, criterion.in_words(unit), criterion.limits};
}
} // namespace contrecoup::solid
