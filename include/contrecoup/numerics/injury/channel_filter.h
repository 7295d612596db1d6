// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <vector>

namespace contrecoup
{
/// Channel frequency class of the head's motion [Hz] (SAE J211/1, ISO 6487).
constexpr double head_channel_class = 1000.;

/**
 * Values after the low-pass filter of a channel frequency class (CFC): a
 * Butterworth filter of second order with the corner frequency 2.0775 CFC, run
 * forwards and backwards, which shifts no phase (SAE J211/1, 1995, appendix C).
 * The pair halves the power at 5/3 CFC; for CFC 1000 its gain is -0.45 dB at
 * 1000 Hz and -2.91 dB at 1650 Hz, where the norm allows -1 and -4 dB. Beyond
 * its ends the record is continued by its point reflection.
 *
 * @param values equally spaced
 * @param interval between them [s]
 * @param channel_class [Hz]
 * @throws InputError unless the interval is positive and shorter than the fifth
 * part of 1 / channel_class
 */
std::vector<double> channel_class_filter(const std::vector<double> &values,
                                         const double interval,
                                         const double channel_class);

/// History of a vector.
struct VectorHistory
{
  std::vector<double> times; ///< [s]
  std::vector<std::array<double, 3>> values;
};

/**
 * The same of a history, each component by itself. It is first interpolated
 * linearly to equal intervals: their mean, or a tenth of 1 / channel_class
 * where that is longer; one of more than 1e7 such intervals is returned as it
 * is.
 * @throws InputError for times that do not increase, less than two, or when
 * numbers of times and values differ
 */
VectorHistory channel_class_filter(const VectorHistory &history,
                                   const double channel_class);
} // namespace contrecoup
