// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_search.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_outliers.hpp>
#include <orispline/smooth/varying_lambda.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double huber_threshold = 2.5, tukey_threshold = 6.0;  // in units of σ
constexpr double tolerance_to_find_outliers = 1e-2;             // of the iteration, in units of σ

}  // namespace

tl::unexpected<Error> no_end_found() {
  return failure(ErrorCode::not_converged,
                 "no smooth motion was found: the iteration did not come to an end, wanted another smoothing time or "
                 "another noise");
}

SmoothingSearch::SmoothingSearch(StretchProblems problems, const std::vector<Stretch>& stretches,
                                 const SearchPlan& plan, OpenEndedWork& work)
    : plan_(plan),
      stretches_(stretches),
      problems_(std::move(problems)),
      objective_{.penalty = plan.penalty,
                 .loss = plan.loss == Loss::l2 ? LossFunction::l2 : LossFunction::huber,
                 .threshold = huber_threshold,
                 .work = &work} {}

Expected<void> SmoothingSearch::run() {
  const bool rejects = plan_.loss == Loss::robust || plan_.loss == Loss::tukey;
  fit(rejects ? roughly() : SmoothingIteration{});
  if (objective_.stopped()) return cancellation();
  if (rejects)
    if (auto done = plan_.loss == Loss::robust ? fit_without_outliers() : fit_with_tukey(); !done) return done;
  adapt();
  if (plan_.loss == Loss::tukey) note_given_up();
  return check();
}

double SmoothingSearch::smoothing_time() const {
  return smoothing_time_of(objective_.lambda, plan_.penalty, plan_.noise, plan_.interval);
}

std::vector<double> SmoothingSearch::smoothing_times() const {
  std::vector<double> times;
  for (const SmoothingProblem& problem : problems_) {
    if (problem.relative_lambdas.empty()) return {};
    for (std::size_t i = 0; i < problem.size(); ++i) {
      const double before = problem.relative_lambda(i == 0 ? 0 : i - 1),
                   after = problem.relative_lambda(std::min(i, problem.size() - 2));
      times.push_back(
          smoothing_time_of(objective_.lambda * std::sqrt(before * after), plan_.penalty, plan_.noise, plan_.interval));
    }
  }
  return times;
}

/// As well as finding outliers takes.
SmoothingIteration SmoothingSearch::roughly() const { return {.tolerance = tolerance_to_find_outliers * plan_.noise}; }

/// With λ as stated or chosen anew, from the present fit if there is one.
void SmoothingSearch::fit(const SmoothingIteration& iteration) {
  set_lambda(plan_.criterion);
  refit(iteration);
}

/// As the smoothing time states it, else by the criterion.
void SmoothingSearch::set_lambda(SmoothingCriterion criterion) {
  if (plan_.smoothing_time)
    objective_.lambda = lambda_of(*plan_.smoothing_time, plan_.penalty, plan_.noise, plan_.interval);
  else choose(criterion);
}

void SmoothingSearch::choose(SmoothingCriterion criterion) {
  const auto near = finding_.criterion == criterion ? std::optional(smoothing_time()) : std::nullopt;
  const ChosenLambda chosen = chosen_lambda(problems_, {}, objective_, criterion, plan_.noise, plan_.interval, near);
  objective_.lambda = chosen.choice.lambda;
  finding_.criterion = criterion;
  finding_.edge = chosen.choice.edge;
  finding_.chosen_on = chosen.times;
}

/// Where hardly any noise was found the samples are followed as they are. What one λ finds no end for is refused, and
/// from there a varying one would look for it in vain many times as long.
void SmoothingSearch::adapt() {
  if (!plan_.adapt || !finding_.criterion || finding_.edge == LambdaChoice::Edge::shortest) return;
  if (!converged(fits_, plan_.noise)) return;
  adapt_lambda(problems_, objective_, fits_, *finding_.criterion, plan_.noise, plan_.interval);
}

void SmoothingSearch::refit(const SmoothingIteration& iteration) {
  fits_ = fit_stretches(problems_, objective_, iteration, fits_);
}

/// From Huber's fit, whose τ single outliers must not choose; all samples may count again.
Expected<void> SmoothingSearch::fit_with_tukey() {
  if (auto found = find_outliers(Beside::huber); !found) return found;
  fit(roughly());
  if (objective_.stopped()) return cancellation();
  finding_.rejected.clear();
  finding_.retained_outlier_runs.clear();
  readmit(problems_, plan_.noise);
  objective_.loss = LossFunction::tukey;
  objective_.threshold = tukey_threshold;
  refit();
  return objective_.stopped() ? cancellation() : Expected<void>();
}

void SmoothingSearch::note_given_up() {
  for (std::size_t k = 0; k < stretches_.size(); ++k)
    for (std::size_t i = 0; i < stretches_[k].count; ++i)
      if (fits_.fits[k].loss_weights[i] == 0.0) finding_.rejected.push_back(stretches_[k].first + i);
}

