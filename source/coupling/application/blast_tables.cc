// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/coupling/application/blast_tables.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/record/load_gauges.h>
#include <contrecoup/io/application/check_file.h>

#include <limits>

namespace contrecoup::coupling
{
namespace
{
  std::size_t n_probes(const ParameterHandler &prm, const unsigned int dim)
  {
    return dim == 1   ? read_points<1>(prm, "Points").size()
           : dim == 2 ? read_points<2>(prm, "Points").size()
                      : read_points<3>(prm, "Points").size();
  }


  void add_probes(ParameterHandler &prm,
                  const unsigned int dim,
                  std::vector<std::string> &outputs)
  {
    const Section section(prm, "Probes");
    std::vector<std::string> columns;
    const std::size_t count = n_probes(prm, dim);
    for (std::size_t i = 1; i <= count; ++i)
      for (const char *quantity : {"pressure",
                                   "density",
                                   "velocity_x",
                                   "velocity_y",
                                   "velocity_z",
                                   "products"})
        columns.push_back("probe_" + std::to_string(i) + "_" + quantity);
    for (const std::string &output : io::history_outputs("probes.csv", columns))
      outputs.push_back(output);
    for (std::size_t i = 1; i <= count; ++i)
      outputs.push_back("probe_injury.csv:* probe " + std::to_string(i) +
                        ":value");
  }


  template <int dim>
  std::vector<std::string> gauge_names(ParameterHandler &prm)
  {
    gas::RigidBody body;
    body.parse_parameters(prm);
    if (body.empty())
      return {};
    dealii::Point<dim> lower, upper;
    {
      const Section section(prm, "Domain");
      lower = read_point<dim>(prm, "Lower corner");
      upper = read_point<dim>(prm, "Upper corner");
    }
    gas::LoadGauges gauges;
    const Section section(prm, "Loads");
    // Whether gauges are near enough to the skin is asked by the solver.
    gauges.parse_parameters(
      prm, body, lower, upper, std::numeric_limits<double>::infinity());
    return gauges.names();
  }


  void add_gauges(ParameterHandler &prm,
                  const unsigned int dim,
                  std::vector<std::string> &outputs)
  {
    const auto names = dim == 2 ? gauge_names<2>(prm) : gauge_names<3>(prm);
    for (const std::string &output :
         io::history_outputs("load_gauges.csv", names))
      outputs.push_back(output);
    for (const std::string &name : names)
    {
      for (const char *measure :
           {"arrival", "peak", "peak time", "impulse", "positive phase"})
        outputs.push_back("gauge_measures.csv:" + name + ":" + measure);
    }
    if (!names.empty())
      outputs.emplace_back("gauge_injury.csv:*:value");
  }
} // namespace


std::vector<std::string> blast_tables(ParameterHandler &prm)
{
  std::vector<std::string> outputs = io::history_outputs("history.csv", {"*"});
  unsigned int dim = 3;
  {
    const Section section(prm, "Domain");
    dim = read_unsigned(prm, "Dimension");
  }
  add_probes(prm, dim, outputs);
  if (dim > 1 && prm.get_bool({"Loads"}, "Record"))
    add_gauges(prm, dim, outputs);
  const std::string profile = prm.get({"Output"}, "Profile file");
  if (!profile.empty())
    outputs.push_back(profile + ":*");
  return outputs;
}
} // namespace contrecoup::coupling
