// SPDX-License-Identifier: Apache-2.0
#include "values.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/fields/warning_json.hpp>

#include "errors.hpp"
#include "json_text.hpp"
#include "keys.hpp"

namespace orispline::c { namespace {

using SharedTrack = std::shared_ptr<const Track>;
using SharedGyro = std::shared_ptr<const GyroTrack>;
using SharedMotion = std::shared_ptr<const MotionFile>;

/// More rates than that have no room in memory.
constexpr std::size_t most_rates = std::numeric_limits<std::size_t>::max() / (4 * sizeof(double));

Expected<Value> rates_of(std::span<const double> times, const double* rates, const char* epoch) {
  GyroTrack gyro;
  if (epoch) {
    const auto zero = Decimal::parse(epoch);
    if (!zero) return bad_option("epoch", zero.error().message);
    gyro.epoch = *zero;
  }
  gyro.rates.clock = GyroRates::Clock::own;
  gyro.rates.times.assign(times.begin(), times.end());
  gyro.rates.rates.reserve(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) gyro.rates.rates.emplace_back(rates + 3 * k);
  return Value{std::make_shared<const GyroTrack>(std::move(gyro))};
}

template <class List>
Json names_of(const List& named) {
  Json names = Json::array();
  for (const auto& one : named) names.push_back(one.name);
  return names;
}

Json json_of(const Value& value) {
  if (const auto* const track = std::get_if<SharedTrack>(&value.value))
    return {{"kind", "keys"},
            {"count", (*track)->keys.size()},
            {"name", (*track)->name},
            {"epoch", (*track)->epoch.to_string()}};
  if (const auto* const gyro = std::get_if<SharedGyro>(&value.value))
    return {{"kind", "rates"}, {"count", (*gyro)->rates.times.size()}, {"epoch", (*gyro)->epoch.to_string()}};
  const MotionFile& motion = *std::get<SharedMotion>(value.value);
  return {{"kind", "skeleton"},
          {"count", motion.clips.size()},
          {"name", motion.name},
          {"format", value.file->format->id},
          {"joints", names_of(motion.skeleton.joints())},
          {"clips", names_of(motion.clips)},
          {"warnings", warnings_json(value.file->warnings)}};
}

std::size_t count_of(const Value& value) {
  if (const auto* const track = std::get_if<SharedTrack>(&value.value)) return (*track)->keys.size();
  if (const auto* const gyro = std::get_if<SharedGyro>(&value.value)) return (*gyro)->rates.times.size();
  return std::get<SharedMotion>(value.value)->clips.size();
}

Expected<void> copy_rates(const GyroTrack& gyro, double* times, double* rates, std::size_t count) {
  const GyroRates& all = gyro.rates;
  if (count != all.times.size())
    return bad_option("count", formatted("found {}, wanted {}, as many as rates", count, all.times.size()));
  std::ranges::copy(all.times, times);
  for (const Eigen::Vector3d& rate : all.rates) rates = std::ranges::copy(rate, rates).out;
  return {};
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_value_of_keys(const orispline_keys* keys, orispline_value** value, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(value, "value").and_then([&] { return checked(keys); }).map([&](const Keys* body) {
      *value = handle_of<orispline_value>({body->track});
    });
  });
}

orispline_code orispline_value_of_rates(const double* times, const double* rates, size_t count, const char* epoch,
                                        orispline_value** value, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(value, "value")
        .and_then([&]() -> Expected<void> {
          if (count > most_rates) return bad_option("count", formatted("found {} rates, wanted fewer", count));
          if (count == 0) return {};
          return check_pointer(times, "times").and_then([&] { return check_pointer(rates, "rates"); });
        })
        .and_then([&] {
          return rates_of({times, count}, rates, epoch);
        })
        .map([&](Value made) { *value = handle_of<orispline_value>(std::move(made)); });
  });
}

orispline_kind orispline_value_kind(const orispline_value* value) {
  const Value* const body = body_of(value);
  return body ? static_cast<orispline_kind>(body->value.index()) + ORISPLINE_KEYS : 0;
}

size_t orispline_value_count(const orispline_value* value) {
  const Value* const body = body_of(value);
  return body ? count_of(*body) : 0;
}

orispline_code orispline_value_json(const orispline_value* value, char** json, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(json, "json").and_then([&] { return checked(value); }).map([&](const Value* body) {
      *json = text_of_c(json_text(json_of(*body)));
    });
  });
}

orispline_code orispline_value_keys(const orispline_value* value, orispline_keys** keys, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(keys, "keys")
        .and_then([&] { return checked(value); })
        .and_then([&](const Value* body) -> Expected<void> {
          const auto* const track = std::get_if<SharedTrack>(&body->value);
          if (!track) return bad_option("value", "found no keys, wanted some");
          *keys = handle_of<orispline_keys>({*track});
          return {};
        });
  });
}

orispline_code orispline_value_rates(const orispline_value* value, double* times, double* rates, size_t count,
                                     orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    const auto body = checked(value);
    if (!body) return tl::unexpected(body.error());
    const auto* const gyro = std::get_if<SharedGyro>(&(*body)->value);
    if (!gyro) return bad_option("value", "found no rates of a gyro, wanted some");
    return check_pointer(times, "times").and_then([&] { return check_pointer(rates, "rates"); }).and_then([&] {
      return copy_rates(**gyro, times, rates, count);
    });
  });
}

void orispline_value_free(orispline_value* value) { free_handle(value); }
