// SPDX-License-Identifier: Apache-2.0
#include "commands/plot/plot.hpp"

#include <memory>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/report/motion_drawing.hpp>

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
  jobs::BodyAxis axis = jobs::BodyAxis::x;
  std::size_t ghosts = 0;
};

Expected<std::vector<Method>> methods_in(const PlotArguments& options) {
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

Expected<Request> request_in(const PlotArguments& options) {
  const auto output = check_output_apart("-o", options.path, {{"INPUT", options.input.path}}).and_then([&] {
    return check_extension("-o", options.path, {".svg"});
  });
  if (!output) return tl::unexpected(output.error());
  FirstError checked;
  Request request{
      .input = checked(input_request(options.input)),
      .methods = checked(methods_in(options)),
      .shape = options.shape,
      .axis = checked(if_given("--axis", options.axis, choice_of(axis_choices))).value_or(jobs::BodyAxis::x),
      .ghosts = checked(if_given("--ghosts", options.ghosts, ghosts_in)).value_or(0)};
  return std::move(checked).or_else(std::move(request));
}

Expected<jobs::PlotOutcome> drawn(Request request) {
  auto input = io::KeyInput::open(request.input.path, request.input.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  if (request.methods.size() < 2) {
    const auto named = request.methods.empty() ? std::nullopt : std::optional(request.methods.front());
    auto chosen = chosen_method(named, request.shape, *input, {default_method});
    if (!chosen) return tl::unexpected(std::move(chosen.error()));
    warn(chosen->warnings);
    request.methods = {std::move(chosen->method)};
  }
  request.input.read = read_for(request.methods, std::move(request.input.read));
  auto file = io::read_track(std::move(*input), request.input.read, request.input.signs);
  if (!file) return tl::unexpected(file.error());
  const std::string name = request.input.path == io::standard_stream ? "standard input" : file->track.name;
  return jobs::plot({.name = name,
                     .keys = std::make_shared<const Track>(std::move(file->track)),
                     .methods = std::move(request.methods),
                     .axis = request.axis,
                     .ghosts = request.ghosts})
      .map([&](jobs::PlotOutcome outcome) {
        outcome.warnings.insert(outcome.warnings.begin(), file->warnings.begin(), file->warnings.end());
        return outcome;
      });
}

}  // namespace

Expected<void> plot(const PlotArguments& options) {
  return request_in(options).and_then(drawn).and_then([&](const jobs::PlotOutcome& outcome) {
    warn(outcome.warnings);
    return open_output(options.path).and_then([&](Noted<io::OutputFile> output) {
      return output.file.write(outcome.svg).and_then([&] { return output.file.finish(); });
    });
  });
}

}  // namespace orispline::cli
