// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/stream_keys.hpp>

#include <algorithm>
#include <limits>

#include <orispline/families/registry.hpp>
#include <orispline/online/stream_parts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

void StreamKeys::push(const StreamKey& key) {
  data_.times.push_back(key.time);
  data_.orientations.push_back(key.orientation);
  for_each_stream_part([&](const auto& part) {
    if (const auto& value = key.*part.value) (data_.*part.of_keys.list).push_back(*value);
  });
  settings_.resize(key.settings.size());
  for (auto list = settings_.begin(); const auto& [name, value] : key.settings) (list++)->push_back(value);
}

void StreamKeys::pop() {
  const auto drop_last = [](auto& list) {
    if (!list.empty()) list.pop_back();
  };
  for_each_list(data_, drop_last);
  std::ranges::for_each(settings_, drop_last);
}

void StreamKeys::forget_before(std::uint64_t key) {
  if (key <= first_) return;
  const auto count = static_cast<std::ptrdiff_t>(key - first_);
  const auto drop = [count](auto& list) {
    if (!list.empty()) list.erase(list.begin(), list.begin() + count);
  };
  for_each_list(data_, drop);
  std::ranges::for_each(settings_, drop);
  first_ = key;
}

void StreamKeys::clear() { *this = {}; }

KeyParts StreamKeys::parts() const noexcept {
  KeyParts found;
  for_each_stream_part([&](const auto& part) { found.*part.is_there = !(data_.*part.of_keys.list).empty(); });
  return found;
}

Expected<StreamKeys> StreamKeys::from_kept(std::uint64_t first, KeyframeData data,
                                           std::vector<std::vector<double>> settings, const StreamMethod& method) {
  const std::size_t kept = data.times.size();
  if (const auto checked = Keyframes::make(data, Signs::as_given); !checked) return tl::unexpected(checked.error());
  const auto refused = [](const char* what) { return failure(ErrorCode::bad_data, what); };
  if (first > std::numeric_limits<std::uint64_t>::max() / 4 || first % method.family->key_use.stride != 0)
    return refused("the keys of a state begin where none can");
  if (settings.size() != method.per_key.size()) return refused("a state has settings of other parameters");
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (settings[i].size() != kept) return refused("a state has settings for another number of keys");
    for (const double value : settings[i])
      if (auto settled = settle(*method.family, {.parameters = {{method.per_key[i], {value}}}}, 1); !settled)
        return refused("a state has a setting out of its range");
  }
  StreamKeys keys;
  keys.data_ = std::move(data);
  keys.settings_ = std::move(settings);
  keys.first_ = first;
  return keys;
}

std::uint64_t StreamKeys::needed_from(std::uint64_t start, const StreamMethod& method) const noexcept {
  if (!method.keys_beside) return 0;
  const std::uint64_t before_start = start - std::min<std::uint64_t>(start, *method.keys_beside);
  const std::uint64_t before_end = count() - std::min<std::uint64_t>(count(), method.keys_at_end);
  const std::uint64_t key = std::min(before_start, before_end);
  return key - key % method.family->key_use.stride;
}

Expected<PoseCurve> StreamKeys::curve_from(std::uint64_t key, const StreamMethod& method, Stream stream) const {
  const std::size_t skipped = static_cast<std::size_t>(key - first_), there = kept() - skipped;
  const bool whole = stream == Stream::finished || there == 1;
  const auto count = static_cast<std::ptrdiff_t>(whole ? there : method.family->key_use.cut(there));
  const auto part = [&](const auto& list) {
    using List = std::remove_cvref_t<decltype(list)>;
    const auto from = list.begin() + static_cast<std::ptrdiff_t>(list.empty() ? 0 : skipped);
    return list.empty() ? List{} : List(from, from + count);
  };
  CurveOptions options = method.options;
  if (key > 0) options.start = {};
  if (stream == Stream::open) options.end = {};
  for (std::size_t i = 0; i < settings_.size(); ++i) options.parameters[method.per_key[i]] = part(settings_[i]);
  auto curve = Keyframes::make(list_by_list(data_, part), Signs::as_given).and_then([&](const Keyframes& keys) {
    return make_pose_curve({*method.family, options}, keys);
  });
  if (curve || !curve.error().where.key) return curve;
  Error error = std::move(curve.error());
  *error.where.key += static_cast<std::size_t>(key);
  return tl::unexpected(std::move(error));
}

}}  // namespace orispline
