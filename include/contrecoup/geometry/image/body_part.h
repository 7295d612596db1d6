// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/tissues.h>

#include <string>

namespace contrecoup
{
/// A part of a body: an organ, a bone, a layer.
struct BodyPart
{
  std::string name;
  Tissue tissue;
};

/**
 * Parses "tissue" or "name = tissue".
 * @param where place of the text, for errors
 * @throws InputError for an unknown tissue, with a list
 */
BodyPart parse_body_part(const std::string &text, const std::string &where);
} // namespace contrecoup
