// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/curve/keyframe.hpp>

namespace orispline::cli {

/// One row of a bundled file.
struct DataRow {
  double t, qw, qx, qy, qz;
  double wx = 0.0, wy = 0.0, wz = 0.0;  ///< angular velocity [rad/s], body frame, of the true motion only
};

// The files of examples/data, as they were when the command was built.
[[nodiscard]] std::span<const DataRow> five_key_rows() noexcept;
[[nodiscard]] std::span<const DataRow> flight_key_rows() noexcept;
[[nodiscard]] std::span<const DataRow> flight_truth_rows() noexcept;

/// Keys from rows, with the rows' times.
[[nodiscard]] inline KeyframeData key_data(std::span<const DataRow> rows) {
  KeyframeData data;
  for (const DataRow& row : rows) {
    data.times.push_back(row.t);
    data.orientations.push_back(quaternion_wxyz(row.qw, row.qx, row.qy, row.qz));
  }
  return data;
}

inline constexpr auto five_keys_note =
    "The paper's keys are not published; these are the five of examples/data/five_keys.csv, at t = 0, 1, 2, 3, 4 s.";

/// The five keys of the pictures of docs/families, at times of their own.
[[nodiscard]] inline Expected<Keyframes> five_keys_at(std::vector<double> times) {
  KeyframeData data = key_data(five_key_rows());
  data.times = std::move(times);
  return Keyframes::make(std::move(data));
}

}  // namespace orispline::cli
