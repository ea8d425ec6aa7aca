// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>

#include <array>

#include <orispline/curve/motion.hpp>
#include <orispline/fields/field_codec.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
struct FieldCodec<LeaveOut> : PlainCodec<LeaveOut, bool, FieldType::flag> {};

template <>
std::span<const FieldInfo> fields_of<MeasureOptions>() noexcept {
  static constexpr std::array fields{
      field<&MeasureOptions::inertia>({.name = "inertia",
                                       .sentence = "Inertia of the body; with it the torques are measured too",
                                       .quantity = &quantities::inertia}),
      field<&MeasureOptions::leave_out>(
          {.name = "leave_out",
           .sentence = "Estimate the error from the keys alone as well, by leaving some of them out"}),
      field<&MeasureOptions::least_energy>(
          {.name = "least_energy",
           .sentence = "Tell how many times the least possible energy each curve has",
           .without = "Do not look for the least possible energy, which takes a quarter of a millisecond a key"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<Decimation>() noexcept {
  static constexpr std::array fields{
      field<&Decimation::keep_every>({.name = "keep_every",
                                      .sentence = "Keep every N-th sample as a key",
                                      .range = {1.0, std::numeric_limits<double>::infinity()}}),
      field<&Decimation::spacing>({.name = "spacing", .sentence = "How the samples that become keys are spaced"}),
      field<&Decimation::seed>(
          {.name = "seed", .sentence = "Seed of the random numbers; one seed picks the same samples on every machine"}),
  };
  return fields;
}

Expected<void> check(const MeasureOptions& options) {
  return checked_inertia(options.inertia).map([](const auto&) {});
}

}}  // namespace orispline
