// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/reduce.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

ClipReduceOptions options_for(const ReduceSceneRequest& request) {
  ClipReduceOptions options = request.options;
  options.precision = KeyPrecision::float32;  // that of glTF
  options.precision_before = request.file.format.holds_floats ? KeyPrecision::float32 : KeyPrecision::float64;
  return options;
}

Expected<void> check_unit(const ReduceSceneRequest& request) {
  if (request.position_scale) return check_metres(request.file.format, *request.position_scale);
  const bool bounds_world = std::isfinite(request.options.world_tolerance);
  const bool bounds_lengths = bounds_world || std::isfinite(request.options.position_tolerance);
  if (!request.file.format.has_no_unit || !bounds_lengths) return {};
  return bad_option(
      bounds_world ? "world_tolerance" : "position_tolerance",
      formatted("found {}, which has no unit of length, wanted `position_scale` as well, such as 0.01 for "
                "centimetres",
                request.file.format.file));
}

Warning missed(std::string_view option, double found, double tolerance, std::string_view unit) {
  return {.code = "single_precision",
          .message = formatted("found {:.4g}{} in the file, more than {:.4g}{}: glTF holds times and numbers in single "
                               "precision, and keys that were to be nearer stay as they are",
                               found, unit, tolerance, unit),
          .option = std::string(option)};
}

/// Where keys stay that single precision cannot hold within the tolerance.
std::vector<Warning> warnings_of_precision(const ReduceSceneOutcome& outcome) {
  const ClipTotals totals = outcome.totals();
  const ClipReduceOptions& options = outcome.options;
  std::vector<Warning> warnings;
  if (totals.angle && totals.angle->angle.largest.value > options.tolerance)
    warnings.push_back(
        missed("tolerance", totals.angle->angle.largest.value * degrees, options.tolerance * degrees, "°"));
  if (totals.translation && totals.translation->translation.largest.value > options.position_tolerance)
    warnings.push_back(
        missed("position_tolerance", totals.translation->translation.largest.value, options.position_tolerance, " m"));
  if (totals.distance && totals.distance->distance.largest.value > options.world_tolerance)
    warnings.push_back(
        missed("world_tolerance", totals.distance->distance.largest.value, options.world_tolerance, " m"));
  return warnings;
}

}  // namespace

ClipTotals ReduceSceneOutcome::totals() const { return totals_of(reductions); }

std::vector<Clip> ReduceSceneOutcome::clips() const {
  std::vector<Clip> clips;
  for (const ClipReduction& reduction : reductions) clips.push_back(reduction.clip);
  return clips;
}

Expected<void> check(const ReduceSceneRequest& request) {
  return check_unit(request).and_then([&] { return orispline::check(options_for(request)); });
}

Expected<ReduceSceneOutcome> reduce_scene(ReduceSceneRequest request) {
  if (auto checked = check(request); !checked) return tl::unexpected(std::move(checked.error()));
  std::vector<Warning> warnings;
  if (request.position_scale) {
    warnings = warnings_of_height(request.skeleton, request.file.format, *request.position_scale, request.file.name);
    auto file =
        in_metres({request.file.name, std::move(request.skeleton), std::move(request.clips), request.file.format},
                  *request.position_scale);
    if (!file) return tl::unexpected(std::move(file.error()));
    request.file.format = file->format;
    request.skeleton = std::move(file->skeleton);
    request.clips = std::move(file->clips);
  }
  const ClipReduceOptions options = options_for(request);
  auto reductions = reduce_clips(request.skeleton, request.clips, options, request.threads);
  if (!reductions) {
    reductions.error().where.file = request.file.name;
    return tl::unexpected(std::move(reductions.error()));
  }
  ReduceSceneOutcome outcome{.request = std::move(request), .options = options, .reductions = *std::move(reductions)};
  outcome.warnings = std::move(warnings);
  std::ranges::move(warnings_of_precision(outcome), std::back_inserter(outcome.warnings));
  return outcome;
}

}}}  // namespace orispline::jobs
