// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
/// A polynomial over a range of scaled distances.
struct KingeryBulmash::Piece
{
  BlastQuantity quantity;
  double smallest, largest; ///< scaled distance [m/kg^(1/3)]
  double shift, factor;     ///< U = shift + factor log Z
  std::vector<double> coefficients;
};


struct KingeryBulmash::Set
{
  std::string name;
  bool is_decimal; ///< base 10, else natural logarithms
  std::vector<Piece> pieces;
};


const std::vector<std::string> KingeryBulmash::sets = {"spherical",
                                                       "hemispherical",
                                                       "swisdak"};

using Q = BlastQuantity;

// Units kPa, ms, m/ms; times and impulses for 1 kg.
// clang-format off
const std::vector<KingeryBulmash::Set> KingeryBulmash::tables = {
  {"spherical", true, {
    {Q::overpressure, 0.0531, 40, -0.214362789151, 1.35034249993, {2.611368669,
     -1.69012801396, 0.00804973591951, 0.336743114941, -0.00516226351334,
     -0.0809228619888, -0.00478507266747, 0.00793030472242, 0.0007684469735}},
    {Q::impulse, 0.0531, 0.792, 2.34723921354, 3.24299066475, {2.38830516757,
     -0.443749377691, 0.168825414684, 0.0348138030308, -0.010435192824}},
    {Q::impulse, 0.792, 40, -1.75305660315, 2.30629231803, {1.55197227115,
     -0.40463292088, -0.0142721946082, 0.00912366316617, -0.0006750681404,
     -0.00800863718901, 0.00314819515931, 0.00152044783382, -0.0007470265899}},
    {Q::reflected_overpressure, 0.0531, 40, -0.214362789151, 1.35034249993,
     {3.22958031387, -2.21400538997, 0.035119031446, 0.657599992109,
     0.0141818951887, -0.243076636231, -0.0158699803158, 0.0492741184234,
     0.00227639644004, -0.00397126276058}},
    {Q::reflected_impulse, 0.0531, 40, -0.204004553231, 1.37882996018,
     {2.55875660396, -0.903118886091, 0.101771877942, -0.0242139751146}},
    {Q::shock_speed, 0.0531, 40, -0.214362789151, 1.35034249993,
     {-0.144615443471, -0.650507560471, 0.291320654009, 0.307916322787,
     -0.183361123489, -0.197740454538, 0.0909119559768, 0.0898926178054,
     -0.0287370990248, -0.0248730221702, 0.00496311705671, 0.00372242076361,
     -0.0003533736952, -0.0002292913709}},
    {Q::arrival, 0.0531, 40, -0.253273111999, 1.37407043777, {0.0720707787637,
     1.36456871214, -0.0570035692784, -0.182832224796, 0.0118851436014,
     0.0432648687627, -0.0007997367834, -0.00436073555033}},
    {Q::duration, 0.147, 0.888, 2.26367268496, 5.11588554305, {-0.686608550419,
     0.164953518069, 0.127788499497, 0.00291430135946, 0.00187957449227,
     0.0173413962543, 0.00269739758043, -0.00361976502798, -0.00100926577934}},
    {Q::duration, 0.888, 2.28, -1.33361206714, 9.2996288611, {0.23031841078,
     -0.0297944268969, 0.0306329542941, 0.0183405574074, -0.0173964666286,
     -0.00106321963576, 0.0056206003128, 0.0001618217499, -0.0006860188944}},
    {Q::duration, 2.28, 40, -3.13005805346, 3.1524725364, {0.621036276475,
     0.0967031995552, -0.00801302059667, 0.00482705779732, 0.00187587272287,
     -0.00246738509321, -0.000841116668, 0.0006193291052}}}},
  {"hemispherical", true, {
    {Q::overpressure, 0.0674, 40, -0.214362789151, 1.35034249993,
     {2.78076916577, -1.6958988741, -0.154159376846, 0.514060730593,
     0.0988534365274, -0.293912623038, -0.0268112345019, 0.109097496421,
     0.00162846756311, -0.0214631030242, 0.0001456723382, 0.00167847752266}},
    {Q::impulse, 0.0674, 0.955, 2.06761908721, 3.0760329666, {2.52455620925,
     -0.502992763686, 0.171335645235, 0.0450176963051, -0.0118964626402}},
    {Q::impulse, 0.955, 40, -1.94708846747, 2.40697745406, {1.67281645863,
     -0.384519026965, -0.0260816706301, 0.00595798753822, 0.014544526107,
     -0.00663289334734, -0.00284189327204, 0.0013644816227}},
    {Q::reflected_overpressure, 0.0674, 40, -0.240657322658, 1.36637719229,
     {3.40283217581, -2.21030870597, -0.218536586295, 0.895319589372,
     0.24989009775, -0.569249436807, -0.11791682383, 0.224131161411,
     0.0245620259375, -0.0455116002694, -0.00190930738887, 0.00361471193389}},
    {Q::reflected_impulse, 0.0674, 40, -0.246208804814, 1.33422049854,
     {2.70588058103, -0.949516092853, 0.112136118689, -0.0250659183287}},
    {Q::shock_speed, 0.0674, 40, -0.202425716178, 1.37784223635,
     {-0.06621072854, -0.698029762594, 0.158916781906, 0.443812098136,
     -0.113402023921, -0.369887075049, 0.129230567449, 0.19857981197,
     -0.0867636217397, -0.0620391900135, 0.0307482926566, 0.0102657234407,
     -0.00546533250772, -0.000693180974, 0.0003847494916}},
    {Q::arrival, 0.0674, 40, -0.202425716178, 1.37784223635, {-0.0591634288046,
     1.35706496258, 0.052492798645, -0.196563954086, -0.0601770052288,
     0.0696360270891, 0.0215297490092, -0.0161658930785, -0.00232531970294,
     0.00147752067524}},
    {Q::duration, 0.178, 1.01, 1.92946154068, 5.25099193925, {-0.614227603559,
     0.130143717675, 0.134872511954, 0.0391574276906, -0.00475933664702,
     -0.00428144598008}},
    {Q::duration, 1.01, 2.78, -2.12492525216, 9.2996288611, {0.315409245784,
     -0.0297944268976, 0.030632954288, 0.0183405574086, -0.0173964666211,
     -0.00106321963633, 0.00562060030977, 0.0001618217499, -0.0006860188944}},
    {Q::duration, 2.78, 40, -3.53626218091, 3.46349745571, {0.686906642409,
     0.0933035304009, -0.0005849420883, -0.00226884995013, -0.00295908591505,
     0.00148029868929}}}},
  {"swisdak", false, {
    {Q::arrival, 0.06, 1.5, 0., 1., {-0.7604, 1.8058, 0.1257, -0.0437, -0.0310,
     -0.00669}},
    {Q::arrival, 1.5, 40, 0., 1., {-0.7137, 1.5732, 0.5561, -0.4213, 0.1054,
     -0.00929}},
    {Q::overpressure, 0.2, 2.9, 0., 1., {7.2106, -2.1069, -0.3229, 0.1117,
     0.0685}},
    {Q::overpressure, 2.9, 23.8, 0., 1., {7.5938, -3.0523, 0.40977, 0.0261,
     -0.01267}},
    {Q::overpressure, 23.8, 198.5, 0., 1., {6.0536, -1.4066}},
    {Q::reflected_overpressure, 0.06, 2, 0., 1., {9.006, -2.6893, -0.6295,
     0.1011, 0.29255, 0.13505, 0.019736}},
    {Q::reflected_overpressure, 2, 40, 0., 1., {8.8396, -1.733, -2.64, 2.293,
     -0.8232, 0.14247, -0.0099}},
    {Q::duration, 0.2, 1.02, 0., 1., {0.5426, 3.2299, -1.5931, -5.9667, -4.0815,
     -0.9149}},
    {Q::duration, 1.02, 2.8, 0., 1., {0.5440, 2.7082, -9.7354, 14.3425, -9.7791,
     2.8535}},
    {Q::duration, 2.8, 40, 0., 1., {-2.4608, 7.1639, -5.6215, 2.2711, -0.44994,
     0.03486}},
    {Q::impulse, 0.2, 0.96, 0., 1., {5.522, 1.117, 0.6, -0.292, -0.087}},
    {Q::impulse, 0.96, 2.38, 0., 1., {5.465, -0.308, -1.464, 1.362, -0.432}},
    {Q::impulse, 2.38, 33.7, 0., 1., {5.2749, -0.4677, -0.2499, 0.0588,
     -0.00554}},
    {Q::impulse, 33.7, 158.7, 0., 1., {5.9825, -1.062}},
    {Q::reflected_impulse, 0.06, 40, 0., 1., {6.7853, -1.3466, 0.101, -0.01123}},
    {Q::shock_speed, 0.06, 1.5, 0., 1., {0.1794, -0.956, -0.0866, 0.109, 0.0699,
     0.01218}},
    {Q::shock_speed, 1.5, 40, 0., 1., {0.2597, -1.326, 0.3767, 0.0396, -0.0351,
     0.00432}}}}};
