// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_in_stretches.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_parts.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

template <class T>
std::vector<T> part_of(std::span<const T> values, const Stretch& stretch) {
  if (values.empty()) return {};
  const auto part = values.subspan(stretch.first, stretch.count);
  return {part.begin(), part.end()};
}

}  // namespace

Expected<Keyframes> keys_of_stretch(const Keyframes& keys, const Stretch& stretch) {
  const auto own = [&stretch](const auto& list) { return part_of(std::span(list), stretch); };
  return Keyframes::make(list_by_list(keys.data(), own), Signs::as_given);
}

Method method_for_stretch(Method method, const Stretch& stretch, std::size_t keys) {
  for (auto& [name, values] : method.options.parameters)
    if (values.size() == keys) values = part_of(std::span<const double>(values), stretch);
  const auto is_clamped = [](const End& end) { return end.rule == EndRule::clamped; };
  if (stretch.first > 0 && is_clamped(method.options.start)) method.options.start = {};
  if (stretch.first + stretch.count < keys && is_clamped(method.options.end)) method.options.end = {};
  return method;
}

Expected<PoseCurve> curve_in_stretches(const Method& method, const Keyframes& keys,
                                       std::span<const Stretch> stretches) {
  if (method.options.loop)
    return keys.data().jumps ? bad_option("jumps", "found jumps in the keys of a closed curve, wanted one of the two")
                             : bad_option("gap", "found gaps in the keys of a closed curve, wanted one of the two");
  std::vector<AnyCurve> orientations;
  std::vector<AnyPath> positions;
  for (const Stretch& stretch : stretches) {
    auto curve = keys_of_stretch(keys, stretch).and_then([&](const Keyframes& own) {
      return make_pose_curve(method_for_stretch(method, stretch, keys.size()), own);
    });
    if (!curve) {
      Error error = std::move(curve.error());
      error.where.key = stretch.first + error.where.key.value_or(0);
      error.message += formatted(", in the {} from there to the next gap", counted(stretch.count, "key"));
      return tl::unexpected(std::move(error));
    }
    orientations.push_back(curve->orientation);
    if (curve->position) positions.push_back(*curve->position);
  }
  PoseCurve joined{StretchedCurve<Eigen::Quaterniond>(std::move(orientations))};
  if (!positions.empty()) joined.position = StretchedCurve<Eigen::Vector3d>(std::move(positions));
  return joined;
}

Expected<PoseCurve> curve_beside_gaps(const Method& method, const Keyframes& keys, std::optional<double> gap) {
  if (!are_in_stretches(keys, gap)) return make_pose_curve(method, keys);
  return stretches_between_gaps(keys.times(), gap).and_then([&](const std::vector<Stretch>& stretches) {
    return curve_in_stretches(method, keys, stretches);
  });
}

Expected<std::vector<Stretch>> stretches_of(const Track& track) {
  if (!are_in_stretches(track.keys, track.recipe.gap)) return std::vector<Stretch>();
  return stretches_between_gaps(track.keys.times(), track.recipe.gap);
}

Expected<BandInStretches> BandInStretches::make(const Method& method, const Keyframes& keys,
                                                std::span<const Stretch> stretches, double share) {
  const Stretch whole{0, keys.size()};
  if (stretches.empty()) stretches = {&whole, 1};
  BandInStretches bands;
  for (const Stretch& stretch : stretches) {
    auto own = keys_of_stretch(keys, stretch);
    if (!own) return tl::unexpected(std::move(own.error()));
    auto band = MotionBand::make(method_for_stretch(method, stretch, keys.size()), *own, share);
    if (!band) return tl::unexpected(std::move(band.error()));
    bands.parts_.push_back({own->times().front(), own->times().back(), std::move(*band)});
  }
  return bands;
}

double BandInStretches::operator()(double t) const noexcept {
  const auto next = std::ranges::upper_bound(parts_, t, {}, &Part::start);
  if (next == parts_.begin()) return next->band(t);
  const Part& part = *(next - 1);
  const bool is_in_gap = next != parts_.end() && t > part.end;
  return is_in_gap ? std::numeric_limits<double>::quiet_NaN() : part.band(t);
}

}}  // namespace orispline
