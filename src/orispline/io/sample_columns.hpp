// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/orientation_form.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What a file of samples holds.
struct SampleColumns {
  const FormatInfo* format = &csv_format;
  OrientationForm form{};        ///< where the format holds others than quaternions
  bool positions = false;        ///< some formats always have them: zeros if there are none
  int derivatives = 0;           ///< highest order of the angular rates: 0 none, 1 ω, 2 and α, 3 and jerk
  int position_derivatives = 0;  ///< highest order of the rates of position: 0 none, 1 velocity, 2 and acceleration
  Frame frame = Frame::body;
  Turning turning = Turning::body_to_world;  ///< of the orientations; the names of body rates say so where it is not
  std::array<bool, inner_names.size()> inner{};  ///< inner quaternions of keys: of segments that leave, that arrive
  bool band = false;                             ///< a radius [rad] of where the true motion may be, behind the rates
  std::vector<std::string> settings{};           ///< columns of a method's parameters, behind all others
};

/// A moving body.
struct Sample {
  Motion motion{};
  LinearMotion linear_motion{};
  std::array<Eigen::Quaterniond, inner_names.size()> inner{};  ///< body to world
  std::span<const double> settings{};                          ///< one for each of the columns of settings
  double band = 0.0;                                           ///< [rad]; infinite: nothing is known
  std::optional<Eigen::Vector3d> angles{};  ///< of Euler [rad], where they are not those of the orientation alone
};

inline constexpr std::size_t most_settings = 12;  ///< columns of settings in a file

/// Error (bad_argument): what the format cannot hold.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_columns(const SampleColumns& columns);

/// An orientation, body to world, as a file of these columns has it.
[[nodiscard]] inline Eigen::Quaterniond written_orientation(const Eigen::Quaterniond& q, const SampleColumns& columns) {
  return columns.turning == Turning::body_to_world ? q : q.conjugate();
}

/// What stands before that many rows of a file of these columns.
[[nodiscard]] ORISPLINE_EXPORT std::string header_of(const SampleColumns& columns, std::size_t rows);

/// The names of the columns where a file may hold all: time, orientation, position, angular rates, rates of position,
/// inner quaternions, band, settings.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::string> column_names(const SampleColumns& columns);

/// The numbers of a row after its time.
class ORISPLINE_EXPORT RowNumbers {
 public:
  /// A matrix, a position, three and two rates, two inner quaternions, a band, settings.
  static constexpr std::size_t most = 9 + 3 + 9 + 6 + 8 + 1 + most_settings;

  void add(double value) noexcept { values_[count_++] = value; }
  void add(const Eigen::Vector3d& v) noexcept;

  [[nodiscard]] std::span<const double> values() const noexcept { return std::span(values_).first(count_); }
  /// A band may be infinite.
  void add_band(double value) noexcept;
  [[nodiscard]] bool are_finite() const noexcept;

 private:
  std::array<double, most> values_;
  std::size_t count_ = 0;
  std::size_t band_ = most;  ///< which of them is one
};

/// Those of a sample in the order of `column_names`.
[[nodiscard]] ORISPLINE_EXPORT RowNumbers named_numbers(const Sample& sample, const SampleColumns& columns);

}}}  // namespace orispline::io