// clang-format on


namespace
{
  /// Factor from the table's unit to SI.
  double unit(const BlastQuantity quantity)
  {
    switch (quantity)
    {
      case BlastQuantity::overpressure:
      case BlastQuantity::reflected_overpressure:
      case BlastQuantity::shock_speed:
        return 1e3;
      case BlastQuantity::arrival:
      case BlastQuantity::duration:
        return 1e-3;
      default:
        return 1.;
    }
  }

  /// Whether a quantity at a given scaled distance grows with the charge.
  bool is_scaled(const BlastQuantity quantity)
  {
    return quantity == BlastQuantity::impulse ||
           quantity == BlastQuantity::reflected_impulse ||
           quantity == BlastQuantity::arrival ||
           quantity == BlastQuantity::duration;
  }
} // namespace


KingeryBulmash::KingeryBulmash(const std::string &set, const double mass)
  : scaling_length_(std::cbrt(mass))
{
  const auto found = std::find_if(
    tables.begin(), tables.end(), [&](const Set &s) { return s.name == set; });
  if (found == tables.end())
    throw InputError("there is no set of blast tables \"" + set + "\"" +
                     suggestion(set, sets));
  if (!(mass > 0.) || !std::isfinite(mass))
    throw InputError("the mass of TNT must be above 0 kg, not " + brief(mass) +
                     " kg");
  set_ = &*found;
}


