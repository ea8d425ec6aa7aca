// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include <orispline/tune/construction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What constructions that solve equations over all keys have in common: each variable reaches all segments.
class SolvedConstruction : public Construction {
 public:
  SolvedConstruction(const Keyframes& keys, std::vector<Variable> list)
      : keys_(keys), list_(std::move(list)), variables_(variables_in_reach(list_, keys.size() - 1)) {}
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& variables() const noexcept override { return variables_; }

 protected:
  [[nodiscard]] const Keyframes& keys() const noexcept { return keys_; }

  /// With the slopes that `along(variable)` gives as a function of the segment.
  template <class Along>
  [[nodiscard]] std::optional<ConstructedCurve> with_slopes(std::vector<TensionSegment> segments,
                                                            const OpenEndedWork* work, Along along) const {
    ConstructedCurve curve{std::move(segments), std::vector<std::vector<SegmentSlope>>(variables_.size())};
    for (std::size_t v = 0; v < list_.size(); ++v) {
      if (work && work->stopped()) return std::nullopt;
      const auto slope_at = along(list_[v]);
      for (std::size_t i = 0; i < variables_.size(); ++i)
        if (!variables_[i].empty() && variables_[i].front() <= v && v <= variables_[i].back())
          curve.slopes[i].push_back(slope_at(i));
    }
    return curve;
  }

 private:
  const Keyframes& keys_;
  std::vector<Variable> list_;
  std::vector<std::vector<std::size_t>> variables_;
};

}}  // namespace orispline
