// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing_stretches.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a recording is smoothed, whatever it is one of.
struct SearchPlan {
  Penalty penalty{};
  Loss loss{};
  SmoothingCriterion criterion{};          ///< by which τ is chosen
  std::optional<double> smoothing_time{};  ///< τ [s], where it is stated
  double noise = 1.0;                      ///< σ per axis that the weights stand for, in the unit of the samples
  double interval = 0.0;                   ///< median one [s]
  bool adapt = false;                      ///< let λ vary in time, where τ is chosen
  std::string_view unit{};                 ///< of people, as it stands behind a number
  double unit_size = 1.0;                  ///< the samples' unit in that of people
};

/// Error (not_converged): the iteration did not come to an end.
[[nodiscard]] tl::unexpected<Error> no_end_found();

/// The smooth motion of all stretches: first λ as stated or chosen, then the outliers, then λ again.
class SmoothingSearch {
 public:
  /// What was found beside the fit.
  struct Finding {
    std::vector<std::size_t> rejected{}, retained_outlier_runs{};  ///< indices into the recording
    std::optional<SmoothingCriterion> criterion{};                 ///< by which τ was chosen; absent: as stated
    LambdaChoice::Edge edge = LambdaChoice::Edge::none;
    std::size_t chosen_on = 0;  ///< times that the choice of τ saw
  };

  /// What of the data the curve takes up, per axis, and what is left to tell the noise: trace + rest = observations.
  struct Freedom {
    double trace, rest, observations;
  };

  /// Every sample of the problems has the weight of the noise.
  SmoothingSearch(StretchProblems problems, const std::vector<Stretch>& stretches, const SearchPlan& plan,
                  OpenEndedWork& work);

  /// Errors: bad_data where too few samples are left beside the outliers or most are outliers; not_converged;
  /// cancelled.
  [[nodiscard]] Expected<void> run();

  [[nodiscard]] const StretchFits& fits() const noexcept { return fits_; }
  [[nodiscard]] const Finding& finding() const noexcept { return finding_; }
  [[nodiscard]] const StretchProblems& problems() const noexcept { return problems_; }
  [[nodiscard]] const SmoothingObjective& objective() const noexcept { return objective_; }
  [[nodiscard]] double lambda() const noexcept { return objective_.lambda; }
  [[nodiscard]] double smoothing_time() const;
  /// τ at the nodes of all stretches [s], where λ varies; else empty.
  [[nodiscard]] std::vector<double> smoothing_times() const;
  [[nodiscard]] Freedom freedom() const;
  /// σ per axis of the residuals, in the unit of the samples.
  [[nodiscard]] double residual_noise() const;
  /// Standard deviations at the nodes of all stretches, where samples have that σ per axis.
  [[nodiscard]] NodeSigmas sigmas(double noise) const;

 private:
  /// The fit beside which outliers are looked for: Huber's lags behind strikes, one by squares does not.
  enum class Beside { huber, motion };

  [[nodiscard]] SmoothingIteration roughly() const;
  void fit(const SmoothingIteration& iteration = {});
  void set_lambda(SmoothingCriterion criterion);
  void choose(SmoothingCriterion criterion);
  void adapt();
  void refit(const SmoothingIteration& iteration = {});
  [[nodiscard]] Expected<void> fit_with_tukey();
  void note_given_up();
  [[nodiscard]] Expected<void> fit_without_outliers();
  [[nodiscard]] Expected<void> find_outliers(Beside beside);
  [[nodiscard]] Expected<void> check() const;
  [[nodiscard]] double noise_of_most() const;
  /// Calls `take` with every residual in units of the σ of its sample, times that of a usual one.
  template <class Take>
  void for_each_residual(Take take) const;

  SearchPlan plan_;
  const std::vector<Stretch>& stretches_;
  StretchProblems problems_;
  SmoothingObjective objective_;
  StretchFits fits_;
  Finding finding_;
};

}}  // namespace orispline
