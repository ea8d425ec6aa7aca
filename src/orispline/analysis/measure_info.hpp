// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/analysis/comparison.hpp>
#include <orispline/base/decimal.hpp>
#include <orispline/fields/quantity.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What measures that are times are told by.
struct MeasureTimes {
  Decimal epoch{};                      ///< [s], exact: what the times of the curve count from
  std::span<const double> recording{};  ///< [s], of the recording, from the epoch
};

/// What a measure is about, and with that when there is one.
enum class MeasureGroup {
  distance,   ///< to the orientations of a recording
  rate,       ///< to its angular velocities, where they are logged
  leave_out,  ///< to keys that were left out, where that is asked for
  shape,      ///< how smooth the curve is
  optimum,    ///< how much smoother a curve through these keys can be
  torque,     ///< that it takes, where the inertia is known
  cost,       ///< to make it and to sample it
};

/// A measure of a curve as it is shown. Tables, CSV, JSON and pages are made from these.
struct MeasureInfo {
  MeasureGroup group = MeasureGroup::distance;
  std::string_view id{};       ///< with the unit, in words that a program reads: `rms_deg`
  std::string_view word{};     ///< that methods are sorted by; empty: not for sorting
  std::string_view heading{};  ///< with the unit, in a table for people; empty: not there
  int digits = 4;              ///< significant ones, there
  int rank = 0;                ///< there: where there is no room for all, those of the highest rank are left out first
  std::string_view label{}, unit{};
  std::string_view explanation{};  ///< one sentence
  Better better = Better::less;
  int finite_from = 0;       ///< the order of continuity that it wants: ∫|α|² of a curve whose ω jumps is infinite
  std::string_view order{};  ///< its letter where it is an order of continuity: C0, C1, … or G0, G1, …; else empty
  bool is_time = false;      ///< a moment, told by MeasureTimes
  double rounding = 0.0;     ///< in the unit: values that are not larger are rounding errors, 0 for people
  std::optional<double> (*value)(const Measures&, const MeasureTimes&) = nullptr;  ///< in the unit; absent: not taken

  /// Whether the value is that of the whole curve.
  [[nodiscard]] bool is_finite(const Measures& measures) const noexcept {
    return measures.continuity.order() >= finite_from;
  }
};

/// All measures. THE list of them.
[[nodiscard]] ORISPLINE_EXPORT std::span<const MeasureInfo> measures_info() noexcept;

/// The one that methods are sorted by under that word. Error (bad_argument): there is none, with the one that is near.
[[nodiscard]] ORISPLINE_EXPORT Expected<MeasureInfo> measure_of_word(std::string_view word);

/// Those of some groups, in the order of the list.
[[nodiscard]] ORISPLINE_EXPORT std::vector<MeasureInfo> measures_of(std::span<const MeasureGroup> groups);
[[nodiscard]] ORISPLINE_EXPORT std::vector<MeasureInfo> measures_of(std::initializer_list<MeasureGroup> groups);

}}  // namespace orispline
