// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <orispline/analysis.hpp>
#include <orispline/axes.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "files.hpp"
#include "keys.hpp"
#include "method_text.hpp"
#include "text.hpp"

using namespace nanobind::literals;

namespace orispline::python {

namespace {

Keys shared(Track track) { return {std::make_shared<const Track>(std::move(track))}; }

/// The keys at rising indices, with the signs that they have.
Keys keys_at(const Keys& keys, const std::vector<std::size_t>& indices) {
  const Track& track = *keys.track;
  Keyframes some = value_of(Keyframes::make(kept_keys(track.keys.data(), indices), Signs::as_given));
  Track part = track.at(indices);
  if (track.recipe.signs == Signs::as_given) part.keys = std::move(some);
  part.recipe.signs = track.recipe.signs;
  part.recipe.gap = track.recipe.gap;
  part.recipe.jumps = track.recipe.jumps;
  return shared(std::move(part));
}

std::vector<double> flat(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& v : vectors) numbers.insert(numbers.end(), v.begin(), v.end());
  return numbers;
}

/// What keys have beside their numbers: where they are from, for pickle.
nb::tuple origin_of(const Keys& keys) {
  const Track& track = *keys.track;
  std::string exact_times;
  for (const Decimal& time : track.exact_times) exact_times += time.to_string() + "\n";
  const auto* const as_read = track.as_read.empty() ? nullptr : track.as_read.front().coeffs().data();
  return nb::make_tuple(track.name, track.epoch.to_string(), track.lines, exact_times,
                        as_read ? nb::object(array_of(as_read, track.as_read.size(), 4)) : nb::object(nb::none()),
                        track.recipe.method, track.recipe.signs == Signs::as_given, track.recipe.line, track.is_dated,
                        track.recipe.blending ? io::blending_json(*track.recipe.blending) : "", track.recipe.gap,
                        track.positions_apart.times, flat(track.positions_apart.positions),
                        track.recipe.jumps || track.keys.data().jumps);
}

std::vector<Decimal> decimals_in(std::string_view lines) {
  std::vector<Decimal> decimals;
  for (std::size_t end = lines.find('\n'); end != std::string_view::npos; end = lines.find('\n')) {
    decimals.push_back(value_of(Decimal::parse(lines.substr(0, end))));
    lines.remove_prefix(end + 1);
  }
  return decimals;
}

Keys from(const Keys& keys, const std::string& name, const std::string& epoch, const std::vector<std::uint32_t>& lines,
          const std::string& exact_times, const std::optional<Rows4>& as_read, const std::string& method,
          bool signs_as_given, std::size_t line, bool is_dated, const std::string& blending, std::optional<double> gap,
          const std::vector<double>& times_apart, const std::vector<double>& positions_apart, bool jumps) {
  Track track = *keys.track;
  track.name = name;
  track.epoch = value_of(Decimal::parse(epoch));
  track.is_dated = is_dated;
  track.lines = lines;
  track.exact_times = decimals_in(exact_times);
  if (as_read) track.as_read = rows_of<Eigen::Quaterniond>(*as_read);
  track.recipe = {.method = method, .signs = signs_as_given ? Signs::as_given : Signs::shortest, .line = line};
  if (!blending.empty())
    track.recipe.blending = std::make_shared<const BlendingData>(value_of(io::blending_from_json(blending)));
  track.recipe.gap = gap;
  track.recipe.jumps = jumps;
  track.positions_apart.times = times_apart;
  for (std::size_t i = 0; i + 2 < positions_apart.size(); i += 3)
    track.positions_apart.positions.emplace_back(Eigen::Map<const Eigen::Vector3d>(&positions_apart[i]));
  return shared(std::move(track));
}

/// Keys whose times count from there; `is_dated`: which are seconds since 1970.
Keys since(const Keys& keys, const std::string& epoch, bool is_dated) {
  Track track = *keys.track;
  track.epoch = value_of(Decimal::parse(epoch));
  track.is_dated = is_dated;
  return shared(std::move(track));
}

/// Of an error, whose options are called after the sides where keys are turned.
Error by_side(Error error) {
  for (std::string* const name : {&error.option, &error.remedy})
    if (*name == "world_axes" || *name == "body_axes") *name = name->substr(0, name->find('_'));
  if (const std::string other = std::exchange(error.remedy, {}); !other.empty())
    error.message += " (" + other + "=\"FROM:TO\" changes it there too)";
  return error;
}

/// Keys in the frames that options of reading state.
Keys in_axes(const Keys& keys, const io::StatedOptions& stated) {
  auto turned = in_frames(*keys.track, frames_of(stated));
  if (!turned) raise(by_side(std::move(turned.error())));
  return shared(std::move(*turned));
}

/// Keys of arrays, as options of reading would have those of a file: turned back, in their frames, with their gaps.
Keys as_read(const Keys& keys, const io::StatedOptions& stated) {
  io::Reading reading;
  auto track = io::take_options(reading, stated)
                   .and_then([&] { return io::check_frames(reading.options); })
                   .and_then([&] {
                     KeyframeData data = keys.track->keys.data();
                     if (reading.options.conjugate) data = conjugated(std::move(data));
                     if (reading.options.inverse_poses) data = inverted(std::move(data));
                     return Keyframes::make(std::move(data), keys.track->recipe.signs);
                   })
                   .and_then([&](const Keyframes& turned) {
                     return in_frames(keys.track->with_keys(turned), reading.options.frames);
                   });
  if (!track) raise(in_words(std::move(track.error())));
  if (reading.options.gap) track->recipe.gap = reading.options.gap;
  return shared(std::move(*track));
}

/// The rows that recordings begin with among those of these times, and whether sorting would mix them.
nb::tuple sessions_of(const Numbers& times) {
  std::vector<Decimal> exact;
  for (const double t : span_of(times)) exact.push_back(Decimal::from_double(t));
  const auto starts = io::session_starts(exact);
  return nb::make_tuple(starts, !io::may_be_sorted(exact.size(), starts.size()));
}

/// The method that the keys are for, `otherwise` where the file names none, but for what these names say otherwise and
/// with these rules for its ends.
MethodText method_for(const Keys& keys, const std::vector<std::string>& names, const std::string& otherwise,
                      const std::optional<std::string>& ends) {
  const Track& track = *keys.track;
  auto stated = method_of(track.recipe, track.name);
  if (!stated) raise(in_words(stated.error()));
  Method method = *stated ? std::move(**stated) : value_of(method_from_text(otherwise));
  method = without(std::move(method), names);
  return MethodText::of(ends ? value_of(with_ends(std::move(method), *ends)) : method);
}

/// What is to be said where keys of one method's curve are used for another.
nb::list set_aside(const Keys& keys, const MethodText& method) {
  return told(value_of(jobs::chosen_method(method.method(), *keys.track, {})).warnings);
}

nb::object spread_of(const std::optional<Spread>& spread) {
  if (!spread) return nb::none();
  return nb::make_tuple(spread->smallest, spread->median, spread->largest, spread->largest_at);
}

nb::tuple statistics_of(const Keys& keys) {
  const KeyStatistics statistics = key_statistics(keys.track->keys);
  return nb::make_tuple(statistics.span, spread_of(statistics.spacing), spread_of(statistics.step),
                        statistics.near_half_turns);
}

}  // namespace