const KingeryBulmash::Piece *KingeryBulmash::find(const BlastQuantity quantity,
                                                  const double distance) const
{
  const double scaled = distance / scaling_length_;
  for (const Piece &piece : set_->pieces)
    if (piece.quantity == quantity && scaled >= piece.smallest &&
        scaled <= piece.largest)
      return &piece;
  return nullptr;
}


bool KingeryBulmash::covers(const BlastQuantity quantity,
                            const double distance) const
{
  return find(quantity, distance) != nullptr;
}


double KingeryBulmash::value(const BlastQuantity quantity,
                             const double distance) const
{
  const Piece *piece = find(quantity, distance);
  if (piece == nullptr)
    throw InputError(
      "the blast tables have no figure at a scaled distance of " +
      brief(distance / scaling_length_) + " m/kg^(1/3)");
  const double z = distance / scaling_length_;
  const double u =
    piece->shift +
    piece->factor * (set_->is_decimal ? std::log10(z) : std::log(z));
  double sum = 0.;
  for (auto c = piece->coefficients.rbegin(); c != piece->coefficients.rend();
       ++c)
    sum = sum * u + *c;
  return (set_->is_decimal ? std::pow(10., sum) : std::exp(sum)) *
         unit(quantity) * (is_scaled(quantity) ? scaling_length_ : 1.);
}
} // namespace contrecoup
