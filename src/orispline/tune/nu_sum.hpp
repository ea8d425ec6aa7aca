// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/tune/least_squares.hpp>
#include <orispline/tune/segment_residuals.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// An objective as a function of the ν of a curve of the family `nu`: one block per segment.
///
/// All control orientations depend on every ν; how, the implicit function theorem says. The influence falls by about
/// 0.27 per key; beyond `reach` keys it is left out of the derivatives, not of the values.
class NuSum final : public SumOfSquares {
 public:
  static constexpr std::size_t reach = 20;

  NuSum(const Keyframes& keys, const TensionModel& model, const Goal& goal, const OpenEndedWork* work = nullptr);

  void move_to(const std::vector<double>& values) override;
  [[nodiscard]] std::size_t blocks() const noexcept override { return variables_.size(); }
  [[nodiscard]] std::span<const std::size_t> variables(std::size_t block) const override { return variables_[block]; }
  [[nodiscard]] std::size_t residual_count(std::size_t block) const override;
  [[nodiscard]] Eigen::VectorXd residuals(std::size_t block) const override;
  [[nodiscard]] Eigen::MatrixXd jacobian(std::size_t block) const override;

 private:
  const Keyframes& keys_;
  const TensionModel& model_;
  const Goal& goal_;
  std::vector<std::vector<std::size_t>> variables_;
  std::vector<TensionSegment> segments_;         ///< empty where there is no curve
  std::vector<std::vector<Increments>> slopes_;  ///< of every segment by its variables
};

/// The ν of all keys but the two ends, where they have no influence. Errors: those of make_curve().
[[nodiscard]] Expected<TensionModel> nu_model(const Keyframes& keys, const CurveOptions& options);

}  // namespace orispline::inline ORISPLINE_ABI
