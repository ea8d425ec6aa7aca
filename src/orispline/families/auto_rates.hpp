// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/window.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Smooth switch: 0 up to `low`, 1 from `high` on.
[[nodiscard]] double switched(double x, double low, double high) noexcept;

/// How smooth five keys are: 1 for a cubic, 0 for a kick or alternating noise.
[[nodiscard]] double smooth_share(double roughness) noexcept;

/// Share of a wide window whose larger side turns by `turn` [rad]: logarithms must stay well inside a full turn.
[[nodiscard]] double window_share(double turn) noexcept;

/// From 0 to 1 where intervals differ by a ratio of 5 to 15.
[[nodiscard]] double gap_of(double step_ratio) noexcept;

/// The intervals beside a key: their lengths [s] and secants.
struct Beside {
  double before, after;
  Eigen::Vector3d d_before, d_after;
};

/// The rates whose quintics stay nearest to the two geodesics beside a key, in the mean square.
[[nodiscard]] WindowRates geodesic_rates(const Beside& beside) noexcept;

/// Which points of the keys a curve goes through.
enum class Through { orientations, positions };

/// Rates at the keys of a track by the steps (1) to (4) of docs/families/auto.md, asked for key after key, from the
/// first to the last. What several keys need, the increments between near keys above all, is found once and kept while
/// it is near.
class AutoRates {
 public:
  /// `reach` keys on either side of a window: 3 for auto, 2 for auto5. Increments are kept to `kept` keys on, 4 at
  /// most.
  AutoRates(const Keyframes& keys, Through through, std::size_t reach, std::size_t kept);

  /// The body rests between keys that are no farther apart [rad], [m]; nowhere where that is less than 0.
  void rest_within(double longest) noexcept { longest_rest_ = longest; }

  /// The polynomial is believed only where it foretells keys better than the natural spline does: step (2) of auto.
  void guard() noexcept { guarded_ = true; }

  /// Makes key i, which is the next one, the one that is asked about.
  void go_to(std::size_t i);

  /// Of key i; the polynomial has that share of its usual one.
  [[nodiscard]] WindowRates rates(std::size_t i, double belief = 1.0) const;

  /// From key i to the next.
  [[nodiscard]] const Eigen::Vector3d& step_from(std::size_t i) const { return known(i).to[0]; }
  /// From key i to key j; the increment back is the opposite one.
  [[nodiscard]] Eigen::Vector3d increment(std::size_t i, std::size_t j) const;
  /// Keys that have two on either side; beyond the ends of the track the nearest such key is meant.
  struct Stretch {
    std::size_t first, last;
  };
  /// Those whose five nearest keys lie in the shifted window of key i.
  [[nodiscard]] Stretch stretch_of(std::size_t i) const;
  /// The largest roughness in a stretch; 1 for fewer than five keys. Keys that hardly bend beside those of the other
  /// stretch count as smooth: of such small bends the least noise decides how rough they are.
  [[nodiscard]] double roughness(const Stretch& of, const Stretch& beside) const;
  /// The larger turn on one side of key i within the shifted window of that reach [rad].
  [[nodiscard]] double turn_beside(std::size_t i, std::size_t reach) const;

 private:
  static constexpr std::size_t ahead = 9;    ///< the keys of a window may be those that follow
  static constexpr std::size_t places = 32;  ///< at least twice as many

  /// How five keys bend.
  struct Bends {
    double roughness;  ///< how far they are from a cubic: 0 for one, 1 for a kick or alternating noise
    double size;       ///< how far keys must move to bend so [rad], or [m]
  };
  struct Key {
    std::array<Eigen::Vector3d, 4> to;  ///< increments to the next keys
    double turn;                        ///< to the next one [rad]
    Bends bends;                        ///< of the five keys whose last is this one
  };

  [[nodiscard]] std::size_t size() const { return times_.size(); }
  [[nodiscard]] double step(std::size_t i) const { return times_[i + 1] - times_[i]; }
  [[nodiscard]] Eigen::Vector3d secant(std::size_t i) const { return known(i).to[0] / step(i); }
  [[nodiscard]] const Key& known(std::size_t i) const { return keys_[i % places]; }
  [[nodiscard]] Eigen::Vector3d found(std::size_t i, std::size_t j) const;
  [[nodiscard]] bool rests_after(std::size_t i) const;
  void find(std::size_t i);
  [[nodiscard]] auto increments() const {
    return [this](std::size_t i, std::size_t j) { return increment(i, j); };
  }
  [[nodiscard]] Window window(std::size_t centre, std::size_t first, std::size_t count) const;
  [[nodiscard]] Window cut_window(std::size_t centre, std::size_t reach) const;
  [[nodiscard]] static Bends bends_of(const Window& window);
  [[nodiscard]] const Bends& bends(std::size_t i) const;
  [[nodiscard]] WindowRates mixed_rates(std::size_t i, std::size_t reach, double smooth) const;
  [[nodiscard]] WindowRates windowed_rates(std::size_t i, double belief) const;

  std::span<const double> times_;
  std::span<const Eigen::Quaterniond> orientations_;  ///< empty where positions are asked about
  std::span<const Eigen::Vector3d> positions_;
  std::size_t reach_, kept_;
  double longest_rest_ = -1.0;
  bool guarded_ = false;
  std::array<Key, places> keys_;
  std::size_t found_ = 0;  ///< keys whose increments are known
};

/// The rates of each key, asked for in turn after `along` has gone to it.
using RatesAt = std::function<WindowRates(std::size_t key)>;

/// (5) A quintic in the chart of each segment's middle.
[[nodiscard]] ChartCurve<5> quintics_through(const Keyframes& keys, AutoRates& along, const RatesAt& rates_at);

/// In space, which needs no chart, the Hermite quintic.
[[nodiscard]] HermitePath<5> quintic_path_through(const Keyframes& keys, AutoRates& along, const RatesAt& rates_at);

}}}  // namespace orispline::families
