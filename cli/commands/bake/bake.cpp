// SPDX-License-Identifier: Apache-2.0
#include "commands/bake/bake.hpp"

#include <memory>
#include <utility>

#include <orispline/jobs/bake.hpp>
#include <orispline/jobs/baked_file.hpp>

#include "options/file_places.hpp"
#include "output/noted_output.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view binary = ".bin";

/// The command line, understood.
struct Request {
  InputRequest input;
  std::optional<Method> named;
  jobs::BakeSettings baking;
};

Expected<Request> request_in(const BakeArguments& options) {
  const auto output = check_output_apart("-o", options.output, {{"INPUT", options.input.path}})
                          .and_then([&] {
                            return check_extension("-o", options.output, {".json", binary});
                          })
                          .and_then([&] { return check_summary(options.summary, options.output, "curve"); });
  if (!output) return tl::unexpected(output.error());
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .named = checked(named_method(options.method, options.shape)),
                  .baking = checked(options_in<jobs::BakeSettings>(options.baking))};
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  return check_ranges(read->baking).map([&] { return std::move(*read); });
}

Expected<jobs::BakeOutcome> baked(const BakeArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  if (auto able = check_output(options.output); !able) return tl::unexpected(std::move(able.error()));
  auto input = io::KeyInput::open(request->input.path, request->input.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  auto chosen = chosen_method(request->named, options.shape, *input, {default_method});
  if (!chosen) return tl::unexpected(std::move(chosen.error()));
  request->input.read = read_for({&chosen->method, 1}, std::move(request->input.read));
  auto file = io::read_track(std::move(*input), request->input.read, request->input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  warn(file->warnings);
  return jobs::bake({.keys = std::make_shared<const Track>(std::move(file->track)),
                     .method = std::move(*chosen),
                     .options = request->baking});
}

Expected<void> write_file(const std::string& path, const std::string& content) {
  return open_output(path).and_then([&](Noted<io::OutputFile> output) {
    return output.file.write(content).and_then([&] { return output.file.finish(); });
  });
}

}  // namespace

Expected<void> bake(const BakeArguments& options) {
  return baked(options).and_then([&](jobs::BakeOutcome outcome) {
    warn(outcome.warnings);
    const bool is_binary = has_extension(options.output, binary);
    return write_file(options.output, is_binary ? baked_bytes(outcome) : baked_json(outcome)).and_then([&] {
      return summarise(options.summary, Written{options.input.path, options.output, "curve", std::move(outcome)});
    });
  });
}

}  // namespace orispline::cli
