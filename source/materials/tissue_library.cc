// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/names.h>
#include <contrecoup/materials/tissue_library.h>
#include <contrecoup/materials/units.h>

#include <cmath>

namespace contrecoup
{
namespace
{
  const std::string paper = "Tan, Saunders and Bagchi 2017, table 1";

  /// An elastic tissue from Young's modulus and Poisson's ratio.
  TissueProperties elastic(const Tissue tissue,
                           const double density,
                           const double young,
                           const double poisson,
                           const std::string &source)
  {
    const double shear = young / (2. * (1. + poisson));
    return {tissue,
            density,
            young / (3. * (1. - 2. * poisson)),
            shear,
            shear,
            0.,
            source};
  }

  /// Materials of surrogates.
  std::vector<TissueProperties> engineering_materials()
  {
    return {TissueProperties{Tissue::water,
                             998.,
                             2.18 * gigapascal,
                             0.,
                             0.,
                             0.,
                             "water at 20 C, sound speed 1482 m/s; recalled"},
            elastic(Tissue::gelatin,
                    1060.,
                    // Shear modulus 30 kPa, bulk modulus 2.3 GPa.
                    3. * 30. * kilopascal,
                    0.5 - 30. * kilopascal / (2. * 2.3 * gigapascal),
                    "ballistic gelatin, sound speed 1470 m/s, shear modulus "
                    "30 kPa; recalled"),
            elastic(Tissue::polycarbonate,
                    1200.,
                    2.4 * gigapascal,
                    0.37,
                    "data sheets of polycarbonate; recalled")};
  }

  std::vector<TissueProperties> paper_set()
  {
    const std::string as_brain = paper + "; there part of the brain";
    const std::string as_tissue = paper + "; there part of the soft tissue";
    std::vector<TissueProperties> set{
      elastic(Tissue::skeleton, 1100., 5. * gigapascal, 0.3, paper),
      elastic(Tissue::lung, 100., 50. * kilopascal, 0.3, paper)};
    for (const Tissue tissue :
         {Tissue::brain, Tissue::spinal_cord, Tissue::cerebrospinal_fluid})
      set.push_back(TissueProperties{
        tissue,
        1000.,
        2.19 * gigapascal,
        49. * kilopascal,
        16. * kilopascal,
        6e-3,
        tissue == Tissue::cerebrospinal_fluid ? as_brain : paper});
    for (const Tissue tissue :
         {Tissue::soft_tissue, Tissue::skin, Tissue::heart, Tissue::liver})
      set.push_back(elastic(tissue,
                            1000.,
                            80. * megapascal,
                            0.4,
                            tissue == Tissue::soft_tissue ? paper : as_tissue));
    for (const TissueProperties &one : engineering_materials())
      set.push_back(one);
    return set;
  }

  /// Organs that resemble water; sources are recalled.
  std::vector<TissueProperties> physiological_organs()
  {
    const std::string recalled = "; recalled";
    std::vector<TissueProperties> set{
      TissueProperties{Tissue::heart,
                       1060.,
                       2.6 * gigapascal,
                       60. * kilopascal,
                       20. * kilopascal,
                       10e-3,
                       "muscle and blood, sound speed 1566 m/s" + recalled},
      TissueProperties{Tissue::liver,
                       1060.,
                       2.65 * gigapascal,
                       20. * kilopascal,
                       5. * kilopascal,
                       10e-3,
                       "sound speed 1580 m/s" + recalled}};
    for (const Tissue tissue : {Tissue::brain, Tissue::spinal_cord})
      set.push_back(
        TissueProperties{tissue,
                         1040.,
                         2.37 * gigapascal,
                         41. * kilopascal,
                         7.8 * kilopascal,
                         2.5e-3,
                         "sound speed 1510 m/s; white matter of Zhang "
                         "et al. 2001" +
                           recalled});
    return set;
  }

  /// Air at 1 bar in three quarters of the volume: K = 142 kPa / 0.75.
  TissueProperties physiological_lung()
  {
    TissueProperties lung = TissueProperties{
      Tissue::lung,
      260.,
      0.19 * megapascal,
      5. * kilopascal,
      5. * kilopascal,
      0.,
      "density ICRP 89 half full, bulk modulus by Wood's law of "
      "bubbly media; recalled"};
    lung.gas = GasFilling(0.75, 1.4, 2.2 * gigapascal / lung.bulk_modulus);
    return lung;
  }

  std::vector<TissueProperties> physiological_set()
  {
    const std::string recalled = "; recalled";
    std::vector<TissueProperties> set{
      TissueProperties{Tissue::soft_tissue,
                       1000.,
                       2.37 * gigapascal,
                       60. * kilopascal,
                       20. * kilopascal,
                       10e-3,
                       "muscle of 1050 and fat of 900 kg/m^3, sound speed "
                       "1540 m/s" +
                         recalled},
      TissueProperties{Tissue::skin,
                       1100.,
                       2.85 * gigapascal,
                       400. * kilopascal,
                       400. * kilopascal,
                       0.,
                       "sound speed 1610 m/s, Young's modulus 1.2 MPa" +
                         recalled},
      elastic(Tissue::skeleton,
              1300.,
              8. * gigapascal,
              0.22,
              "density ICRP 89, moduli of cortical and spongy bone together "
              "as in head models" +
                recalled),
      TissueProperties{Tissue::cerebrospinal_fluid,
                       1007.,
                       2.19 * gigapascal,
                       0.,
                       0.,
                       0.,
                       "close to water" + recalled},
      physiological_lung()};
    for (const TissueProperties &one : physiological_organs())
      set.push_back(one);
    for (const TissueProperties &one : engineering_materials())
      set.push_back(one);
    return set;
  }

  std::vector<TissueProperties> aerated_set()
  {
    std::vector<TissueProperties> set = paper_set();
    for (TissueProperties &one : set)
      if (one.tissue == Tissue::lung)
        one = physiological_lung();
    return set;
  }
} // namespace

double TissueProperties::dilatational_speed() const
{
  return std::sqrt((bulk_modulus + 4. / 3. * instantaneous_shear) / density);
}

double TissueProperties::shear_speed() const
{
  return std::sqrt(instantaneous_shear / density);
}

const std::vector<std::string> &tissue_set_names()
{
  static const std::vector<std::string> names{
    "paper", "physiological", "paper with aerated lung"};
  return names;
}

const TissueProperties &find_tissue_properties(const std::string &set,
                                               const Tissue tissue)
{
  static const std::vector<std::vector<TissueProperties>> sets{
    paper_set(), physiological_set(), aerated_set()};
  const std::size_t position =
    position_of(set, tissue_set_names(), "set of tissues");
  for (const TissueProperties &one : sets[position])
    if (one.tissue == tissue)
      return one;
  throw InputError("the set of tissues \"" + set +
                   "\" has no properties of \"" + name_of(tissue) + "\"");
}
} // namespace contrecoup
