// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/adaptation_pace.h>

#include <istream>
#include <ostream>

namespace contrecoup::gas
{
void AdaptationPace::save(std::ostream &stream) const
{
  stream.write(reinterpret_cast<const char *>(&n_steps_), sizeof(n_steps_));
  for (const double &value : {travel_, last_travel_, start_})
    stream.write(reinterpret_cast<const char *>(&value), sizeof(value));
}


void AdaptationPace::load(std::istream &stream)
{
  stream.read(reinterpret_cast<char *>(&n_steps_), sizeof(n_steps_));
  for (double *value : {&travel_, &last_travel_, &start_})
    stream.read(reinterpret_cast<char *>(value), sizeof(*value));
}
} // namespace contrecoup::gas
