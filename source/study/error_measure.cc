// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/vtk_input.h>
#include <contrecoup/study/curve.h>
#include <contrecoup/study/error_measure.h>
#include <contrecoup/study/json_path.h>
#include <contrecoup/study/run_outputs.h>
#include <contrecoup/study/run_record.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

namespace contrecoup::study
{
namespace
{
  namespace fs = std::filesystem;

  const std::vector<std::string> quantities{"summary",
                                            "probe peak",
                                            "probe lowest",
                                            "probe impulse",
                                            "probe arrival",
                                            "probe curve",
                                            "history peak",
                                            "history lowest",
                                            "history impulse",
                                            "history arrival",
                                            "history curve",
                                            "plane"};

  /// A quantity in a plane.
  struct PlaneField
  {
    std::string extent; ///< numbers of the points along the axes
    std::vector<double> values;
  };

  /// Reads "STEM_QUANTITY" from STEM_NNNN.vti with the largest number.
  PlaneField newest_plane(const std::string &folder, const std::string &name)
  {
    std::map<std::string, std::string> newest; // file by stem
    std::error_code ignored;
    for (const auto &entry : fs::directory_iterator(folder, ignored))
      if (entry.path().extension() == ".vti")
      {
        const std::string stem = entry.path().stem().string();
        std::string &file = newest[stem.substr(0, stem.rfind('_'))];
        file = std::max(file, entry.path().string());
      }
    std::vector<std::string> known;
    for (const auto &[stem, file] : newest)
    {
      const io::VtkInput plane(file);
      for (const std::string &quantity : plane.names())
      {
        known.push_back(stem + "_" + quantity);
        if (known.back() == name)
          return {plane.extent(), plane.numbers(quantity)};
      }
    }
    throw InputError("Error/Name: \"" + folder + "\" has no plane \"" + name +
                     "\"" + suggestion(name, known));
  }

  /// Mean absolute difference, without samples that are NaN.
  double mean_difference(const PlaneField &a, const PlaneField &b)
  {
    if (a.extent != b.extent || a.values.size() != b.values.size())
      throw InputError("Error/Quantity = plane: this run and the reference "
                       "run have different numbers of samples");
    double sum = 0.;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
      if (std::isfinite(a.values[i] - b.values[i]))
      {
        sum += std::abs(a.values[i] - b.values[i]);
        ++count;
      }
    return sum / static_cast<double>(count);
  }

  nlohmann::json read_reference_summary(const std::string &folder)
  {
    const std::string file = folder + "/summary.json";
    require_readable("the reference run's summary", file);
    std::ifstream input(file);
    const auto summary = nlohmann::json::parse(input, nullptr, false);
    if (!summary.is_object())
      throw InputError("the reference run's summary \"" + file +
                       "\" is damaged: it is no JSON");
    return summary;
  }

  /// Declares the values that the result is compared with.
  void declare_reference(ParameterHandler &prm)
  {
    // These bounds admit values of every quantity.
    declare_double(
      prm,
      "Known value",
      "0",
      -bounds::energy,
      bounds::energy,
      "unit of the quantity",
      used_with("Error/Kind = known value",
                "Known value of the quantity; the error is relative to it, "
                "or absolute if it is 0."));
    const UsedWith used("Error/Kind = reference run");
    declare_string(
      prm,
      "Reference",
      "",
      "Entries of the reference run, which the study runs first, "
      "besides those of all variants: \"Section/Entry=value; ...\".");
    declare_string(prm,
                   "Reference folder",
                   "",
                   "Instead, the output folder of an existing reference run.");
  }
} // namespace

void ErrorMeasure::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Error");
  declare_selection(
    prm,
    "Kind",
    "exact",
    {"exact", "known value", "reference run", "self convergence", "none"},
    "Reference of the error: exact solution, as summary.json states; known "
    "value; another run; Richardson extrapolation on finer meshes; or none.");
  declare_string(
    prm,
    "Name",
    "density_L1",
    used_with(
      "Error/Kind not none",
      selecting("For exact, the name below \"errors\" in summary.json; for "
                "summary, an output as in Study/Columns; for probe or history, "
                "their column; for a plane, its plane_y_0_pressure.")));
  declare_selection(
    prm,
    "Quantity",
    "summary",
    quantities,
    used_with("Error/Kind = known value, reference run, self convergence",
              "Unless Kind is exact: a value of summary.json; largest "
              "rise, fall, integral of the rise, or arrival at a probe "
              "or in the history; mean difference of its curve, or of "
              "a plane cut at the end, from the reference run."));
  declare_reference(prm);
  declare_double(
    prm,
    "Averaging time",
    "0",
    0.,
    bounds::time,
    "s",
    used_with("Error/Kind = known value, reference run, self convergence",
              "Curves are averaged over this interval before comparison, "
              "which removes faster oscillations; 0: not averaged."));
  declare_double(
    prm,
    "Wanted error",
    "0",
    0.,
    bounds::energy,
    "unit of the error",
    used_with("Error/Kind not none",
              "The cheapest variant with at most this error is "
              "recommended and written to recommended.prm; 0: none."));
}

