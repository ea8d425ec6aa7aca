// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing_stretches.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far each sample of each stretch is from what all others predict, in standard deviations per axis of that
/// distance: without motion that the fit misses the length of a vector of three normal variables of variance 1.
///
/// Leaving one out of a linear smoother needs no other fit: with its value of the variance c and the sample's weight w
/// the others predict Q - r/(1 - h), h = w c, with the variance c/(1 - h) (Craven and Wahba 1979). `noise`: σ per axis
/// of samples, in their unit, which the weights may state too small. A sample that nothing can be said about has 0.
[[nodiscard]] std::vector<std::vector<double>> prediction_errors(const StretchProblems& problems,
                                                                 const StretchFits& fits,
                                                                 const SmoothingObjective& objective, double noise);

/// The samples that are far, by their errors. Of those in runs some are far beyond the others: outliers beside quick
/// motion, which are single at a higher threshold, are so here too.
[[nodiscard]] FarSamples far_candidates(const std::vector<std::vector<double>>& errors,
                                        const std::vector<Stretch>& stretches);

/// How far every sample is from what all others predict of it [rad], as prediction_errors(); 0 where rounding decides.
[[nodiscard]] std::vector<std::vector<double>> left_out_errors(const StretchProblems& problems, const StretchFits& fits,
                                                               const SmoothingObjective& objective);

/// What the neighbours say of samples that are far from what all others predict.
///
/// Those in `far.single` were left out of the fits of which the errors are. Such a sample is an outlier if it is far
/// from what the others predict, and they agree: the two nearest that count on either side are as near to what they
/// predict of each other as noise is, or many times nearer than the sample. Where they do not the motion is too quick
/// for the fit, and the sample goes to `in_runs`; so do the first and the last one of a stretch, which only one side
/// predicts.
[[nodiscard]] FarSamples judged(const FarSamples& far, const std::vector<std::vector<double>>& errors,
                                const std::vector<Stretch>& stretches);

/// What the rest of the recording says of outliers by their neighbours, beside a fit that follows the motion.
///
/// `motion`: samples that were far in runs beside another fit, which count as those in `far.in_runs` do. A sample is no
/// outlier where the motion does the like: where it is a third as far, and farther than noise, in half as many places
/// as single samples are, or in more. The sample goes to `in_runs` then.
[[nodiscard]] FarSamples outstanding(const FarSamples& far, const std::vector<std::size_t>& motion,
                                     const std::vector<std::vector<double>>& errors,
                                     const std::vector<Stretch>& stretches);

/// A sample farther than this from what the others predict, in standard deviations per axis, is far. Of normal ones
/// 15 in a million are.
inline constexpr double far_threshold = 5.0;

}}  // namespace orispline
