// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_request.hpp"

#include <algorithm>
#include <numbers>

#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/fields/typed_numbers.hpp>

namespace orispline::cli {

namespace {

constexpr int default_csv_derivatives = 2;
constexpr int most_position_derivatives = 2;  // of the path: velocity and acceleration

Expected<int> derivatives_in(OptionText option) {
  const auto order = count_in(option, 0);
  if (!order || *order > 3) return wanted(option, "0, 1, 2 or 3");
  return static_cast<int>(*order);
}

Expected<double> share_in(OptionText option) {
  constexpr std::string_view what = "a number between 0 and 1";
  return positive_in(option, what).and_then([&](double share) -> Expected<double> {
    if (share < 1.0) return share;
    return wanted(option, what);
  });
}

Expected<io::SampleColumns> columns_in(const SampleArguments& options, const io::FormatInfo* input = nullptr) {
  FirstError checked;
  auto columns = checked(output_columns(options.output));
  const auto derivatives = checked(if_given("--derivatives", options.derivatives, derivatives_in));
  const auto frame = checked(if_given("--frame", options.frame, choice_of(frame_choices)));
  columns.derivatives = derivatives.value_or(0);
  if (input && !frame) columns = columns_like(*input, columns, options.output);
  const bool holds_rates = columns.format->holds.rates;
  columns.derivatives = derivatives.value_or(holds_rates ? default_csv_derivatives : 0);
  columns.frame = frame.value_or(io::Frame::body);
  columns.band = options.band.has_value();
  auto read = std::move(checked).or_else(std::move(columns));
  if (!read || holds_rates) return read;
  const auto refused = [&](OptionText option, std::string_view only) {
    return wanted(option, formatted("{} for {}, which has no columns for rates", only, read->format->file));
  };
  if (read->derivatives > 0) return refused({"--derivatives", *options.derivatives}, "0");
  if (read->frame == io::Frame::world) return refused({"--frame", *options.frame}, "body");
  if (read->band) return refused({"--band", *options.band}, "none");
  return read;
}

bool words_have(std::string_view text) {
  return std::ranges::find(words<Extrapolation>, text, &Word::word) != words<Extrapolation>.end();
}

bool names_times(const TimeOptions& times) { return times.rate || times.count || times.list; }

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
  if (!is_scene(options.output.path)) return check_format_is_of_rows(options.output);
  const bool cubics = !names_times(options.times);
  if (cubics && (options.times.from || options.times.to || options.times.include_end))
    return usage_failure("--from and --to: found cubics of the whole curve, wanted --rate or --count as well");
  for (const auto& [name, typed] :
       {std::pair("--extrapolate", options.extrapolate), std::pair("--outside", options.outside)})
    if (typed && *typed != "hold" && *typed != "error")
      return usage_failure(formatted("{}: found '{}' with a file of skeletons, wanted hold or error", name, *typed));
  if (options.truth) return usage_failure("--truth: found a file of skeletons as the output, wanted one of samples");
  if (options.derivatives || options.frame || options.band)
    return usage_failure(formatted("{}: found a file of skeletons, which has no columns for it, wanted a CSV file",
                                   options.band    ? "--band"
                                   : options.frame ? "--frame"
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
  if (names_times(options.times)) {
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
  if (!options.position_tolerance) return SampleRequest().position_tolerance;
  return measured_in({"--position-tolerance", *options.position_tolerance}, units::length);
}

/// Those of a file of skeletons are where its keys are, unless they are asked for.
Expected<TimeRequest> times_in(const SampleArguments& options) {
  return clock_in(options.input).and_then([&](const io::Clock& clock) {
    TimeOptions times = options.times;
    if (is_scene(options.output.path) && !names_times(times)) times.count = "1";
    return time_request(times, clock);
  });
}

Progress::Show progress_for(const SampleArguments& options) {
  const bool in_the_way = options.summary.quiet || options.output.path == io::standard_stream;
  return in_the_way ? Progress::Show::never : Progress::Show::on_terminal;
}

/// What samples outside the curve do, as either of two options has it.
Expected<std::optional<Extrapolation>> extrapolation_in(const SampleArguments& options) {
  if (options.extrapolate && options.outside)
    return usage_failure("--outside: found --extrapolate too, which says the same, wanted one of them");
  const auto& typed = options.outside ? options.outside : options.extrapolate;
  if (!typed) return std::nullopt;
  if (*typed == leave_out) return Extrapolation::hold;
  const OptionText option{options.outside ? "--outside" : "--extrapolate", *typed};
  if (words_have(*typed))
    return word_in<Extrapolation>(option).map([](Extrapolation how) { return std::optional(how); });
  return wanted(option, formatted("{}|{}", one_of(words<Extrapolation>), leave_out));
}

bool leaves_out(const SampleArguments& options) {
  return options.outside.value_or(options.extrapolate.value_or("")) == leave_out;
}

Expected<bool> mark_gaps_in(const SampleArguments& options) {
  if (!options.mark_gaps) return false;
  if (is_scene(options.output.path)) return usage_failure("--mark-gaps: found a file of skeletons, wanted rows");
  return output_columns(options.output).and_then([](const io::SampleColumns& columns) -> Expected<bool> {
    if (columns.format->holds.forms) return true;
    return usage_failure(
        formatted("--mark-gaps: found {}, which has no empty rows, wanted a CSV or NumPy file", columns.format->file));
  });
}

/// Standard input can be read once only.
bool reads_standard_input_twice(const SampleArguments& options) {
  const int readers = (options.input.path == io::standard_stream) + (options.times.list == io::standard_stream) +
                      (options.truth == io::standard_stream);
  return readers > 1;
}

}  // namespace

Expected<SampleRequest> sample_request(const SampleArguments& options) {
  if (auto fits = check_into_scene(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  SampleRequest request{.input = checked(input_request(options.input)),
                        .named = checked(named_method(options.method, options.shape)),
                        .shape = options.shape,
                        .times = checked(times_in(options)),
                        .columns = is_scene(options.output.path) ? io::SampleColumns() : checked(columns_in(options)),
                        .extrapolation = checked(extrapolation_in(options)).value_or(Extrapolation::hold),
                        .outside = leaves_out(options) ? LeftOut::yes : LeftOut::no,
                        .mark_gaps = checked(mark_gaps_in(options)),
                        .threads = checked(threads_in(options.inputs.threads)),
                        .output = options.output.path,
                        .truth = options.truth,
                        .align = options.align,
                        .band = checked(if_given("--band", options.band, share_in)),
                        .tolerance = checked(tolerance_in(options)),
                        .position_tolerance = checked(position_tolerance_in(options)),
                        .progress = progress_for(options)};
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (auto* const list = std::get_if<TimesFile>(&read->times.spacing)) list->reading = read->input.read;
  if (auto fits = check_summary(options.summary, options.output.path, "samples"); !fits)
    return tl::unexpected(std::move(fits.error()));
  std::vector<OtherFile> others{{"INPUT", options.input.path}};
  if (options.times.list) others.push_back({"that of --times", *options.times.list});
  if (options.truth) others.push_back({"that of --truth", *options.truth});
  if (auto apart = check_output_apart(options.output.option, options.output.path, others); !apart)
    return tl::unexpected(std::move(apart.error()));
  if (options.align && !options.truth) return usage_failure("--align: found no --truth, wanted one to align");
  if (reads_standard_input_twice(options))
    return usage_failure("found '-' for several of INPUT, --times and --truth, wanted it for one at most");
  return read;
}

io::SampleColumns columns_for(const SampleArguments& options, const io::FormatInfo& input) {
  return columns_in(options, &input).value();
}

Expected<std::vector<Warning>> settle_method(SampleRequest& request, const io::KeyInput& keys) {
  return chosen_method(request.named, request.shape, keys, {default_method}).map([&](jobs::ChosenMethod chosen) {
    request.method = std::move(chosen.method);
    request.input.read = read_for({&request.method, 1}, std::move(request.input.read));
    request.input.signs = request.input.signs.value_or(keys.recipe().signs);
    return std::move(chosen.warnings);
  });
}

io::SampleColumns with_positions(io::SampleColumns columns, bool positions) {
  columns.positions = positions;
  if (positions) columns.position_derivatives = std::min(columns.derivatives, most_position_derivatives);
  return columns;
}

}  // namespace orispline::cli
