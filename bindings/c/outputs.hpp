// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <orispline/curve/extrapolation.hpp>

#include "handles.hpp"

// Where samples go, as C states it.

namespace orispline::c {

/// Outputs that were checked.
using Outputs = std::span<const orispline_output>;

/// Numbers of a sample.
[[nodiscard]] constexpr std::size_t width_of(orispline_quantity quantity) noexcept {
  return quantity == ORISPLINE_ORIENTATION ? 4 : 3;
}
[[nodiscard]] constexpr std::size_t stride_of(const orispline_output& output) noexcept {
  return output.stride == 0 ? width_of(output.quantity) : output.stride;
}
[[nodiscard]] constexpr bool is_of_world(orispline_quantity quantity) noexcept {
  return quantity >= ORISPLINE_ANGULAR_VELOCITY_WORLD && quantity <= ORISPLINE_ANGULAR_JERK_WORLD;
}
[[nodiscard]] constexpr bool is_of_position(orispline_quantity quantity) noexcept {
  return quantity >= ORISPLINE_POSITION;
}

/// Error (bad_argument): another one than those that there are.
[[nodiscard]] Expected<void> check_type(orispline_type type);

/// The outputs. Errors (bad_argument): a null pointer, a quantity or a type that there is not, a stride that is too
/// short, more samples than memory can hold, an order that is none where there are orientations.
[[nodiscard]] Expected<Outputs> outputs_in(const orispline_output* outputs, std::size_t output_count,
                                           orispline_order order, std::size_t samples);

/// What stands for it; null: hold. Error (bad_argument).
[[nodiscard]] Expected<Extrapolation> extrapolation_named(const char* beyond);

/// Error (bad_argument): times that are not finite, or go back.
[[nodiscard]] Expected<void> check_even(double start, double step);

/// Times, even or given.
class Times {
 public:
  Times(double start, double step, std::size_t count) : start_(start), step_(step), count_(count) {}
  explicit Times(std::span<const double> given) : given_(given), count_(given.size()) {}

  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] double operator[](std::size_t k) const noexcept {
    return given_.empty() ? static_cast<double>(k) * step_ + start_ : given_[k];
  }
  /// So many of them; `room` is for those that are not given.
  [[nodiscard]] std::span<const double> part(std::size_t begin, std::size_t count, std::vector<double>& room) const {
    if (!given_.empty()) return given_.subspan(begin, count);
    room.resize(count);
    for (std::size_t k = 0; k < count; ++k) room[k] = (*this)[begin + k];
    return room;
  }

 private:
  std::span<const double> given_{};
  double start_ = 0.0, step_ = 0.0;
  std::size_t count_;
};

}  // namespace orispline::c
