// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/base/expected.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A part of a curve between two times of its own [s] in which it does not stop; or a rest, whose length is 0.
struct EvenStretch {
  double from, to;
  double before;  ///< the length of all that comes before it
  double length;

  [[nodiscard]] bool is_rest() const noexcept { return !(length > 0.0); }
};

/// What a motion may go along evenly, by the angle [rad] or by the distance [m]: stretches and rests, one after the
/// other. A curve stops where it stays for a time, and where it turns back: its direction changes there within a
/// length that is too sharp a bend.
class EvenPath {
 public:
  /// `sharp_bend`: its length [rad] or [m]; less than what passes for a rest is always too sharp.
  /// Errors (bad_argument): no motion of that kind, a corner, or a step in which only the motion
  /// of the other kind goes on, which would take no time.
  [[nodiscard]] static Expected<EvenPath> by_angle(const PoseCurve& curve, double sharp_bend);
  /// Precondition: there are positions.
  [[nodiscard]] static Expected<EvenPath> by_distance(const PoseCurve& curve, double sharp_bend);

  [[nodiscard]] const std::vector<EvenStretch>& stretches() const noexcept { return stretches_; }
  /// The curve's own time [s] at a length from the start of a stretch.
  [[nodiscard]] double time_at(const EvenStretch& stretch, double length) const;
  /// The length from the start of a stretch to a time of it [s].
  [[nodiscard]] double length_at(const EvenStretch& stretch, double time) const;

 private:
  using Travelled = std::variant<AngleTravelled, DistanceTravelled>;
  EvenPath(Travelled travelled, std::vector<EvenStretch> stretches)
      : travelled_(std::move(travelled)), stretches_(std::move(stretches)) {}

  template <class C>
  [[nodiscard]] static Expected<EvenPath> along(const C& curve, const PoseCurve& pose, double sharp_bend);

  Travelled travelled_;
  std::vector<EvenStretch> stretches_;
};

}}  // namespace orispline
