// SPDX-License-Identifier: Apache-2.0
#include "outputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <orispline/base/formatted.hpp>

#include "keys.hpp"

namespace orispline::c {

namespace {

/// What one object of memory may have at most [bytes].
constexpr std::size_t most_bytes = std::numeric_limits<std::ptrdiff_t>::max();

Expected<void> check_output(const orispline_output& output, orispline_order order) {
  if (output.quantity < ORISPLINE_ORIENTATION || output.quantity > ORISPLINE_ACCELERATION)
    return bad_option("quantity", formatted("found {}, wanted an orispline_quantity", output.quantity));
  if (auto fits = check_type(output.type); !fits) return fits;
  if (stride_of(output) < width_of(output.quantity))
    return bad_option("stride",
                      formatted("found {}, wanted 0 or at least {}", output.stride, width_of(output.quantity)));
  if (output.quantity == ORISPLINE_ORIENTATION) return check_order(order);
  return {};
}

Expected<void> check_room(const orispline_output& output, std::size_t samples) {
  if (samples == 0) return {};
  const std::size_t each = output.type == ORISPLINE_DOUBLE ? sizeof(double) : sizeof(float);
  if (stride_of(output) <= most_bytes / each / samples) return check_pointer(output.numbers, "numbers");
  return bad_option("count", formatted("found {} samples of a stride of {}, wanted so few that memory can hold them",
                                       samples, stride_of(output)));
}

}  // namespace

Expected<void> check_type(orispline_type type) {
  if (type == ORISPLINE_DOUBLE || type == ORISPLINE_FLOAT) return {};
  return bad_option("type", formatted("found {}, wanted ORISPLINE_DOUBLE or ORISPLINE_FLOAT", type));
}

Expected<Outputs> outputs_in(const orispline_output* outputs, std::size_t output_count, orispline_order order,
                             std::size_t samples) {
  if (output_count == 0) return Outputs();
  if (auto there = check_pointer(outputs, "outputs"); !there) return tl::unexpected(std::move(there.error()));
  for (const orispline_output& output : Outputs(outputs, output_count)) {
    auto fits = check_output(output, order).and_then([&] { return check_room(output, samples); });
    if (!fits) return tl::unexpected(std::move(fits.error()));
  }
  return Outputs(outputs, output_count);
}

Expected<Extrapolation> extrapolation_named(const char* beyond) {
  if (!beyond) return Extrapolation::hold;
  const auto vocabulary = std::span<const Word>(words<Extrapolation>);
  const auto found = std::ranges::find(vocabulary, std::string_view(beyond), &Word::word);
  if (found != vocabulary.end()) return static_cast<Extrapolation>(found->value);
  return bad_option("beyond", formatted("found '{}', wanted {}", beyond, one_of(vocabulary)));
}

Expected<void> check_even(double start, double step) {
  if (!std::isfinite(start)) return bad_option("start", formatted("found {}, wanted a time [s]", start));
  if (!std::isfinite(step) || step < 0.0)
    return bad_option("step", formatted("found {}, wanted a time [s], 0 at least", step));
  return {};
}

}  // namespace orispline::c
