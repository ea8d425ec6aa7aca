// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <orispline/families/beta.hpp>
#include <orispline/families/beta_g2.hpp>
#include <orispline/tune/moving_betas.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using families::BetaG2;
using families::betas_of;

/// The published curve, and the same corrected: segment i has the auxiliary points i … i + 3, which are keys, and its
/// correction those of the segment before as well.
class LocalBetas final : public Construction {
 public:
  LocalBetas(const FamilyInfo& family, const Keyframes& keys, std::vector<Variable> list)
      : family_(family), keys_(keys), list_(std::move(list)) {
    for (std::size_t i = 0; i + 3 < keys.size(); ++i) {
      variables_.emplace_back();
      for (std::size_t v = 0; v < list_.size(); ++v)
        if (first_key(i) <= list_[v].key && list_[v].key <= i + 3) variables_.back().push_back(v);
    }
  }
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& variables() const noexcept override { return variables_; }

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto settings = settle(family_, options, keys_.size());
    if (!settings) return std::nullopt;
    const Betas betas = betas_of(*settings, keys_.size());
    const auto shape = beta_shape(family_.name, betas.beta1, betas.beta2);
    if (!shape) return std::nullopt;
    ConstructedCurve curve{beta_segments(keys_.orientations(), *shape, keys_.times().subspan(1)), {}};
    for (std::size_t i = 1; corrected() && i < curve.segments.size(); ++i)
      curve.segments[i].correction = families::lacking_acceleration<double>(
          curve.segments[i - 1].increments, curve.segments[i].increments, betas.beta1[i + 1], betas.beta2[i + 1]);
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (work && work->stopped()) return std::nullopt;
      curve.slopes.emplace_back();
      for (const std::size_t v : variables_[i]) curve.slopes.back().push_back(slope(betas, i, v));
    }
    return curve;
  }

 private:
  [[nodiscard]] bool corrected() const noexcept { return family_.name == BetaG2::info.name; }
  [[nodiscard]] std::size_t first_key(std::size_t segment) const noexcept {
    return corrected() && segment > 0 ? segment - 1 : segment;
  }

  [[nodiscard]] SegmentSlope slope(const Betas& betas, std::size_t i, std::size_t v) const {
    const std::size_t first = first_key(i), count = i + 4 - first;
    const MovingPoints points = still_points(keys_.orientations().subspan(first, count));
    const MovingBetas moving = along(window(betas, first, count), list_[v], first);
    const BetaShapeOver<Slope> shape = shape_of(moving);
    const BetaSegment<Slope> segment = beta_segment<Slope>(points, shape, i + 1 - first);
    SegmentSlope slope = slope_of(segment);
    if (corrected() && i > 0)
      slope.correction = slope_part(families::lacking_acceleration<Slope>(
          beta_segment<Slope>(points, shape, 1).increments, segment.increments, moving.beta1[2], moving.beta2[2]));
    return slope;
  }

  const FamilyInfo& family_;
  const Keyframes& keys_;
  std::vector<Variable> list_;
  std::vector<std::vector<std::size_t>> variables_;
};

}  // namespace

std::unique_ptr<Construction> beta_construction(const Keyframes& keys, const FamilySettings&,
                                                const std::vector<Variable>& variables) {
  return std::make_unique<LocalBetas>(families::Beta::info, keys, variables);
}

std::unique_ptr<Construction> beta_g2_construction(const Keyframes& keys, const FamilySettings& settings,
                                                   const std::vector<Variable>& variables) {
  if (BetaG2::is_global(settings)) return beta_g2_global_construction(keys, settings, variables);
  return std::make_unique<LocalBetas>(BetaG2::info, keys, variables);
}

}}  // namespace orispline
