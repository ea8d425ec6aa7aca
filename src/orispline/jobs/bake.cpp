// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/bake.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/fields/field.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/baked_file.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

std::size_t pieces_of(const BakedCurve<float>& curve) noexcept { return curve.pieces().size(); }

}  // namespace

template <>
std::span<const FieldInfo> fields_of<jobs::BakeSettings>() noexcept {
  static constexpr std::array fields{field<&jobs::BakeSettings::tolerance>(
      {.name = "tolerance",
       .sentence = "Largest angle that is allowed between what is played and the curve",
       .quantity = &quantities::angle,
       .range = {.lowest = least_bake_tolerance<float>},
       .example = "1e-4deg or 2e-6rad",
       .is_required = true})};
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<jobs::BakeOutcome>() noexcept {
  static constexpr std::array fields{
      field<&jobs::BakeOutcome::curve, &pieces_of>(
          {.name = "pieces", .sentence = "Pieces of the curve, each a polynomial of degree 5 for every component"}),
      field<&jobs::BakeOutcome::curve, &BakedCurve<float>::largest_difference>(
          {.name = "largest_difference",
           .sentence = "Largest angle that was found between what is played and the curve",
           .quantity = &quantities::angle}),
  };
  return fields;
}

namespace jobs {

namespace {

std::vector<Warning> warnings_of(const BakeRequest& request, std::vector<Warning> of_curve) {
  std::vector<Warning> warnings = request.method.warnings;
  std::ranges::move(of_curve, std::back_inserter(warnings));
  const Track& keys = *request.keys;
  if (!keys.keys.positions().empty() || !keys.positions_apart.is_empty())
    warnings.push_back(
        {.code = "positions_left_out", .message = "the baked curve has orientations alone, positions are left out"});
  return warnings;
}

}  // namespace

Expected<BakeOutcome> bake(BakeRequest request, const Progress& progress) {
  const Track& keys = *request.keys;
  if (auto checked = check_ranges(request.options); !checked) return tl::unexpected(std::move(checked.error()));
  if (auto whole = check_without_gaps(keys); !whole) return tl::unexpected(std::move(whole.error()));
  auto made = curve_of_keys(request.method.method, keys);
  if (!made) return tl::unexpected(std::move(made.error()));
  auto baked = orispline::bake<float>(made->curve.orientation, request.options.tolerance, {}, progress);
  if (!baked) {
    Error error = std::move(baked.error());
    if (error.code == ErrorCode::bad_argument) error.option = "tolerance";
    return tl::unexpected(placed(keys, std::move(error)));
  }
  std::vector<Warning> warnings = warnings_of(request, std::move(made->warnings));
  return BakeOutcome{std::move(request), std::move(made->method), std::move(*baked), std::move(warnings)};
}

Json document_of(const BakeOutcome& outcome) {
  Json json{{"method", text_of(outcome.method)},
            {"keys", outcome.request.keys->keys.size()},
            {"tolerance_rad", outcome.request.options.tolerance}};
  put(json, outcome);
  return json;
}

std::string summary_of(const BakeOutcome& outcome) {
  return formatted("{}, {}: {}, {} bytes as .bin, within {:.3g}°; largest found {:.3g}°\n",
                   keys_text(*outcome.request.keys), text_of(outcome.method),
                   counted(outcome.curve.pieces().size(), "piece"), baked_bytes(outcome).size(),
                   outcome.request.options.tolerance * degrees, outcome.curve.largest_difference() * degrees);
}

}  // namespace jobs

}}  // namespace orispline
