// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/curve_clip.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/clip/single_precision.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// Cubics, and how far they are from the curve as they are read again: glTF holds single precision.
template <CurvePoint P>
struct CubicsInFile {
  Channel<P> channel{};
  double farthest = 0.0;

  template <class Curve>
  CubicsInFile(const Curve& curve, double tolerance) {
    double asked = tolerance;
    for (int attempt = 0; attempt < attempts && asked > 0.0; ++attempt) {
      auto found = cubic_channel(curve, asked);
      const double in_file =
          std::max(found.largest_distance, largest_distance(curve, in_single_precision(found.channel)));
      if (attempt > 0 && in_file >= farthest) return;
      channel = std::move(found.channel);
      farthest = in_file;
      if (farthest <= tolerance || found.largest_distance > asked) return;
      asked = tolerance - narrowing * (farthest - found.largest_distance);
    }
  }

 private:
  static constexpr int attempts = 3;
  static constexpr double narrowing = 1.5;  ///< of the tolerance, by what single precision was seen to take
};

void add_if_beyond(std::vector<Warning>& warnings, std::string_view option, double farthest, double tolerance,
                   std::string_view unit) {
  if (farthest > tolerance)
    warnings.push_back(
        {.code = "beyond_tolerance",
         .message = formatted("found {:.4g}{} in the file, more than {:.4g}{}: either the curve jumps there, or the "
                              "single precision of glTF is too coarse",
                              farthest, unit, tolerance, unit),
         .option = std::string(option)});
}

void add_cubics(CurveClipOutcome& outcome, const PoseCurve& curve) {
  const double tolerance = *outcome.request.tolerance, position_tolerance = outcome.request.position_tolerance;
  CubicsInFile<Eigen::Quaterniond> rotation(curve.orientation, tolerance);
  outcome.largest = rotation.farthest;
  add_if_beyond(outcome.warnings, "tolerance", rotation.farthest * degrees, tolerance * degrees, "°");
  outcome.clip.rotations.push_back(std::move(rotation.channel));
  if (!curve.position) return;
  CubicsInFile<Eigen::Vector3d> translation(*curve.position, position_tolerance);
  outcome.largest_position = translation.farthest;
  add_if_beyond(outcome.warnings, "position_tolerance", translation.farthest, position_tolerance, " m");
  outcome.clip.translations.push_back(std::move(translation.channel));
}

void add_samples(CurveClipOutcome& outcome, const PoseCurve& curve) {
  RotationChannel rotation{.times = outcome.request.sample_times};
  VectorChannel translation;
  for (const double t : rotation.times) {
    rotation.values.push_back(curve.orientation(t).normalized());
    if (curve.position) translation.values.push_back(curve.position->linear_motion(t).position);
  }
  if (curve.position) {
    translation.times = rotation.times;
    outcome.clip.translations.push_back(std::move(translation));
  }
  outcome.clip.rotations.push_back(std::move(rotation));
}

std::size_t rotation_keys(const CurveClipOutcome& outcome) { return outcome.clip.rotations.front().size(); }

std::size_t position_keys(const CurveClipOutcome& outcome) {
  return outcome.clip.translations.empty() ? 0 : outcome.clip.translations.front().size();
}

}  // namespace

CurveClipOutcome curve_clip(CurveClipRequest request, const PoseCurve& curve) {
  CurveClipOutcome outcome{.request = std::move(request)};
  outcome.clip.name = outcome.request.name;
  if (outcome.request.tolerance) add_cubics(outcome, curve);
  else add_samples(outcome, curve);
  return outcome;
}

Json document_of(const CurveClipOutcome& outcome) {
  const CurveClipRequest& request = outcome.request;
  Json json{{"method", request.method}, {"keys", request.keys}, {"keys_written", rotation_keys(outcome)}};
  const std::size_t positions = position_keys(outcome);
  if (positions > 0) json["position_keys_written"] = positions;
  if (!request.tolerance) return json;
  json["tolerance_deg"] = *request.tolerance * degrees;
  json["error_max_deg"] = outcome.largest * degrees;
  if (positions > 0) json["position_error_max_m"] = outcome.largest_position;
  return json;
}

std::string summary_of(const CurveClipOutcome& outcome) {
  const CurveClipRequest& request = outcome.request;
  std::string text =
      formatted("{} from {}, {}\n", counted(request.keys, "key"), printable(request.source), request.method);
  if (!request.tolerance)
    return text + formatted("{} written to {}\n", counted(rotation_keys(outcome), "sample"), outcome.written_to);
  text += formatted("{} of rotations, at most {:.4g}° from the curve (tolerance {:.4g}°)\n",
                    counted(rotation_keys(outcome), "key"), outcome.largest * degrees, *request.tolerance * degrees);
  if (position_keys(outcome) > 0)
    text += formatted("{} of positions, at most {:.4g} m from the path (tolerance {:.4g} m)\n",
                      counted(position_keys(outcome), "key"), outcome.largest_position, request.position_tolerance);
  return text + formatted("written to {} as cubics\n", outcome.written_to);
}

}}}  // namespace orispline::jobs
