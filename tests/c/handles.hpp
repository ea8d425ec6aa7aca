// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline.h>
#include <support/tracks.hpp>

// Handles of C that free themselves, and what most tests begin with.

namespace orispline::testing_support {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Handle, void (*Free)(Handle*)>
struct Freeing {
  void operator()(Handle* handle) const noexcept { Free(handle); }
};
template <class Handle, void (*Free)(Handle*)>
using Owned = std::unique_ptr<Handle, Freeing<Handle, Free>>;
using KeysHandle = Owned<orispline_keys, orispline_keys_free>;
using CurveHandle = Owned<orispline_curve, orispline_curve_free>;
using BakedHandle = Owned<orispline_baked, orispline_baked_free>;
using OutcomeHandle = Owned<orispline_outcome, orispline_outcome_free>;
using ErrorHandle = Owned<orispline_error, orispline_error_free>;

/// What a function of C gave: its code, and the error where there was one.
struct Result {
  orispline_code code = ORISPLINE_OK;
  ErrorHandle error{};

  [[nodiscard]] std::string option() const { return orispline_error_option(error.get()); }
  [[nodiscard]] std::string message() const { return orispline_error_message(error.get()); }
  [[nodiscard]] std::string text() const { return orispline_error_text(error.get()); }
};

/// Calls a function of C with the error behind its other arguments.
template <class Function, class... Arguments>
Result call(Function function, Arguments... arguments) {
  orispline_error* error = nullptr;
  const orispline_code code = function(arguments..., &error);
  EXPECT_EQ(code, orispline_error_code(error));
  return {code, ErrorHandle(error)};
}

inline void expect_ok(const Result& result) { EXPECT_EQ(result.code, ORISPLINE_OK) << result.text(); }

/// A text that a function of C made, behind its other arguments.
template <class Function, class... Arguments>
std::string text_by(Function function, Arguments... arguments) {
  char* text = nullptr;
  expect_ok(call(function, arguments..., &text));
  const Owned<char, orispline_text_free> owned(text);
  return text ? text : "";
}

inline std::vector<double> flat(const std::vector<Eigen::Quaterniond>& rows, orispline_order order) {
  std::vector<double> numbers;
  for (const Eigen::Quaterniond& q : rows)
    if (order == ORISPLINE_WXYZ) numbers.insert(numbers.end(), {q.w(), q.x(), q.y(), q.z()});
    else numbers.insert(numbers.end(), {q.x(), q.y(), q.z(), q.w()});
  return numbers;
}
inline std::vector<double> flat(const std::vector<Eigen::Vector3d>& rows) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& v : rows) numbers.insert(numbers.end(), v.begin(), v.end());
  return numbers;
}

inline orispline_column column(const char* name, const std::vector<double>& numbers) {
  return {name, numbers.data(), numbers.size()};
}

/// Keys of these data, with their positions and more columns.
inline KeysHandle keys_of(const KeyframeData& data, std::vector<orispline_column> columns = {},
                          orispline_order order = ORISPLINE_WXYZ) {
  const std::vector<double> orientations = flat(data.orientations, order), positions = flat(data.positions);
  if (!positions.empty()) columns.push_back(column("positions", positions));
  orispline_keys* keys = nullptr;
  expect_ok(call(orispline_keys_make, data.times.data(), orientations.data(), data.times.size(), order,
                 ORISPLINE_AS_GIVEN, columns.data(), columns.size(), &keys));
  return KeysHandle(keys);
}

inline CurveHandle curve_through(const KeysHandle& keys, const char* method) {
  orispline_curve* curve = nullptr;
  expect_ok(call(orispline_curve_make, static_cast<const orispline_keys*>(keys.get()), method, &curve));
  return CurveHandle(curve);
}

/// A time [s] at which the curve moves.
inline double within(const KeyframeData& data) { return 0.7 * data.times[1] + 0.3 * data.times[2]; }

inline KeyframeData walk(std::size_t count = 12) { return posed_walk(42, count, Spacing::uneven, 0.6); }

}  // namespace orispline::testing_support
