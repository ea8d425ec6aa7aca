// SPDX-License-Identifier: Apache-2.0
#include "values.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/fields/typed_numbers.hpp>
#include <orispline/files.hpp>
#include <orispline/math/euler.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "errors.hpp"
#include "json_text.hpp"
#include "keys.hpp"
#include "options.hpp"
#include "written.hpp"

namespace orispline::c { namespace {

using SharedTrack = std::shared_ptr<const Track>;
using SharedGyro = std::shared_ptr<const GyroTrack>;
using SharedMotion = std::shared_ptr<const jobs::MotionFile>;
using Stated = io::StatedOptions;

/// More rates than that have no room in memory.
constexpr std::size_t most_rates = std::numeric_limits<std::size_t>::max() / (4 * sizeof(double));

auto of_option(std::string_view name) {
  return [name](Error error) {
    error.code = ErrorCode::bad_argument;
    error.option = name;
    return error;
  };
}

/// Error (bad_argument): an option that is none of these.
template <std::size_t Count>
Expected<void> check_names(const Stated& stated, const std::array<std::string_view, Count>& known) {
  for (const auto& [name, text] : stated)
    if (std::ranges::find(known, name) == known.end()) return bad_option(name, unknown_word("option", name, known));
  return {};
}

Expected<Value> rates_of(std::span<const double> times, const double* rates, const char* epoch) {
  GyroTrack gyro;
  if (epoch) {
    auto zero = Decimal::parse(epoch).map_error(of_option("epoch"));
    if (!zero) return tl::unexpected(std::move(zero.error()));
    gyro.epoch = *zero;
  }
  gyro.rates.clock = GyroRates::Clock::own;
  gyro.rates.times.assign(times.begin(), times.end());
  gyro.rates.rates.reserve(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) gyro.rates.rates.emplace_back(rates + 3 * k);
  return Value{std::make_shared<const GyroTrack>(std::move(gyro))};
}

Value skeleton_of(scenes::Scene scene) {
  const scenes::SceneFormat& format = *scene.format;
  jobs::MotionFile motion{.name = scene.name,
                          .skeleton = std::exchange(scene.skeleton, {}),
                          .clips = std::exchange(scene.clips, {}),
                          .has_no_unit = format.has_no_unit,
                          .format = format.file,
                          .title = format.title,
                          .is_single_precise = format.holds_floats};
  return {std::make_shared<const jobs::MotionFile>(std::move(motion)),
          std::make_shared<const scenes::Scene>(std::move(scene))};
}

Expected<Value> read_skeleton(std::string name, std::string bytes, const Stated& stated) {
  io::Reading reading;
  return check_names(stated, std::array<std::string_view, 2>{"clip", "drop_duplicates"})
      .and_then([&] { return io::take_options(reading, stated); })
      .and_then([&] {
        return scenes::read_scene(io::Input::in_memory(std::move(name), std::move(bytes)),
                                  {.drop_duplicates = reading.options.drop_duplicates});
      })
      .and_then([&](scenes::Scene scene) { return scenes::with_clips(std::move(scene), reading.options.scene.clips); })
      .map(skeleton_of);
}

Expected<scenes::SceneWriting> writing_in(const Stated& stated) {
  scenes::SceneWriting writing;
  if (auto known = check_names(stated, std::array<std::string_view, 2>{"output_euler", "rate"}); !known)
    return tl::unexpected(std::move(known.error()));
  for (const auto& [name, text] : stated) {
    if (name == "rate") {
      const auto rate = typed::positive(text).map_error(of_option(name));
      if (!rate) return tl::unexpected(rate.error());
      writing.rate = *rate;
      continue;
    }
    writing.euler = euler_order_of(text);
    if (!writing.euler || writing.euler->is_proper())
      return bad_option(name, formatted("found '{}', wanted three different axes, such as ZYX", text));
  }
  return writing;
}

Expected<Written> written(const Value& value, const std::string& name, const Stated& stated) {
  const auto* const motion = std::get_if<SharedMotion>(&value.value);
  if (!motion) return bad_option("value", "found no skeleton, wanted one");
  return writing_in(stated)
      .and_then([&](const scenes::SceneWriting& writing) {
        scenes::Scene scene = *value.file;
        scene.skeleton = (*motion)->skeleton;
        scene.clips = (*motion)->clips;
        return scenes::written_scene(scene, name, writing);
      })
      .map([](scenes::SceneWritten file) {
        return Written{std::move(file.bytes), std::move(file.warnings)};
      });
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
  const jobs::MotionFile& motion = *std::get<SharedMotion>(value.value);
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

orispline_code orispline_value_of_skeleton(const void* bytes, size_t size, const char* name, const char* const* options,
                                           size_t option_count, orispline_value** value, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(value, "value")
        .and_then([&] { return check_pointer(name, "name"); })
        .and_then([&] { return size == 0 ? Expected<void>() : check_pointer(bytes, "bytes"); })
        .and_then([&] { return stated_options(options, option_count, ""); })
        .and_then([&](const Stated& stated) {
          return read_skeleton(name, std::string(static_cast<const char*>(bytes), size), stated);
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

orispline_code orispline_value_write(const orispline_value* value, const char* name, const char* const* options,
                                     size_t option_count, char** bytes, size_t* size, char** warnings,
                                     orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    if (warnings) *warnings = nullptr;
    if (auto there = cleared(bytes, "bytes"); !there) return there;
    const auto body = checked(value);
    if (!body) return tl::unexpected(body.error());
    return check_pointer(size, "size")
        .and_then([&] { return check_pointer(name, "name"); })
        .and_then([&] { return stated_options(options, option_count, ""); })
        .and_then([&](const Stated& stated) { return written(**body, name, stated); })
        .map([&](const Written& file) { give(file, bytes, size, warnings); });
  });
}

void orispline_value_free(orispline_value* value) { free_handle(value); }
