// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/tissue_average.h>
#include <contrecoup/solid/record/solid_recorder.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/// The most strained tissue of a body.
struct StrainedTissue
{
  std::string name; ///< "soft tissue"; empty: unknown
  /// That 95 % of its volume has not exceeded [-].
  double strain = std::numeric_limits<double>::quiet_NaN();
  bool grows = false; ///< whether the strain still grows
};

/**
 * Extreme values of each element over time: highest and lowest pressure,
 * largest von Mises stress, largest principal strain. They are output as
 * fields, and by tissue in the summary. Subsection "Peaks".
 */
template <typename Real>
class PeakFields : public SolidRecorder<Real>
{
public:
  static constexpr unsigned int n_fields = 4;

  /// Names of the fields and their units.
  static const std::array<std::string, n_fields> names;
  static const std::array<std::string, n_fields> units;

  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm,
                        const MeshDescription &mesh) override;
  bool active() const
  {
    return active_;
  }
  void reinit(const SolidBody<Real> &body) override;
  void record(const SolidBody<Real> &body) override;

  /// For each tissue, as "highest_pressure_brain": the extreme values over its
  /// elements and, as "principal_strain_95_brain", the volume-weighted 95th
  /// percentile of the elements' largest principal strain. A value that the
  /// last evaluation changed also has "NAME_cut_off", which is 1.
  std::vector<NamedValue> results(const SolidBody<Real> &body) const override;

  /// The tissue of which 95 % has had the largest strains. Collective.
  StrainedTissue most_strained(const SolidBody<Real> &body) const;

  /// Field @p number of names, by local element.
  const std::vector<float> &field(const unsigned int number) const
  {
    return fields_[number];
  }

  void save(const SolidBody<Real> &body,
            const std::string &folder) const override;
  void restore(const SolidBody<Real> &body, const std::string &folder) override;

private:
  /// The largest principal strain that 95 % of a tissue has not exceeded.
  double strain_95(const SolidBody<Real> &body, unsigned int tissue) const;

  /// Whether the last evaluation raised the strain of more of a tissue than
  /// strain_95() leaves out, so that it grows with the time of the run.
  bool is_straining(const SolidBody<Real> &body, unsigned int tissue) const;

  bool active_ = false;
  bool averaged_ = true; ///< pressures, over neighbours
  unsigned int interval_ = 10;
  std::uint64_t n_steps_ = 0;
  std::vector<TissueAverage> averages_; ///< by tissue
  std::array<std::vector<float>, n_fields> fields_;
  /// By tissue: magnitudes of the extremes that the last evaluation changed.
  std::vector<std::array<float, n_fields>> newest_;
  /// By tissue: this rank's volume whose strain the last one raised [m^3].
  std::vector<double> straining_;
};

extern template class PeakFields<double>;
extern template class PeakFields<float>;
} // namespace contrecoup::solid
