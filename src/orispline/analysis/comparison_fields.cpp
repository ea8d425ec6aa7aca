// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/comparison_fields.hpp>

#include <array>

#include <orispline/analysis/torque.hpp>
#include <orispline/fields/field_codec.hpp>

namespace orispline::inline ORISPLINE_ABI {

template <>
struct FieldCodec<LeaveOut> : PlainCodec<LeaveOut, bool, FieldType::flag> {};

template <>
std::span<const FieldInfo> fields_of<MeasureOptions>() noexcept {
  static constexpr std::array fields{
      field<&MeasureOptions::inertia>({.name = "inertia",
                                       .sentence = "Inertia of the body, whose torques are measured too",
                                       .quantity = &quantities::inertia}),
      field<&MeasureOptions::leave_out>(
          {.name = "leave_out", .sentence = "Estimate the error also from keys that are left out"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<Decimation>() noexcept {
  static constexpr std::array fields{
      field<&Decimation::keep_every>({.name = "keep_every",
                                      .sentence = "Keep every N-th sample as a key",
                                      .range = {1.0, std::numeric_limits<double>::infinity()}}),
      field<&Decimation::spacing>({.name = "spacing", .sentence = "How the samples are spaced that stay"}),
      field<&Decimation::seed>(
          {.name = "seed", .sentence = "Seed of what is random; the same samples on every machine"}),
  };
  return fields;
}

Expected<void> check(const MeasureOptions& options) {
  return checked_inertia(options.inertia).map([](const auto&) {});
}

}  // namespace orispline::inline ORISPLINE_ABI
