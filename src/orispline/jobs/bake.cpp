// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/bake.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/fields/field.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

std::size_t pieces(const BakedMotion& baked) noexcept { return baked.curve.pieces().size(); }
double largest_difference(const BakedMotion& baked) noexcept { return baked.curve.largest_difference(); }
std::optional<std::size_t> position_pieces(const BakedMotion& baked) {
  return baked.path ? std::optional(baked.path->pieces().size()) : std::nullopt;
}
std::optional<double> largest_position_difference(const BakedMotion& baked) {
  return baked.path ? std::optional(baked.path->largest_difference()) : std::nullopt;
}

}  // namespace

template <>
std::span<const FieldInfo> fields_of<jobs::BakeSettings>() noexcept {
  static constexpr std::array fields{
      field<&jobs::BakeSettings::tolerance>(
          {.name = "tolerance",
           .sentence = "Largest angle that is allowed between what is played and the curve",
           .quantity = &quantities::angle,
           .range = {.lowest = least_bake_tolerance<float>},
           .example = "1e-4deg or 2e-6rad",
           .is_required = true}),
      field<&jobs::BakeSettings::position_tolerance>(
          {.name = "position_tolerance",
           .sentence = "Largest distance that is allowed between the positions that are played and the path",
           .quantity = &quantities::length,
           .range = positive,
           .example = "1mm"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<jobs::BakeOutcome>() noexcept {
  static constexpr std::array fields{
      field<&jobs::BakeOutcome::baked, &pieces>(
          {.name = "pieces", .sentence = "Pieces of the curve, each a polynomial of degree 5 for every component"}),
      field<&jobs::BakeOutcome::baked, &largest_difference>(
          {.name = "largest_difference",
           .sentence = "Largest angle that was found between what is played and the curve",
           .quantity = &quantities::angle}),
      field<&jobs::BakeOutcome::baked, &position_pieces>(
          {.name = "position_pieces",
           .sentence = "Pieces of the path, each a polynomial of degree 5 for every coordinate",
           .absent = "there are no positions"}),
      field<&jobs::BakeOutcome::baked, &largest_position_difference>(
          {.name = "largest_position_difference",
           .sentence = "Largest distance that was found between the positions that are played and the path",
           .quantity = &quantities::length,
           .absent = "there are no positions"}),
  };
  return fields;
}

namespace jobs {

Expected<BakeOutcome> bake(BakeRequest request, const Progress& progress) {
  const Track& keys = *request.keys;
  if (auto checked = check_ranges(request.options); !checked) return tl::unexpected(std::move(checked.error()));
  if (auto whole = check_without_gaps(keys); !whole) return tl::unexpected(std::move(whole.error()));
  auto made = curve_of_keys(request.method.method, keys);
  if (!made) return tl::unexpected(std::move(made.error()));
  auto baked = bake_motion(made->curve, request.options.tolerance, request.options.position_tolerance, progress);
  if (!baked) return tl::unexpected(placed(keys, std::move(baked.error())));
  std::vector<Warning> warnings = request.method.warnings;
  std::ranges::move(made->warnings, std::back_inserter(warnings));
  return BakeOutcome{std::move(request), std::move(made->method), std::move(*baked), std::move(warnings)};
}

Json document_of(const BakeOutcome& outcome) {
  Json json{{"method", text_of(outcome.method)},
            {"keys", outcome.request.keys->keys.size()},
            {"tolerance_rad", outcome.request.options.tolerance}};
  if (outcome.baked.path) json["position_tolerance_m"] = outcome.request.options.position_tolerance;
  put(json, outcome);
  return json;
}

std::string summary_of(const BakeOutcome& outcome) {
  const Track& keys = *outcome.request.keys;
  const BakeSettings& options = outcome.request.options;
  const auto& [curve, path] = outcome.baked;
  std::string text = formatted("{}, {}: {}, {} bytes as .bin, within {:.3g}°; largest found {:.3g}°\n", keys_text(keys),
                               text_of(outcome.method), counted(curve.pieces().size(), "piece"),
                               baked_bytes(outcome.baked, keys.epoch).size(), options.tolerance * degrees,
                               curve.largest_difference() * degrees);
  if (path)
    text += formatted("positions: {}, within {:.3g} m; largest found {:.3g} m\n",
                      counted(path->pieces().size(), "piece"), options.position_tolerance, path->largest_difference());
  return text;
}

}  // namespace jobs

}}  // namespace orispline