void ErrorMeasure::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Error");
  kind_ = prm.get("Kind");
  quantity_ = prm.get("Quantity");
  name_ = prm.get("Name");
  known_ = read_double(prm, "Known value");
  averaging_time_ = read_double(prm, "Averaging time");
  wanted_ = read_double(prm, "Wanted error");
  reference_folder_ = prm.get("Reference folder");
  const std::string reference = prm.get("Reference");
  if (kind_ != "reference run" &&
      (!reference.empty() || !reference_folder_.empty()))
    throw InputError("Error/Reference and Error/Reference folder need "
                     "Error/Kind = reference run, not \"" +
                     kind_ + "\"");
  if (kind_ == "reference run" &&
      reference.empty() == reference_folder_.empty())
    throw InputError("Error/Kind = reference run needs either Error/Reference "
                     "or Error/Reference folder");
  if (kind_ != "reference run" && kind_ != "exact" && compares_files())
    throw InputError("Error/Quantity = " + quantity_ +
                     " needs Error/Kind = reference run");
  if (!reference.empty())
    reference_settings_ = parse_settings(reference, "Error/Reference");
  if (kind_ == "none" && wanted_ > 0.)
    throw InputError("Error/Wanted error needs an Error/Kind other than none");
}

bool ErrorMeasure::compares_files() const
{
  return curve_feature() == "curve" || quantity_ == "plane";
}

std::string ErrorMeasure::curve_feature() const
{
  const std::size_t space = quantity_.find(' ');
  return space == std::string::npos ? "" : quantity_.substr(space + 1);
}

Curve ErrorMeasure::curve(const std::string &folder) const
{
  const bool is_probe = quantity_.compare(0, 5, "probe") == 0;
  const Curve recorded =
    read_curve(folder + (is_probe ? "/probes.csv" : "/history.csv"), name_);
  return averaging_time_ > 0. ? averaged(recorded, averaging_time_) : recorded;
}

bool ErrorMeasure::is_active() const
{
  return kind_ != "none";
}

bool ErrorMeasure::is_self_convergence() const
{
  return kind_ == "self convergence";
}

const std::optional<Settings> &ErrorMeasure::reference_settings() const
{
  return reference_settings_;
}

void ErrorMeasure::set_reference_folder(const std::string &folder)
{
  reference_folder_ = folder;
}

double ErrorMeasure::value(const std::string &folder,
                           const nlohmann::json &summary) const
{
  if (kind_ == "exact")
    return std::abs(number_at(
      summary, "errors." + name_, "Error/Name: the summary of a run"));
  if (is_self_convergence())
    return quantity(folder, summary);
  if (compares_files())
    return difference(folder);
  const double known = kind_ == "known value" ? known_ : reference_quantity();
  const double deviation = std::abs(quantity(folder, summary) - known);
  return known == 0. ? deviation : deviation / std::abs(known);
}

double ErrorMeasure::quantity(const std::string &folder,
                              const nlohmann::json &summary) const
{
  if (is_in_summary())
    return number_at(summary, name_, "Error/Name: the summary of a run");
  if (quantity_ == "summary")
    try
    {
      return RunOutputs(folder).at(name_).value;
    }
    catch (const InputError &error)
    {
      throw InputError("Error/Name: " + std::string(error.what()));
    }
  const Curve course = curve(folder);
  const std::string kind = curve_feature();
  return kind == "peak"      ? peak(course)
         : kind == "lowest"  ? lowest(course)
         : kind == "impulse" ? impulse(course)
                             : arrival(course);
}

bool ErrorMeasure::is_in_summary() const
{
  return quantity_ == "summary" &&
         name_.find_first_of("/:") == std::string::npos;
}

double ErrorMeasure::reference_quantity() const
{
  return quantity(reference_folder_,
                  is_in_summary() ? read_reference_summary(reference_folder_)
                                  : nlohmann::json());
}

void ErrorMeasure::require_reference() const
{
  if (reference_folder_.empty())
    return;
  if (read_record(reference_folder_).status != "finished")
    throw InputError("Error/Reference folder: \"" + reference_folder_ +
                     "\" holds no finished run");
  if (quantity_ == "plane")
    newest_plane(reference_folder_ + "/fields", name_);
  else if (compares_files())
    curve(reference_folder_);
  else
    reference_quantity();
}

double ErrorMeasure::difference(const std::string &folder) const
{
  if (quantity_ == "plane")
    return mean_difference(newest_plane(folder + "/fields", name_),
                           newest_plane(reference_folder_ + "/fields", name_));
  return relative_difference(curve(folder), curve(reference_folder_));
}

std::string ErrorMeasure::title(const std::vector<Column> &columns) const
{
  std::string name = name_;
  const auto column =
    std::find_if(columns.begin(), columns.end(), [&](const Column &one) {
      return one.address == address();
    });
  // Without a column, an output is called by its address.
  if (column != columns.end())
    name = column->title;
  else if (kind_ == "exact" || quantity_ != "summary")
    std::replace(name.begin(), name.end(), '_', ' ');
  if (kind_ == "exact")
    return "error of " + name;
  const std::string what =
    quantity_ == "summary" ? name : quantity_ + " of " + name;
  return compares_files() ? "difference in " + what
                          : "relative error of " + what;
}

std::string ErrorMeasure::against() const
{
  if (!reference_settings_)
    return reference_folder_.empty()
             ? ""
             : " against the run in " + reference_folder_;
  std::vector<std::string> words;
  for (const auto &[entry, value] : *reference_settings_)
    words.push_back(entry + " = " + value);
  return " against a run with " + join(words, ", ");
}

std::string ErrorMeasure::short_name() const
{
  std::string name = kind_ == "exact" || quantity_ == "summary"
                       ? name_
                       : name_ + "_" + curve_feature();
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

std::string ErrorMeasure::address() const
{
  return kind_ == "none" || (kind_ != "exact" && quantity_ != "summary") ? ""
         : kind_ == "exact" ? "errors." + name_
                            : name_;
}

double ErrorMeasure::required_error() const
{
  return wanted_;
}
} // namespace contrecoup::study