/// The first search is beside Huber's fit, which outliers pull little but which lags behind strikes; the second one
/// beside a fit whose τ was chosen without outliers and with the strikes.
Expected<void> SmoothingSearch::fit_without_outliers() {
  objective_.loss = LossFunction::l2;
  for (const Beside beside : {Beside::huber, Beside::motion}) {
    const auto before = finding_.rejected;
    if (auto found = find_outliers(beside); !found) return found;
    const bool is_last = beside == Beside::motion;
    if (is_last && finding_.rejected == before) refit();
    else fit(is_last ? SmoothingIteration{} : roughly());
    if (objective_.stopped()) return cancellation();
  }
  return {};
}

/// Leaves out what is far, and takes back what the neighbours do not call an outlier, nor the rest of the recording.
Expected<void> SmoothingSearch::find_outliers(Beside beside) {
  const double noise = std::max(plan_.noise, noise_of_most());
  const auto errors = [&] { return prediction_errors(problems_, fits_, objective_, noise); };
  const FarSamples candidates = far_candidates(errors(), stretches_);
  if (objective_.stopped()) return cancellation();
  readmit(problems_, plan_.noise);
  auto far = reject(problems_, stretches_, candidates, plan_.penalty);
  if (!far) return tl::unexpected(std::move(far.error()));
  if (!far->single.empty()) {
    refit(roughly());
    if (objective_.stopped()) return cancellation();
    const auto without = errors();
    far = judged(*far, without, stretches_);
    if (beside == Beside::motion) far = outstanding(*far, finding_.retained_outlier_runs, without, stretches_);
    readmit(problems_, plan_.noise);
    if (far = reject(problems_, stretches_, *far, plan_.penalty); !far) return tl::unexpected(std::move(far.error()));
  }
  finding_.rejected = std::move(far->single);
  finding_.retained_outlier_runs = std::move(far->in_runs);
  return {};
}

template <class Take>
void SmoothingSearch::for_each_residual(Take take) const {
  for (std::size_t k = 0; k < problems_.size(); ++k)
    for (std::size_t i = 0; i < problems_[k].size(); ++i)
      take(Eigen::Vector3d(std::sqrt(problems_[k].share(i)) * fits_.fits[k].residuals[i]));
}

/// Whether the iteration ended by itself, and whether the loss is one of outliers only.
Expected<void> SmoothingSearch::check() const {
  if (objective_.stopped()) return cancellation();
  if (!converged(fits_, plan_.noise)) return no_end_found();
  std::size_t faults = plan_.loss == Loss::robust ? finding_.rejected.size() : 0, all = 0;
  for_each_residual([&](const Eigen::Vector3d& r) {
    ++all;
    if (r.norm() > far_threshold * plan_.noise) ++faults;
  });
  if (2 * faults <= all || plan_.loss == Loss::l2) return {};
  return failure(ErrorCode::bad_data,
                 formatted("{} of {} samples are farther than 5 σ from the best motion, σ = {:.3g}{}, wanted a larger "
                           "noise, a shorter smoothing time, or the loss l2, which has no outliers",
                           faults, all, plan_.noise * plan_.unit_size, plan_.unit));
}

SmoothingSearch::Freedom SmoothingSearch::freedom() const {
  const auto count = static_cast<double>(observations(problems_));
  const double trace = hat_trace(problems_, fits_, plan_.penalty, objective_.lambda);
  return {trace, std::max(0.0, count - trace), count};
}

/// σ of the residuals, of which outliers are few; where one direction has most of it, as a vehicle's plane or the axis
/// of a heading, in that one.
double SmoothingSearch::noise_of_most() const {
  std::vector<Eigen::Vector3d> residuals;
  std::vector<double> lengths;
  for_each_residual([&](const Eigen::Vector3d& r) {
    residuals.push_back(r);
    lengths.push_back(r.norm());
  });
  const Freedom of = freedom();
  if (!(of.rest > 0.0)) return 0.0;
  return std::max(median(std::move(lengths)) / median_length, lopsided_deviation(residuals)) /
         std::sqrt(of.rest / of.observations);
}

double SmoothingSearch::residual_noise() const {
  const Freedom of = freedom();
  return of.rest > 0.0 ? plan_.noise * std::sqrt(fits_.data() / (3.0 * of.rest)) : 0.0;
}

NodeSigmas SmoothingSearch::sigmas(double noise) const {
  const double ratio = noise / plan_.noise;
  NodeSigmas all = sigmas_of(problems_, objective_, fits_);
  for (Eigen::Vector3d& sigma : all.orientations) sigma *= ratio;
  for (Eigen::Vector3d& sigma : all.angular_velocities) sigma *= ratio;
  for (auto& within : all.to_next)
    for (double& sigma : within) sigma *= ratio;
  return all;
}

}}  // namespace orispline
