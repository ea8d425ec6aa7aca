// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/align_rates.hpp>

#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/align_words.hpp>
#include <orispline/jobs/smoothing_words.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

const Track* poses_in(const Recording& recording) {
  const auto* const track = std::get_if<std::shared_ptr<const Track>>(&recording);
  return track ? track->get() : nullptr;
}

/// Of a recording that has no orientations.
const GyroTrack& gyro_in(const Recording& recording) { return *std::get<std::shared_ptr<const GyroTrack>>(recording); }

std::size_t size_of(const Recording& recording) {
  const Track* const poses = poses_in(recording);
  return poses ? poses->keys.size() : gyro_in(recording).rates.times.size();
}

std::string name_of(const Recording& recording) {
  const Track* const poses = poses_in(recording);
  return poses ? poses->name : gyro_in(recording).rates.name;
}

std::string recording_text(const Recording& recording) {
  const bool is_gyro = poses_in(recording) == nullptr;
  const std::string count = counted(size_of(recording), is_gyro ? "rate" : "orientation");
  const std::string what = is_gyro ? count + " of a gyro" : count;
  const std::string name = name_of(recording);
  return name.empty() ? what : formatted("{} from {}", what, printable(name));
}

Places places_in(const Recording& recording) {
  if (const Track* const poses = poses_in(recording)) return places_of(*poses);
  const GyroTrack& gyro = gyro_in(recording);
  return {gyro.rates.lines, [&gyro](std::size_t rate) { return gyro.time_of(rate); }};
}

/// Bad data may lie in one recording or in both; which one is known where it is the only gyro.
Expected<RateAlignment> alignment_of(const RateAlignRequest& request, const Progress& progress) {
  const Track *const moved = poses_in(request.moved), *const fixed = poses_in(request.fixed);
  if (moved && fixed)
    return failure(ErrorCode::bad_argument, "found two recordings of orientations, wanted one of a gyro at least");
  if (moved) return orispline::align(*moved, gyro_in(request.fixed), request.options, progress);
  if (fixed) return orispline::align(gyro_in(request.moved), *fixed, request.options, progress);
  return orispline::align(gyro_in(request.moved), gyro_in(request.fixed), request.options, progress);
}

Expected<std::variant<Track, GyroTrack>> moved_by(const RateAlignment& alignment, const RateAlignRequest& request) {
  using Moved = std::variant<Track, GyroTrack>;
  if (const Track* const poses = poses_in(request.moved))
    return aligned(*poses, gyro_in(request.fixed), alignment).map([](Track track) { return Moved(std::move(track)); });
  const Track* const body = poses_in(request.fixed);
  const Decimal& epoch = body ? body->epoch : gyro_in(request.fixed).epoch;
  return Moved(aligned(gyro_in(request.moved), epoch, alignment));
}

Json open_json(const std::vector<OpenRateDirection>& directions) {
  Json list = Json::array();
  for (const OpenRateDirection& open : directions)
    list.push_back({{"body", vector_json(open.body)}, {"offset", open.offset}, {"bias", vector_json(open.bias)}});
  return list;
}

std::string left_line(const RateAlignment& a) {
  const DistanceStatistics& left = a.distance ? *a.distance : *a.rate_distance;
  return formatted(
      "left            RMS {:.6g}{}, median {:.6g}{}, largest {:.6g}{}; {:.2g} times what the noise of "
      "both explains\n",
      left.rms * degrees, a.distance ? "°" : " °/s", left.median * degrees, a.distance ? "°" : " °/s",
      left.largest * degrees, a.distance ? "°" : " °/s", a.excess);
}

std::string rejected_line(std::string_view what, const std::vector<std::size_t>& rejected, const Recording& recording) {
  return formatted("{}{} of {}{}\n", what, rejected.size(), size_of(recording),
                   places_text(rejected, places_in(recording)));
}

}  // namespace

Expected<RateAlignOutcome> align_rates(RateAlignRequest request, const Progress& progress) {
  auto alignment = alignment_of(request, progress);
  if (!alignment) return tl::unexpected(std::move(alignment.error()));
  auto there = moved_by(*alignment, request);
  if (!there) return tl::unexpected(std::move(there.error()));
  std::vector<Warning> warnings = std::exchange(alignment->warnings, {});
  return RateAlignOutcome{std::move(request), std::move(*alignment), std::move(*there), std::move(warnings)};
}

Json document_of(const RateAlignOutcome& outcome) {
  const RateAlignment& alignment = outcome.alignment;
  const auto& [moved, fixed, options] = outcome.request;
  Json json{{"samples", size_of(moved)},
            {"reference_samples", size_of(fixed)},
            {"gyros", {{"input", poses_in(moved) == nullptr}, {"reference", poses_in(fixed) == nullptr}}},
            {"body", rotation_json(alignment.body)}};
  put(json, alignment, places_in(moved));
  put(json, alignment, {"rejected_fixed"}, places_in(fixed));
  json["open"] = open_json(alignment.open);
  return json;
}

std::string summary_of(const RateAlignOutcome& outcome) {
  const RateAlignment& a = outcome.alignment;
  const auto& [moved, fixed, options] = outcome.request;
  const Eigen::Vector3d bias = a.bias * degrees;
  return formatted("{} onto {}\n", recording_text(moved), recording_text(fixed)) +
         formatted("offset          {} s{}\n", a.offset.to_string(), sigma_text(a.offset_sigma, " s")) +
         formatted("body            {}{}\n", rotation_text(a.body), sigmas_text(a.body_sigma, degrees, "°")) +
         formatted("bias            {:.6g} °/s, {:.6g} °/s, {:.6g} °/s{}\n", bias.x(), bias.y(), bias.z(),
                   sigmas_text(a.bias_sigma, degrees, " °/s")) +
         left_line(a) + rejected_line("rejected        ", a.rejected_moved, moved) +
         rejected_line("  beside them   ", a.rejected_fixed, fixed);
}

std::string line_of(const RateAlignOutcome& outcome) {
  const RateAlignment& a = outcome.alignment;
  return formatted("{} aligned, {} s late beside {}", recording_text(outcome.request.moved), a.offset.to_string(),
                   shown_name(name_of(outcome.request.fixed), "the other recording"));
}

}}}  // namespace orispline::jobs
