// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/run/energy_audit.h>

namespace contrecoup::solid
{
namespace
{
  /// Fraction of the largest energy of the run below which the internal energy
  /// of the body or a tissue is not judged.
  constexpr double judged_fraction = 1e-3;

  constexpr const char *section_name = "Energy audit";
} // namespace


void EnergyAudit::declare_parameters(dealii::ParameterHandler &prm)
{
  const Section section(prm, section_name);
  declare_double(prm,
                 "Largest residual",
                 "0.01",
                 0.,
                 1e6,
                 "-",
                 "The run fails if the energy balance of elements and nodes "
                 "against the work of loads misses more than this fraction "
                 "at the end.");
  declare_double(prm,
                 "Largest hourglass part",
                 "0.1",
                 0.,
                 1e6,
                 "-",
                 "A warning is given for each tissue in which the largest "
                 "energy stored in hourglass modes over time exceeds this "
                 "fraction of the tissue's largest internal energy over time: "
                 "its elements are too coarse to bend.");
}


void EnergyAudit::parse_parameters(dealii::ParameterHandler &prm)
{
  const Section section(prm, section_name);
  largest_residual_ = read_double(prm, "Largest residual");
  largest_hourglass_ = read_double(prm, "Largest hourglass part");
}


void EnergyAudit::record(const EnergyLedger &ledger)
{
  scale_ = std::max({scale_,
                     ledger.initial,
                     std::abs(ledger.external_work),
                     ledger.sum.kinetic + std::abs(ledger.sum.internal())});
  const auto add = [](Largest &largest, const TissueEnergies &energies) {
    largest.internal = std::max(largest.internal, energies.internal());
    largest.hourglass = std::max(largest.hourglass, energies.hourglass);
  };
  add(body_, ledger.sum);
  tissues_.resize(ledger.tissues.size());
  for (std::size_t i = 0; i < tissues_.size(); ++i)
    add(tissues_[i], ledger.tissues[i]);
}


double EnergyAudit::hourglass_part(const Largest &largest) const
{
  return largest.hourglass /
         std::max({largest.internal, judged_fraction * scale_, 1e-300});
}


double EnergyAudit::hourglass_part() const
{
  double part = 0.;
  for (const Largest &tissue : tissues_)
    part = std::max(part, hourglass_part(tissue));
  return part;
}


double EnergyAudit::residual(const EnergyLedger &ledger) const
{
  return ledger.residual() / std::max(scale_, 1e-300);
}


std::vector<NamedValue>
EnergyAudit::checks(const EnergyLedger &ledger,
                    const std::vector<Tissue> &tissues) const
{
  const double internal =
    std::max({body_.internal, judged_fraction * scale_, 1e-300});
  std::vector<NamedValue> values{
    {"energy_residual", "-", residual(ledger)},
    {"nodal_work_difference",
     "-",
     (ledger.nodal_internal_work - ledger.sum.internal()) /
       std::max(scale_, 1e-300)},
    {"hourglass_part", "-", hourglass_part()},
    {"hourglass_damping_part", "-", ledger.sum.hourglass_damping / internal}};
  if (tissues.size() > 1)
    for (std::size_t i = 0; i < tissues_.size(); ++i)
      values.push_back({tissue_column("hourglass_part", tissues[i]),
                        "-",
                        hourglass_part(tissues_[i])});
  return values;
}


void EnergyAudit::judge_residual(const EnergyLedger &ledger) const
{
  const double missing = std::abs(residual(ledger));
  log_line("energy: " + brief(ledger.sum.kinetic) + " J kinetic, " +
           brief(ledger.sum.internal()) + " J internal, work of loads " +
           brief(ledger.external_work) + " J, missing " +
           brief(100. * missing, 3) + " %");
  if (!(missing <= largest_residual_))
    throw NumericsError(
      "energy audit: " + brief(100. * missing) +
      " % of the energy is missing; Energy audit/Largest residual allows " +
      brief(100. * largest_residual_) + " %");
}


void EnergyAudit::judge_hourglass(const std::vector<Tissue> &tissues) const
{
  for (std::size_t i = 0; i < tissues_.size(); ++i)
    if (const double part = hourglass_part(tissues_[i]);
        part > largest_hourglass_)
      log_line("WARNING: hourglass modes store " + brief(100. * part, 3) +
               " % of the largest internal energy of " + name_of(tissues[i]) +
               ", more than the " + brief(100. * largest_hourglass_, 3) +
               " % of Energy audit/Largest hourglass part; smaller elements, "
               "or Elements/Integration = full, show what that changes");
}


void EnergyAudit::judge(const EnergyLedger &ledger,
                        const std::vector<Tissue> &tissues) const
{
  if (scale_ == 0.)
    return;
  judge_residual(ledger);
  judge_hourglass(tissues);
}


void EnergyAudit::save(io::StateWriter &out) const
{
  out.put(scale_);
  out.put(body_);
  for (const Largest &one : tissues_)
    out.put(one);
}


void EnergyAudit::load(io::StateReader &in, const std::size_t n_tissues)
{
  in.take(scale_);
  in.take(body_);
  tissues_.resize(n_tissues);
  for (Largest &one : tissues_)
    in.take(one);
}
} // namespace contrecoup::solid
