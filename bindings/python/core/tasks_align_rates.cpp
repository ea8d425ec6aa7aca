// SPDX-License-Identifier: Apache-2.0
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <orispline/jobs.hpp>

#include "errors.hpp"
#include "interruption.hpp"
#include "tasks.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using jobs::RateAlignOutcome;

/// The recording of a gyro.
struct Gyro {
  std::shared_ptr<const GyroTrack> track;
};
using KeysOrGyro = std::variant<Keys, Gyro>;

/// Seconds since the epoch, which is exact.
Gyro gyro_of(const Numbers& times, const Rows3& rates, const std::string& epoch, bool is_dated) {
  const std::span<const double> seconds = span_of(times);
  GyroTrack track{.epoch = value_of(Decimal::parse(epoch)), .is_dated = is_dated};
  track.rates.times = {seconds.begin(), seconds.end()};
  track.rates.rates = rows_of<Eigen::Vector3d>(rates);
  track.rates.clock = GyroRates::Clock::own;
  return {std::make_shared<const GyroTrack>(std::move(track))};
}

jobs::Recording recording_of(const KeysOrGyro& one) {
  if (const Keys* const keys = std::get_if<Keys>(&one)) return keys->track;
  return std::get<Gyro>(one).track;
}

RateAlignOutcome rate_alignment_of(const KeysOrGyro& moved, const KeysOrGyro& fixed, const nb::dict& stated) {
  jobs::RateAlignRequest request{
      .moved = recording_of(moved), .fixed = recording_of(fixed), .options = options_in<AlignOptions>(stated)};
  return value_of(
      interruptible([&](const Progress& progress) { return jobs::align_rates(std::move(request), progress); }));
}

nb::dict attributes_of_rate_alignment(const RateAlignOutcome& outcome) {
  const RateAlignment& alignment = outcome.alignment;
  nb::dict attributes = attributes_of(alignment);
  attributes["body"] = numbers_of(alignment.body);
  nb::list open;
  for (const OpenRateDirection& one : alignment.open)
    open.append(nb::make_tuple(numbers_of(one.body), one.offset, numbers_of(one.bias)));
  attributes["open"] = open;
  return attributes;
}

std::optional<Keys> aligned_keys(const RateAlignOutcome& outcome) {
  const Track* const keys = std::get_if<Track>(&outcome.aligned);
  return keys ? std::optional(shared(*keys)) : std::nullopt;
}

/// Times since the epoch of the fixed recording, and rates.
std::optional<std::pair<FloatArray, FloatArray>> aligned_rates(const RateAlignOutcome& outcome) {
  const GyroTrack* const gyro = std::get_if<GyroTrack>(&outcome.aligned);
  if (!gyro) return std::nullopt;
  const auto& times = gyro->rates.times;
  const auto& rates = gyro->rates.rates;
  return std::pair{array_of(times.data(), times.size(), 0), array_of(rates.front().data(), rates.size(), 3)};
}

}  // namespace

void add_align_rates(nb::module_& module) {
  nb::class_<Gyro>(module, "Gyro").def(nb::new_(&gyro_of), "times"_a, "rates"_a, "epoch"_a, "is_dated"_a);
  auto outcome_class = nb::class_<RateAlignOutcome>(module, "RateAlignment");
  outcome_class.def_prop_ro("keys", &aligned_keys)
      .def_prop_ro("rates", &aligned_rates)
      .def("attributes", &attributes_of_rate_alignment);
  add_words(outcome_class);
  module.def("align_rates", &rate_alignment_of, "moved"_a, "fixed"_a, "options"_a);
}

}  // namespace orispline::python
