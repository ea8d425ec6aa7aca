// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/stream_method.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/online/stream_parts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Enough for every end rule and every family.
constexpr std::size_t segments_of_a_trial = 9;

Error argument_error(std::string message) { return {ErrorCode::bad_argument, std::move(message), {}}; }

std::optional<Error> check_options(const FamilyInfo& family, const CurveOptions& options) {
  if (options.loop) return argument_error("an online curve is open, found a loop");
  for (const auto& [name, values] : options.parameters)
    if (values.size() > 1)
      return argument_error(formatted(
          "{}: found {} values of {}, wanted 1 for all keys of an online curve, or none where each key brings its own",
          family.name, values.size(), name));
  return std::nullopt;
}

/// The parameters without values that keys can bring, which leave the options.
std::vector<std::string> taken_per_key(const FamilyInfo& family, CurveOptions& options) {
  std::vector<std::string> per_key;
  for (const Parameter& parameter : family.parameters) {
    const auto found = options.parameters.find(parameter.name);
    if (found == options.parameters.end() || !found->second.empty() || !parameter.per_key) continue;
    per_key.emplace_back(parameter.name);
    options.parameters.erase(found);
  }
  std::ranges::sort(per_key);
  return per_key;
}

/// What is wrong with a part of a key, which the keys before have or have not.
template <class T>
std::optional<Error> check_part(std::size_t place, const StreamPart<T>& part, const std::optional<T>& value,
                                bool is_wanted) {
  const char* const name = part.of_keys.one;
  if (value.has_value() == is_wanted) return value ? part.of_keys.check(place, name, *value) : std::nullopt;
  return Error{ErrorCode::bad_data,
               value ? formatted("found {} {}, wanted none as the keys before have none", part.article, name)
                     : formatted("found no {}, wanted one as the keys before have", name),
               {.key = place}};
}

/// The curve through keys in one place, a second apart from 0 s on: what no keys can have is refused before there are
/// any.
Expected<AnyCurve> trial_curve(const FamilyInfo& family, const CurveOptions& options) {
  KeyframeData data;
  for (std::size_t i = 0; i < family.key_use.keys_for(segments_of_a_trial); ++i) {
    data.times.push_back(static_cast<double>(i));
    data.orientations.push_back(Eigen::Quaterniond::Identity());
  }
  auto curve = Keyframes::make(std::move(data)).and_then([&](const Keyframes& keys) {
    return make_curve({family, options}, keys);
  });
  if (!curve) curve.error().where = {};
  return curve;
}

}  // namespace

Eigen::Quaterniond unit_orientation(const Eigen::Quaterniond& orientation) {
  return normalised(orientation, checked_norm(0, orientation).value());
}

KeyParts parts_of(const StreamKey& key) noexcept {
  KeyParts found;
  for_each_stream_part([&](const auto& part) { found.*part.is_there = (key.*part.value).has_value(); });
  return found;
}

Expected<Eigen::Quaterniond> checked_orientation(std::uint64_t index, const StreamKey& key,
                                                 std::span<const double> before, const KeyParts& wanted) {
  const auto place = static_cast<std::size_t>(index);
  if (auto error = check_time(place, key.time, before)) return tl::unexpected(std::move(*error));
  std::optional<Error> refused;
  for_each_stream_part([&](const auto& part) {
    const auto& value = key.*part.value;
    if (!refused) refused = check_part(place, part, value, before.empty() ? value.has_value() : wanted.*part.is_there);
  });
  if (refused) return tl::unexpected(std::move(*refused));
  const auto norm = checked_norm(place, key.orientation);
  if (!norm) return tl::unexpected(norm.error());
  return normalised(key.orientation, *norm);
}

Expected<StreamMethod> StreamMethod::make(const Method& method) {
  const auto found = family_of_method(method);
  if (!found) return tl::unexpected(found.error());
  const FamilyInfo& family = **found;
  if (auto error = check_options(family, method.options)) return tl::unexpected(std::move(*error));
  StreamMethod made{.family = &family,
                    .options = method.options,
                    .per_key = {},
                    .keys_beside = {},
                    .first_key = 0,
                    .keys_at_start = 0,
                    .keys_at_end = 0,
                    .own = method.own};
  made.per_key = taken_per_key(family, made.options);
  const auto trial = trial_curve(family, made.options);
  if (!trial) return tl::unexpected(trial.error());
  made.first_key = static_cast<std::size_t>(trial->domain().start);
  const auto settings = settle(family, made.options, family.key_use.keys_for(segments_of_a_trial));
  if (!settings) return tl::unexpected(settings.error());
  made.keys_beside = orispline::keys_beside(family, *settings);
  // At an end a window of the keys on either side of one is shifted inwards.
  const std::size_t window = 2 * made.keys_beside.value_or(0) + 1;
  made.keys_at_start = std::max(window, keys_needed(settings->start.rule));
  made.keys_at_end = std::max({window + 1, keys_needed(settings->end.rule), static_cast<std::size_t>(family.min_keys)});
  return made;
}

std::optional<Error> StreamMethod::check_count(std::size_t keys) const {
  const std::size_t least = std::max(
      {keys_needed(options.start.rule), keys_needed(options.end.rule), static_cast<std::size_t>(family->min_keys)});
  if (keys == 1 || (keys >= least && family->key_use.cut(keys) == keys)) return std::nullopt;
  return settle(*family, options, keys).error();
}

std::optional<Error> StreamMethod::check_settings(std::uint64_t index, const StreamKey& key) const {
  if (per_key.empty() && key.settings.empty()) return std::nullopt;
  const auto refused = [index](Error error) {
    error.where.key = static_cast<std::size_t>(index);
    return error;
  };
  CurveOptions brought;
  for (const auto& [name, value] : key.settings) brought.parameters[name] = {value};
  if (const auto settled = settle(*family, brought, family->key_use.keys_for(segments_of_a_trial)); !settled)
    return refused(settled.error());
  const auto is_of_key = [](const auto& setting, const std::string& name) { return setting.first == name; };
  if (std::ranges::equal(key.settings, per_key, is_of_key)) return std::nullopt;
  std::vector<std::string_view> names;
  for (const auto& [name, value] : key.settings) names.push_back(name);
  return refused(argument_error(formatted("{}: found values of [{}] with the key, wanted those of [{}]", family->name,
                                          joined(names, ", "), joined(per_key, ", "))));
}

}}  // namespace orispline
