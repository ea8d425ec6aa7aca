// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include <orispline/families/auto_rates.hpp>
#include <orispline/families/model_weights.hpp>
#include <orispline/families/motion_models.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Fewer keys have no window.
inline constexpr std::size_t least_window = window_keys;

/// Linear maps of the increments in a window that depend on its times alone: what the models make of them, and the
/// polynomials through the nearest seven and nine keys.
struct WindowMaps {
  ModelMaps models;
  std::array<double, window_keys> miss7, miss9, first9, second9;
};

/// The nine nearest keys of each key of a track, gone through from the first to the last.
class KeyWindows {
 public:
  /// `interval` is the unit of time of the models [s].
  KeyWindows(const Keyframes& keys, Through through, double interval);

  /// Makes key i, which is the next one, the one that is asked about.
  void go_to(std::size_t i);

  [[nodiscard]] AutoRates& along() noexcept { return along_; }
  /// How far the window is to be trusted: 0 across gaps and large turns.
  [[nodiscard]] double trust() const noexcept { return trust_; }
  /// How smooth the motion is: over the seven keys of `auto`, and over the nine of a trusted window.
  [[nodiscard]] double smooth() const noexcept { return smooth_; }
  [[nodiscard]] double smooth9() const noexcept { return smooth9_; }
  /// Of the key, where the window is trusted.
  [[nodiscard]] const WindowMaps& maps();
  /// How far the key is from its prediction by each model, along the axes of its frame.
  [[nodiscard]] std::array<PerModel, 3> model_misses();
  /// The squares of these, and those of the polynomials.
  [[nodiscard]] KeyMisses misses();
  /// The increments to the keys, times these factors.
  [[nodiscard]] Eigen::Vector3d applied(const std::array<double, window_keys>& factors) const;

 private:
  [[nodiscard]] double trust_of_window() const;

  std::span<const double> times_;
  AutoRates along_;
  double interval_;
  std::size_t key_ = 0, first_ = 0;  ///< the key, and the first of its window
  double trust_ = 0.0, smooth_ = 0.0, smooth9_ = 0.0;
  std::array<Eigen::Vector3d, window_keys> increments_;
  bool has_maps_ = false, is_even_ = false;
  WindowTimes window_{};
  WindowMaps maps_;
  std::optional<WindowMaps> even_;  ///< of keys an interval apart, which many tracks consist of
};

/// The times of nine keys from number `first` on, seen from key i, in intervals. Where they are even but for the
/// rounding of the times they are even.
[[nodiscard]] WindowTimes window_times(std::span<const double> times, std::size_t first, std::size_t i,
                                       double interval);

}}}  // namespace orispline::families
