// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/study/design.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace contrecoup::study
{
namespace
{
  constexpr double most_variants = 1e5;

  void add_row(const Factor &factor, const std::size_t row, Variant &variant)
  {
    for (const auto &setting : factor.settings(row))
      variant.settings.push_back(setting);
    variant.labels.push_back(factor.labels[row]);
    variant.numbers.push_back(factor.number(row));
  }

  Variant variant_of(const std::vector<Factor> &factors,
                     const std::vector<std::size_t> &rows)
  {
    Variant variant;
    for (std::size_t i = 0; i < factors.size(); ++i)
      add_row(factors[i], rows[i], variant);
    return variant;
  }

  void require_few(const double count)
  {
    if (count > most_variants)
      throw InputError("the design has " + brief(count) +
                       " variants; at most " + brief(most_variants, 6) +
                       " are possible");
  }

  std::vector<Variant> full_grid(const std::vector<Factor> &factors)
  {
    double count = 1.;
    for (const Factor &factor : factors)
      count *= static_cast<double>(factor.values.size());
    require_few(count);
    std::vector<Variant> variants;
    std::vector<std::size_t> rows(factors.size(), 0);
    for (;;)
    {
      variants.push_back(variant_of(factors, rows));
      std::size_t i = factors.size();
      while (i > 0 && ++rows[i - 1] == factors[i - 1].values.size())
        rows[--i] = 0;
      if (i == 0)
        return variants;
    }
  }

  std::vector<Variant> one_at_a_time(const std::vector<Factor> &factors)
  {
    std::vector<std::size_t> rows(factors.size(), 0);
    std::vector<Variant> variants = {variant_of(factors, rows)};
    for (std::size_t i = 0; i < factors.size(); ++i)
    {
      for (rows[i] = 1; rows[i] < factors[i].values.size(); ++rows[i])
        variants.push_back(variant_of(factors, rows));
      rows[i] = 0;
    }
    return variants;
  }

  /// Uniform in [0, 1); unlike the distributions of the standard library the
  /// same on every machine.
  double uniform(std::mt19937_64 &random)
  {
    return std::ldexp(static_cast<double>(random() >> 11U), -53);
  }

  std::vector<std::size_t> permutation(const std::size_t count,
                                       std::mt19937_64 &random)
  {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = count; i > 1; --i)
      std::swap(order[i - 1],
                order[static_cast<std::size_t>(uniform(random) *
                                               static_cast<double>(i))]);
    return order;
  }

  /// Adds the coordinate @p u in [0, 1) of a factor to a variant.
  void add_place(const Factor &factor, const double u, Variant &variant)
  {
    if (!factor.is_range)
    {
      add_row(
        factor,
        static_cast<std::size_t>(u * static_cast<double>(factor.values.size())),
        variant);
      return;
    }
    const double value =
      factor.logarithmic
        ? factor.lower * std::pow(factor.upper / factor.lower, u)
        : factor.lower + u * (factor.upper - factor.lower);
    const std::string text = brief(value, 6);
    variant.settings.emplace_back(factor.entries.front(), text);
    variant.labels.push_back(text);
    variant.numbers.push_back(leading_number(text));
  }

  std::vector<Variant> latin_hypercube(const std::vector<Factor> &factors,
                                       const DesignParameters &parameters)
  {
    std::mt19937_64 random(parameters.seed);
    std::vector<Variant> variants(parameters.samples);
    for (const Factor &factor : factors)
    {
      const auto order = permutation(variants.size(), random);
      for (std::size_t i = 0; i < variants.size(); ++i)
        add_place(factor,
                  (static_cast<double>(order[i]) + uniform(random)) /
                    static_cast<double>(variants.size()),
                  variants[i]);
    }
    return variants;
  }
} // namespace

std::vector<Variant> make_design(const std::vector<Factor> &factors,
                                 const DesignParameters &parameters)
{
  require_few(parameters.samples);
  if (parameters.kind == "latin hypercube")
    return latin_hypercube(factors, parameters);
  for (const Factor &factor : factors)
    if (factor.is_range)
      throw InputError("Vary " + factor.name +
                       "/Values is a range, which only the design \"latin "
                       "hypercube\" can sample; give values separated by "
                       "\";\"");
  return parameters.kind == "one at a time" ? one_at_a_time(factors)
                                            : full_grid(factors);
}
} // namespace contrecoup::study
