// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_curve_scene.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/clip/single_precision.hpp>
#include <orispline/math/degrees.hpp>

#include "options/scene_input.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// What was written into a file of skeletons.
struct CurveSceneReport {
  std::string input{}, output{}, method{};
  std::size_t keys = 0, keys_written = 0, positions_written = 0;
  std::optional<double> tolerance{}, largest{};             ///< [rad], of cubics
  double position_tolerance = 0.0, largest_position = 0.0;  ///< [m]
};

std::string text_of(const CurveSceneReport& report) {
  std::string text = formatted("{} from {}, {}\n", counted(report.keys, "key"), printable(report.input), report.method);
  if (!report.largest)
    return text + formatted("{} written to {}\n", counted(report.keys_written, "sample"), destination(report.output));
  text += formatted("{} of rotations, at most {:.4g}° from the curve (tolerance {:.4g}°)\n",
                    counted(report.keys_written, "key"), *report.largest * degrees, *report.tolerance * degrees);
  if (report.positions_written > 0)
    text += formatted("{} of positions, at most {:.4g} m from the path (tolerance {:.4g} m)\n",
                      counted(report.positions_written, "key"), report.largest_position, report.position_tolerance);
  text += formatted("written to {} as cubics\n", destination(report.output));
  return text;
}

Json json_of(const CurveSceneReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"method", report.method},
            {"keys", report.keys},
            {"keys_written", report.keys_written}};
  if (report.positions_written > 0) json["position_keys_written"] = report.positions_written;
  if (report.largest) {
    json["tolerance_deg"] = *report.tolerance * degrees;
    json["error_max_deg"] = *report.largest * degrees;
    if (report.positions_written > 0) json["position_error_max_m"] = report.largest_position;
  }
  return json;
}

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

void warn_beyond(std::string_view option, double farthest, double tolerance, std::string_view unit) {
  if (farthest > tolerance)
    warn(
        formatted("{}: found {:.4g}{} in the file, more than {:.4g}{}: either the curve jumps there, or the single "
                  "precision of glTF is too coarse",
                  option, farthest, unit, tolerance, unit));
}

CurveSceneReport add_cubics(Clip& clip, const PoseCurve& curve, const SampleRequest& request) {
  CubicsInFile<Eigen::Quaterniond> rotation(curve.orientation, *request.tolerance);
  warn_beyond("--tolerance", rotation.farthest * degrees, *request.tolerance * degrees, "°");
  CurveSceneReport report{.keys_written = rotation.channel.size(),
                          .tolerance = request.tolerance,
                          .largest = rotation.farthest,
                          .position_tolerance = request.position_tolerance};
  clip.rotations.push_back(std::move(rotation.channel));
  if (!curve.position) return report;
  CubicsInFile<Eigen::Vector3d> translation(*curve.position, request.position_tolerance);
  warn_beyond("--position-tolerance", translation.farthest, request.position_tolerance, " m");
  report.positions_written = translation.channel.size();
  report.largest_position = translation.farthest;
  clip.translations.push_back(std::move(translation.channel));
  return report;
}

CurveSceneReport add_samples(Clip& clip, const PoseCurve& curve, const SampleTimes& times) {
  RotationChannel rotation;
  VectorChannel translation;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double t = times[k].t;
    rotation.times.push_back(t);
    rotation.values.push_back(curve.orientation(t).normalized());
    if (curve.position) translation.values.push_back(curve.position->linear_motion(t).position);
  }
  CurveSceneReport report{.keys_written = rotation.size()};
  if (curve.position) {
    translation.times = rotation.times;
    report.positions_written = translation.size();
    clip.translations.push_back(std::move(translation));
  }
  clip.rotations.push_back(std::move(rotation));
  return report;
}

}  // namespace

Expected<void> write_curve_scene(const SampleOptions& options, const SampleRequest& request, const CurveScene& source) {
  const auto writing = scene_writing(options.output);
  if (!writing) return tl::unexpected(writing.error());
  if (scenes::scene_format_of(request.output) != &scenes::gltf_format)
    return usage_failure(
        "-o: found a file that holds every frame, wanted glTF, such as motion.glb; 'orispline convert "
        "--rate' makes BVH of it");
  if (!request.tolerance)
    if (auto fault = source.times.fault_as_keys()) return tl::unexpected(std::move(*fault));
  Clip clip{.name = std::string(file_name_of(request.input.path))};
  clip.name = clip.name.substr(0, clip.name.rfind('.'));
  CurveSceneReport report =
      request.tolerance ? add_cubics(clip, source.curve, request) : add_samples(clip, source.curve, source.times);
  report.input = request.input.path;
  report.output = request.output;
  report.method = request.method.name;
  report.keys = source.keys;
  return Skeleton::make({{.name = "body"}}).and_then([&](Skeleton skeleton) {
    scenes::Scene scene{.skeleton = std::move(skeleton)};
    scene.clips.push_back(std::move(clip));
    return write_scene(request.output, scene, *writing).and_then([&] { return summarise(options.summary, report); });
  });
}

}  // namespace orispline::cli
