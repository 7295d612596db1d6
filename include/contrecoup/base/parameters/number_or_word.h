// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <memory>
#include <optional>
#include <string>

namespace contrecoup
{
/// Pattern of entries that are a number in a range, or a word that stands for
/// a value from elsewhere.
class NumberOrWord : public dealii::Patterns::PatternBase
{
public:
  NumberOrWord(const dealii::Patterns::Double &number, std::string word);

  bool match(const std::string &text) const override;
  std::string description(const OutputStyle style = Machine) const override;
  std::unique_ptr<PatternBase> clone() const override;

  /// The pattern with this description(); null for those of other patterns.
  static std::unique_ptr<NumberOrWord> create(const std::string &description);

  const std::string &word() const
  {
    return word_;
  }

private:
  dealii::Patterns::Double number_;
  std::string word_;
};

/// Declares a finite number in [@p smallest, @p largest], or @p word, which is
/// the default. See declare_double().
void declare_number_or_word(dealii::ParameterHandler &prm,
                            const std::string &name,
                            const std::string &word,
                            double smallest,
                            double largest,
                            const std::string &unit,
                            const std::string &sentence);

/// The number of such an entry; nothing for the word.
std::optional<double> read_number(const dealii::ParameterHandler &prm,
                                  const std::string &name,
                                  const std::string &word);
} // namespace contrecoup
