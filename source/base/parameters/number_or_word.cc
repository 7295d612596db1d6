// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/number_or_word.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>

namespace contrecoup
{
namespace
{
  /// Stands between number and word in descriptions.
  const std::string separator = " or the word ";
} // namespace


NumberOrWord::NumberOrWord(const dealii::Patterns::Double &number,
                           std::string word)
  : number_(number)
  , word_(std::move(word))
{}


bool NumberOrWord::match(const std::string &text) const
{
  return text == word_ || number_.match(text);
}


std::string NumberOrWord::description(const OutputStyle style) const
{
  return number_.description(style) + separator + word_;
}


std::unique_ptr<dealii::Patterns::PatternBase> NumberOrWord::clone() const
{
  return std::make_unique<NumberOrWord>(*this);
}


std::unique_ptr<NumberOrWord>
NumberOrWord::create(const std::string &description)
{
  const std::size_t end = description.find(separator);
  if (description.find("[Double ") != 0 || end == std::string::npos)
    return nullptr;
  return std::make_unique<NumberOrWord>(
    *dealii::Patterns::Double::create(description.substr(0, end)),
    description.substr(end + separator.size()));
}


void declare_number_or_word(ParameterHandler &prm,
                            const std::string &name,
                            const std::string &word,
                            const double smallest,
                            const double largest,
                            const std::string &unit,
                            const std::string &sentence)
{
  prm.declare_entry(name,
                    word,
                    NumberOrWord({smallest, largest}, word),
                    UsedWith::annotate("[" + unit + "] " + sentence));
}


std::optional<double> read_number(const ParameterHandler &prm,
                                  const std::string &name,
                                  const std::string &word)
{
  if (prm.get(name) == word)
    return {};
  return read_double(prm, name);
}
} // namespace contrecoup
