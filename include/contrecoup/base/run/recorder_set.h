// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace contrecoup
{
/**
 * The recorders of a run: one of each of @p Kinds, in the order in which
 * checkpoints and summary have them, and those that a program adds.
 * @tparam Interface base class of all recorders of a solver
 */
template <typename Interface, typename... Kinds>
class RecorderSet
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm)
  {
    (Kinds::declare_parameters(prm), ...);
  }

  /// The recorder of class @p Kind, for functions beyond the interface.
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

  /// Adds a recorder that is none of @p Kinds; it comes last.
  void add(std::shared_ptr<Interface> recorder)
  {
    added_.push_back(std::move(recorder));
  }

  /// Calls a function, or a member function of the interface, with each
  /// recorder and the arguments.
  template <typename Function, typename... Arguments>
  void for_each(const Function &function, const Arguments &...arguments)
  {
    const auto call = [&](Interface &recorder) {
      std::invoke(function, recorder, arguments...);
    };
    std::apply([&](auto &...recorder) { (call(recorder), ...); }, recorders_);
    for (const auto &recorder : added_)
      call(*recorder);
  }

  /// Concatenates the lists that such a function returns for each recorder.
  template <typename Function, typename... Arguments>
  auto collect(const Function &function, const Arguments &...arguments) const
  {
    std::invoke_result_t<Function, const Interface &, const Arguments &...>
      result;
    const auto call = [&](const Interface &recorder) {
      for (auto &item : std::invoke(function, recorder, arguments...))
        result.push_back(std::move(item));
    };
    std::apply([&](const auto &...recorder) { (call(recorder), ...); },
               recorders_);
    for (const auto &recorder : added_)
      call(*recorder);
    return result;
  }

private:
  std::tuple<Kinds...> recorders_;
  std::vector<std::shared_ptr<Interface>> added_;
};
} // namespace contrecoup