FrameChange frames_of(const io::StatedOptions& stated) {
  io::Reading reading;
  if (auto taken = io::take_options(reading, stated); !taken) raise(by_side(std::move(taken.error())));
  if (auto checked = check(reading.options.frames); !checked) raise(by_side(std::move(checked.error())));
  return reading.options.frames;
}

Error placed(const Track& track, bool has_columns, Error error) {
  if (has_columns) error.code = ErrorCode::bad_data;
  return jobs::placed(track, std::move(error));
}

void add_key_origins(nb::module_& module) {
  module.def("part_of_keys", &keys_at, "keys"_a, "indices"_a);
  module.def("origin_of_keys", &origin_of, "keys"_a);
  module.def("keys_from", &from, "keys"_a, "name"_a, "epoch"_a, "lines"_a, "exact_times"_a, "as_read"_a.none(),
             "method"_a, "signs_as_given"_a, "line"_a, "is_dated"_a, "blending"_a = "", "gap"_a.none() = nb::none(),
             "times_apart"_a = std::vector<double>(), "positions_apart"_a = std::vector<double>(), "jumps"_a = false);
  module.def("keys_in_axes", &in_axes, "keys"_a, "stated"_a);
  module.def("keys_as_read", &as_read, "keys"_a, "stated"_a);
  module.def("sessions_of", &sessions_of, "times"_a);
  module.def(
      "gap_of_keys", [](const Keys& keys) { return keys.track->recipe.gap; }, "keys"_a);
  module.def("keys_since", &since, "keys"_a, "epoch"_a, "is_dated"_a);
  module.def("method_for_keys", &method_for, "keys"_a, "names"_a, "otherwise"_a, "ends"_a.none());
  module.def("recipe_set_aside", &set_aside, "keys"_a, "method"_a);
  module.def("key_statistics", &statistics_of, "keys"_a);
  module.def(
      "epoch_of_keys", [](const Keys& keys) { return keys.track->epoch.to_string(); }, "keys"_a);
}

}  // namespace orispline::python
