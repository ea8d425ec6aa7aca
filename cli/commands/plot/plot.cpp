// SPDX-License-Identifier: Apache-2.0
#include "commands/plot/plot.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/report/motion_drawing.hpp>
#include <orispline/report/page_samples.hpp>

#include "options/file_places.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  std::vector<Method> methods;  ///< none: the one that the file names
  MethodOptions shape;          ///< of that one
  BodyAxis axis = BodyAxis::x;
  std::size_t ghosts = 0;
};

Expected<std::vector<Method>> methods_in(const PlotOptions& options) {
  auto methods = method_requests(options.methods, options.shape);
  if (methods && methods->size() > report::most_drawn_methods)
    return usage_failure(
        formatted("--method: found {} methods, wanted at most {}", methods->size(), report::most_drawn_methods));
  return methods;
}

Expected<std::size_t> ghosts_in(OptionText option) {
  return count_in(option, 2).and_then([&](std::size_t count) -> Expected<std::size_t> {
    if (count <= report::most_ghosts) return count;
    return wanted(option, formatted("at most {}", report::most_ghosts));
  });
}

Expected<Request> request_in(const PlotOptions& options) {
  const auto output = check_output_apart("-o", options.path, {{"INPUT", options.input.path}}).and_then([&] {
    return check_extension("-o", options.path, {".svg"});
  });
  if (!output) return tl::unexpected(output.error());
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .methods = checked(methods_in(options)),
                  .shape = options.shape,
                  .axis = checked(if_given("--axis", options.axis, choice_of(axis_choices))).value_or(BodyAxis::x),
                  .ghosts = checked(if_given("--ghosts", options.ghosts, ghosts_in)).value_or(0)};
  return std::move(checked).or_else(std::move(request));
}

std::string title_of(const Track& track) {
  const std::string start = track.epoch == Decimal() ? "" : formatted(", t = 0 at {} s", track.epoch.to_string());
  const std::size_t keys = track.keys.size();
  return formatted("{}: {} {}{}", track.name == io::standard_stream ? "standard input" : printable(track.name), keys,
                   keys == 1 ? "key" : "keys", start);
}

Expected<report::MotionPicture> picture_of(Request request) {
  auto input = io::KeyInput::open(request.input.path, request.input.read.recipe);
  if (!input) return tl::unexpected(std::move(input.error()));
  if (request.methods.size() < 2) {
    const auto named = request.methods.empty() ? std::nullopt : std::optional(request.methods.front());
    auto chosen = chosen_method(named, request.shape, *input, {default_method});
    if (!chosen) return tl::unexpected(std::move(chosen.error()));
    warn(chosen->warnings);
    request.methods = {std::move(chosen->method)};
  }
  request.input.read = read_for(request.methods, std::move(request.input.read));
  const auto file = io::read_track(std::move(*input), request.input.read, request.input.signs);
  if (!file) return tl::unexpected(file.error());
  const Track& track = file->track;
  const auto axis = static_cast<Eigen::Index>(request.axis);
  report::MotionPicture picture{.title = title_of(track),
                                .keys = report::page_keys(track.keys),
                                .body_axis = Eigen::Vector3d::Unit(axis),
                                .axis_name = std::string(axis_choices[static_cast<std::size_t>(axis)].first),
                                .ghosts = request.ghosts};
  std::vector<Warning> warnings = file->warnings;
  for (const Method& method : request.methods) {
    const auto curve = jobs::shaped_curve(method, track);
    if (!curve) return tl::unexpected(curve.error());
    std::ranges::move(warnings_of(method, track), std::back_inserter(warnings));
    picture.methods.push_back({.name = method.name, .samples = report::sampled(*curve, report::samples_to_draw)});
  }
  warn(warnings);
  return picture;
}

}  // namespace

Expected<void> plot(const PlotOptions& options) {
  return request_in(options).and_then(picture_of).and_then([&](const report::MotionPicture& picture) {
    return open_output(options.path).and_then([&](Noted<io::OutputFile> output) {
      return output.file.write(report::motion_drawing(picture).document()).and_then([&] {
        return output.file.finish();
      });
    });
  });
}

}  // namespace orispline::cli
