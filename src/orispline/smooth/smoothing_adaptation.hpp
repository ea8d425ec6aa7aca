// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing_choice.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Lets λ vary within the stretches of a recording where that predicts the samples clearly better than one λ.
///
/// `problems`: whose relative λ are set, with the geometric mean 1 over all intervals, or left as they are where one λ
/// serves as well. `objective`: its λ is the one chosen for all, and becomes the mean one. `fits`: those with that λ,
/// and then the new ones. `criterion`: GCV or UBRE. `noise` and `interval`: as of lambda_of().
///
/// log λ is a LogLambdaCurve with about one knot for each degree of freedom of the curve with one λ, found by the
/// restricted likelihood; its mean is chosen anew by the criterion, which also decides whether it is taken: first a
/// stiff one, then softer ones, each only if the criterion falls clearly. Linear time.
void adapt_lambda(StretchProblems& problems, SmoothingObjective& objective, StretchFits& fits,
                  SmoothingCriterion criterion, double noise, double interval);

}}  // namespace orispline
