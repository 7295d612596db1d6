// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/profile_file.h>

#include "fuzz.h"

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
                    {"profile_h5", "profile.h5", prepare("profile.h5"), use}});
}
