// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/conditions/profile_file.h>
#include <contrecoup/gas/conditions/table_profile.h>

#include "fuzz.h"

#include <fstream>

using namespace contrecoup;

namespace
{
gas::ProfileData make_profile()
{
  gas::ProfileData data;
  data.geometry = Geometry::axisymmetric;
  data.time = 1e-3;
  data.material = "ideal gas";
  data.version = "fuzz";
  data.ambient = {{1.225, 2.5e5, 0.}};
  data.ambient_pressure = 101325.;
  data.domain_begin = {0., 0.};
  data.domain_end = {0.3, 0.2};
  data.edges = {{0., 0.1, 0.2, 0.3}, {0., 0.1, 0.2}};
  data.values = {std::vector<double>(6, 1.5),
                 std::vector<double>(6, 10.),
                 std::vector<double>(6, 0.),
                 std::vector<double>(6, 4e5),
                 std::vector<double>(6, 0.1)};
  data.maps["peak_overpressure"] = std::vector<double>(6, 2e5);
  return data;
}

void prepare_table(const std::string &folder)
{
  std::ofstream(folder + "/table.csv")
    << "# x, rho, u, p, Y\nx, density, velocity, pressure, products\n"
       "0, 1, 0, 1e5, 0.5\n0.5, 2, 3, 1e5, 0\n1, 1, 0, 1e5, 0\n";
}

void use_table(const std::string &path)
{
  const gas::TableProfile table(path);
  table.value(0.5 * (table.begin() + table.end()));
}

void use(const std::string &path)
{
  const gas::Profile profile(gas::read_profile(path));
  std::vector<double> means(profile.n_components());
  profile.mean({{0., 0.}}, {{0.25, 0.1}}, means.data());
}
} // namespace


int main(int argc, char **argv)
{
  const auto prepare = [](const std::string &name) {
    return [name](const std::string &folder) {
      gas::write_profile(folder + "/" + name, make_profile());
    };
  };
  return fuzz::run(argc,
                   argv,
                   {{"profile_csv", "profile.csv", prepare("profile.csv"), use},
                    {"profile_h5", "profile.h5", prepare("profile.h5"), use},
                    {"table", "table.csv", prepare_table, use_table}});
}
