// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/retime.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

double duration_of(const Keyframes& keys) { return keys.times().back() - keys.times().front(); }

std::string scale_text(double scale) {
  return scale < 1.0 ? formatted("faster by {:.6g}", 1.0 / scale) : formatted("slowed by {:.6g}", scale);
}

/// `0.7 s before, 1.4 s after, slowed by 2`
std::string durations_text(const RetimeOutcome& outcome) {
  return formatted("{:.6g} s before, {:.6g} s after, {}", outcome.duration_before(),
                   duration_of(outcome.retiming.track.keys), scale_text(outcome.retiming.time_scale));
}

std::string rests_line(const Retiming& retiming) {
  if (retiming.rests.empty()) return "";
  const auto t = retiming.track.keys.times();
  double rested = 0.0;
  for (const std::size_t i : retiming.rests) rested += t[i + 1] - t[i];
  return formatted("{} between equal keys, {:.6g} s in all\n", counted(retiming.rests.size(), "rest"), rested);
}

/// Which times shape the path of an even motion, and what others would make of it.
std::string shape_line(const RetimeOptions& options, const std::optional<double>& typed_longer) {
  const std::string_view steps = options.constant_rate ? "angles" : "distances";
  const double longer = typed_longer.value_or(0.0);
  const std::string length = std::abs(longer) < 0.5e-3 ? std::string("as long")
                                                       : formatted("{:.3g} % {}", 100.0 * std::abs(longer),
                                                                   longer > 0.0 ? "longer" : "shorter");
  const bool is_known = typed_longer.has_value();
  if (options.path_times == PathTimes::typed)
    return formatted("the typed times shape the path{}\n",
                     is_known ? formatted(", {} {} by the {} between the keys", length,
                                          std::abs(longer) < 0.5e-3 ? "as" : "than", steps)
                              : "");
  return formatted("the {} between the keys shape the path, not the typed times{}\n", steps,
                   is_known ? formatted(", by which it would be {}", length) : "");
}

/// What is known of an even motion; empty for all others.
std::string evenness_lines(const RetimeOutcome& outcome) {
  const RetimeOptions& options = outcome.request.options;
  const std::optional<Evenness>& even = outcome.retiming.evenness;
  if (!even) return "";
  const std::string asked = options.constant_rate ? formatted("{:.6g} deg/s", degrees * *options.constant_rate)
                                                  : formatted("{:.6g} m/s", *options.constant_speed);
  const std::string stops =
      even->stops > 0 ? formatted(", {} where its path turns back", counted(even->stops, "stop")) : "";
  const std::string eased =
      options.ease ? formatted(", eased for {:.6g} s where it starts and stops{}", *options.ease, stops) : "";
  const std::string shift = even->shift ? formatted(" and {:.3g} mm", 1e3 * *even->shift) : "";
  return formatted(
      "{} within {:.2g} %{}\n{} on the path of {}, within {:.2g} deg{} of it; largest rate {:.6g} deg/s, acceleration "
      "{:.6g} deg/s2\n{}",
      asked, 100.0 * even->unevenness, eased, counted(outcome.retiming.track.keys.size(), "key"),
      text_of(even->path_method), degrees * even->turn, shift, degrees * even->largest_rate,
      degrees * even->largest_acceleration, shape_line(options, even->typed_longer));
}

}  // namespace

bool takes_no_rates(const FamilyInfo& family) noexcept { return family.rate_orders == 0; }

double RetimeOutcome::duration_before() const { return duration_of(request.keys->keys); }

std::vector<Certificate> RetimeOutcome::certificates() const {
  return certificates_of(request.options.limits, retiming.peaks);
}

Expected<RetimeOutcome> retime(RetimeRequest request, const Progress& progress) {
  const Track& keys = *request.keys;
  if (auto whole = check_without_gaps(keys); !whole) return tl::unexpected(std::move(whole.error()));
  const bool is_named = request.method.by != NamedBy::nobody || !keys.recipe.is_empty();
  const Method method = is_named ? request.method.method : holding_rests(request.method.method, keys.keys);
  auto retiming = orispline::retime(keys, method, request.options, progress);
  if (!retiming) return tl::unexpected(placed(keys, std::move(retiming.error())));
  std::vector<Warning> warnings = request.method.warnings;
  std::ranges::move(std::exchange(retiming->warnings, {}), std::back_inserter(warnings));
  return RetimeOutcome{std::move(request), std::move(*retiming), std::move(warnings)};
}

Json document_of(const RetimeOutcome& outcome) {
  const Retiming& retiming = outcome.retiming;
  Json json{{"method", retiming.method.name}};
  put(json, retiming, {"slowing"});
  json["slowing_asked_for"] = word_of(outcome.request.options.slowing);
  put(json, retiming, {"keys", "inserted"});
  json["duration_before_s"] = outcome.duration_before();
  put(json, retiming, {"duration_after", "time_scale", "rests", "slack"});
  put(json, retiming,
      {"unevenness", "path_turn", "path_shift", "typed_longer", "stops", "largest_rate", "largest_acceleration"});
  for (const Certificate& c : outcome.certificates()) {
    json[c.id_of("limit")] = c.limit / c.in_ids.size;
    json[c.id_of("bound")] = c.bound / c.in_ids.size;
    json[c.id_of("max")] = c.found / c.in_ids.size;
    json[formatted("{}_max_after_s", c.id)] = c.time;
    json[formatted("{}_bound_after_key", c.id)] = c.segment;
  }
  return json;
}

std::string summary_of(const RetimeOutcome& outcome) {
  const Retiming& retiming = outcome.retiming;
  std::string text = formatted(
      "{}, {}: {}{}\n", keys_text(*outcome.request.keys), text_of(retiming.method), durations_text(outcome),
      retiming.slowing == outcome.request.options.slowing ? "" : ", all intervals alike: each by itself saves no time");
  for (const Certificate& c : outcome.certificates())
    text += formatted("{}: nowhere above {} (limit {:.6g}), largest found {:.6g} at {:.6g} s after the start\n", c.name,
                      c.text_of(c.bound), c.limit / c.shown.size, c.found / c.shown.size, c.time);
  if (outcome.request.options.insert_keys > 0)
    text += retiming.inserted.empty() ? std::string("no keys inserted, which save no time\n")
                                      : formatted("{} inserted, {} in all\n", counted(retiming.inserted.size(), "key"),
                                                  retiming.track.keys.size());
  return text + evenness_lines(outcome) + rests_line(retiming);
}

std::string line_of(const RetimeOutcome& outcome) {
  return formatted("{} for {}, {}", counted(outcome.retiming.track.keys.size(), "key"),
                   text_of(outcome.retiming.method), durations_text(outcome));
}

}}}  // namespace orispline::jobs
