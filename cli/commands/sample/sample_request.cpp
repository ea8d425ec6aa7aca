// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_request.hpp"

#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/fields/typed_numbers.hpp>
#include <orispline/jobs/sample_steps.hpp>

#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view default_cubic_tolerance = "0.01deg";

Expected<double> measured_in(OptionText option, std::span<const Unit> units) {
  return typed::measured(option.text, units, 1)
      .map([](const Measured& found) { return found.numbers.front(); })
      .map_error([&](Error error) {
        error.message = formatted("{}: {}", option.option, error.message);
        return error;
      });
}

/// What a file of skeletons has no room for.
Expected<void> check_into_scene(const SampleArguments& options) {
  if (!is_scene(options.output.path)) return check_no_skeleton_format(options.output);
  const bool cubics = !options.rows.names_times();
  if (cubics && (options.rows.from || options.rows.to || options.rows.include_end))
    return usage_failure("--from and --to: found cubics of the whole curve, wanted --rate or --count as well");
  for (const auto& [name, typed] :
       {std::pair("--extrapolate", options.rows.extrapolate), std::pair("--outside", options.rows.outside)})
    if (typed && *typed != "hold" && *typed != "error")
      return usage_failure(formatted("{}: found '{}' with a file of skeletons, wanted hold or error", name, *typed));
  if (options.truth) return usage_failure("--truth: found a file of skeletons as the output, wanted one of samples");
  if (options.rows.derivatives || options.rows.frame || options.rows.band)
    return usage_failure(formatted("{}: found a file of skeletons, which has no columns for it, wanted a CSV file",
                                   options.rows.band    ? "--band"
                                   : options.rows.frame ? "--frame"
                                                        : "--derivatives"));
  return {};
}

/// Of a file of skeletons: how near its cubics are to the curve, unless it gets samples.
Expected<std::optional<double>> tolerance_in(const SampleArguments& options) {
  if (!is_scene(options.output.path)) {
    if (options.tolerance || options.position_tolerance)
      return usage_failure(formatted("{}: found samples in rows, wanted a file of cubics, such as motion.glb",
                                     options.tolerance ? "--tolerance" : "--position-tolerance"));
    return std::optional<double>();
  }
  if (options.rows.names_times()) {
    if (!options.tolerance && !options.position_tolerance) return std::optional<double>();
    return usage_failure("--tolerance: found --rate, --count or --times too, wanted one of them");
  }
  const std::string text = options.tolerance.value_or(std::string(default_cubic_tolerance));
  const OptionText typed{"--tolerance", text};
  return measured_in(typed, units::angle).and_then([&](double angle) -> Expected<std::optional<double>> {
    constexpr double rounding = 1e-12;
    if (angle <= std::numbers::pi + rounding) return angle;
    return wanted(typed, "180deg at most, which is as far as orientations can be apart");
  });
}

Expected<double> position_tolerance_in(const SampleArguments& options) {
  if (!options.position_tolerance) return SampleRequest{}.position_tolerance;
  return measured_in({"--position-tolerance", *options.position_tolerance}, units::length);
}

Progress::Show progress_for(const SampleArguments& options) {
  const bool in_the_way = options.summary.quiet || options.output.path == io::standard_stream;
  return in_the_way ? Progress::Show::never : Progress::Show::on_terminal;
}

/// Standard input can be read once only.
bool reads_standard_input_twice(const SampleArguments& options) {
  const int readers = (options.input.path == io::standard_stream) + (options.rows.list == io::standard_stream) +
                      (options.truth == io::standard_stream);
  return readers > 1;
}

/// What does not fit to it.
Expected<void> check_stored(const SampleArguments& options) {
  if (any_given(options.shape))
    return usage_failure(
        formatted("{}: found the motion that the file says, which has its shape, wanted --method as well",
                  first_given(options.shape)));
  if (options.rows.band) return usage_failure("--band: found the motion that the file says, wanted --method measured");
  if (options.truth) return usage_failure("--truth: found the motion that the file says, wanted --method as well");
  if (is_scene(options.output.path))
    return usage_failure("-o: found a file of skeletons, wanted one of samples, or 'orispline convert' for the keys");
  return {};
}

}  // namespace

Expected<SampleRequest> sample_request(const SampleArguments& options) {
  if (auto fits = check_into_scene(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  SampleRequest request{.input = checked(input_request(options.input)),
                        .named = checked(named_method(options.method, options.shape)),
                        .shape = options.shape,
                        .rows = checked(row_request(options.rows, options.input, options.output)),
                        .threads = checked(threads_in(options.inputs.threads)),
                        .output = options.output.path,
                        .truth = options.truth,
                        .align = options.align,
                        .tolerance = checked(tolerance_in(options)),
                        .position_tolerance = checked(position_tolerance_in(options)),
                        .progress = progress_for(options)};
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (auto fits = check_summary(options.summary, options.output.path, "samples"); !fits)
    return tl::unexpected(std::move(fits.error()));
  std::vector<OtherFile> others{{"INPUT", options.input.path}};
  if (options.rows.list) others.push_back({"that of --times", *options.rows.list});
  if (options.truth) others.push_back({"that of --truth", *options.truth});
  if (auto apart = check_output_apart(options.output.option, options.output.path, others); !apart)
    return tl::unexpected(std::move(apart.error()));
  if (options.align && !options.truth) return usage_failure("--align: found no --truth, wanted one to align");
  if (reads_standard_input_twice(options))
    return usage_failure("found '-' for several of INPUT, --times and --truth, wanted it for one at most");
  return read;
}

Expected<std::vector<Warning>> settle_method(SampleRequest& request, const io::KeyInput& keys) {
  return chosen_method(request.named, request.shape, keys, {default_method}).map([&](jobs::ChosenMethod chosen) {
    request.method = std::move(chosen.method);
    request.input.read = read_for({&request.method, 1}, std::move(request.input.read));
    if (request.rows.band) read_band(request.input.read);
    request.input.signs = request.input.signs.value_or(keys.recipe().signs);
    return std::move(chosen.warnings);
  });
}

bool asks_for_stored_motion(const SampleArguments& options) {
  return is_scene(options.input, options.input.path) &&
         options.method.value_or(std::string(jobs::stored_method)) == jobs::stored_method;
}

Expected<SampleRequest> stored_request(const SampleArguments& options) {
  if (auto fits = check_stored(options); !fits) return tl::unexpected(std::move(fits.error()));
  SampleArguments without_method = options;
  without_method.method.reset();
  return sample_request(without_method);
}

}  // namespace orispline::cli
