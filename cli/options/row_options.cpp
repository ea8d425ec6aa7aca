// SPDX-License-Identifier: Apache-2.0
#include "options/row_options.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/times_file.hpp>

#include "options/scene_input.hpp"

namespace orispline::cli {

namespace {

using jobs::TimeBound;
using Rate = SampleGrid::Rate;
using Count = SampleGrid::Count;
using Spacing = decltype(jobs::TimeRequest::spacing);

/// What --outside and --extrapolate take beside the words of Extrapolation.
constexpr std::string_view leave_out = "leave-out";

constexpr int default_csv_derivatives = 2;
constexpr int most_position_derivatives = 2;  // of the path: velocity and acceleration

Expected<int> derivatives_in(OptionText option) {
  const auto order = count_in(option, 0);
  if (!order || *order > 3) return wanted(option, "0, 1, 2 or 3");
  return static_cast<int>(*order);
}

Rate rate_of(const Fraction& per_second) {
  return {per_second.numerator().to_double(), per_second.denominator().to_double()};
}

Expected<Spacing> rate_in(OptionText rate) {
  constexpr std::string_view what = "a number of samples per second greater than 0";
  rate = without_unit(rate, "Hz");
  if (rate.text.find('/') == std::string_view::npos)
    return positive_in(rate, what).map([](double hertz) { return Spacing(Rate{hertz}); });
  return fraction_in(rate, what).map([](const Fraction& per_second) { return Spacing(rate_of(per_second)); });
}

/// The times of a file that is read as INPUT is.
Expected<Spacing> list_in(const std::string& path, const InputOptions& input) {
  return input_request(input).map([&](const InputRequest& request) {
    return Spacing([path, read = request.read](const Decimal& epoch) {
      return io::read_times(path, epoch, read).map([&](io::TimesList list) {
        return jobs::ListedTimes{path, std::move(list.times), std::move(list.lines), std::move(list.warnings)};
      });
    });
  });
}

/// A file of skeletons has its samples where its keys are, unless others are asked for.
Expected<Spacing> spacing_in(const RowOptions& options, const InputOptions& input, const io::Clock& clock,
                             bool into_scene) {
  const int given = options.rate.has_value() + options.count.has_value() + options.list.has_value();
  if (given == 0 && into_scene) return Spacing(Count{1});
  if (given == 0 && clock.frames_per_second) return Spacing(rate_of(*clock.frames_per_second));
  if (given != 1)
    return usage_failure(formatted("found {} of --rate, --count and --times, wanted one of them, such as --rate 100",
                                   given == 0 ? "none" : std::to_string(given)));
  if (options.list) return list_in(*options.list, input);
  if (options.rate) return rate_in({"--rate", *options.rate});
  return count_in({"--count", *options.count}, 1).map([](std::size_t n) { return Spacing(Count{n}); });
}

/// `5`, or `+5` since the first key.
auto bound_in(const io::Clock& clock) {
  return [&clock](OptionText option) -> Expected<TimeBound> {
    option = without_unit(option, "s");
    const bool since_first_key = option.text.starts_with('+');
    auto time = io::time_in(option.text.substr(since_first_key ? 1 : 0), clock);
    if (time) return TimeBound{*time, since_first_key};
    time.error().code = ErrorCode::bad_argument;
    time.error().message = formatted("{}: {}", option.option, time.error().message);
    return tl::unexpected(std::move(time.error()));
  };
}

Expected<jobs::TimeRequest> time_request(const RowOptions& options, const InputOptions& input, const io::Clock& clock,
                                         bool into_scene) {
  using Last = SampleGrid::LastSample;
  FirstError checked;
  jobs::TimeRequest request{.spacing = checked(spacing_in(options, input, clock, into_scene)),
                            .from = checked(if_given("--from", options.from, bound_in(clock))),
                            .to = checked(if_given("--to", options.to, bound_in(clock))),
                            .last = options.include_end ? Last::at_end : Last::before_end,
                            .any_number = options.yes,
                            .cure = formatted("'orispline {} --yes' writes any number", options.command)};
  auto read = std::move(checked).or_else(std::move(request));
  if (read && options.include_end && !std::holds_alternative<Rate>(read->spacing))
    return usage_failure(options.list
                             ? "--include-end: found --times, whose file says which times to sample; wanted --rate"
                             : "--include-end: found --count, which includes both ends already; wanted --rate");
  if (read && options.list && (options.from || options.to))
    return usage_failure("--times: its file says which times to sample; wanted neither --from nor --to");
  if (read && read->from && read->to && read->from->since_first_key == read->to->since_first_key &&
      read->from->time > read->to->time)
    return usage_failure(formatted("--from {} is after --to {}", *options.from, *options.to));
  return read;
}

Expected<io::SampleColumns> columns_in(const RowOptions& options, const OutputOptions& output,
                                       const io::FormatInfo* input = nullptr) {
  FirstError checked;
  auto columns = checked(output_columns(output));
  const auto derivatives = checked(if_given("--derivatives", options.derivatives, derivatives_in));
  const auto frame = checked(if_given("--frame", options.frame, choice_of(frame_choices)));
  columns.derivatives = derivatives.value_or(0);
  if (input && !frame) columns = columns_like(*input, columns, output);
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

Expected<double> share_in(OptionText option) {
  constexpr std::string_view what = "a number between 0 and 1";
  return positive_in(option, what).and_then([&](double share) -> Expected<double> {
    if (share < 1.0) return share;
    return wanted(option, what);
  });
}

/// What samples outside the curve do, as either of two options has it.
Expected<std::optional<Extrapolation>> extrapolation_in(const RowOptions& options) {
  if (options.extrapolate && options.outside)
    return usage_failure("--outside: found --extrapolate too, which says the same, wanted one of them");
  const auto& typed = options.outside ? options.outside : options.extrapolate;
  if (!typed) return std::nullopt;
  if (*typed == leave_out) return Extrapolation::hold;
  const OptionText option{options.outside ? "--outside" : "--extrapolate", *typed};
  if (auto how = word_in<Extrapolation>(option)) return *how;
  return wanted(option, formatted("{}|{}", one_of(words<Extrapolation>), leave_out));
}

bool leaves_out(const RowOptions& options) {
  return options.outside.value_or(options.extrapolate.value_or("")) == leave_out;
}

Expected<bool> mark_gaps_in(const RowOptions& options, const OutputOptions& output) {
  if (!options.mark_gaps) return false;
  if (is_scene(output.path)) return usage_failure("--mark-gaps: found a file of skeletons, wanted rows");
  return output_columns(output).and_then([](const io::SampleColumns& columns) -> Expected<bool> {
    if (columns.format->holds.forms) return true;
    return usage_failure(
        formatted("--mark-gaps: found {}, which has no empty rows, wanted a CSV or NumPy file", columns.format->file));
  });
}

}  // namespace

std::string_view first_given(const RowOptions& o) {
  const std::pair<bool, std::string_view> options[] = {{o.rate.has_value(), "--rate"},
                                                       {o.count.has_value(), "--count"},
                                                       {o.list.has_value(), "--times"},
                                                       {o.include_end, "--include-end"},
                                                       {o.from.has_value(), "--from"},
                                                       {o.to.has_value(), "--to"},
                                                       {o.extrapolate.has_value(), "--extrapolate"},
                                                       {o.outside.has_value(), "--outside"},
                                                       {o.mark_gaps, "--mark-gaps"},
                                                       {o.yes, "--yes"},
                                                       {o.derivatives.has_value(), "--derivatives"},
                                                       {o.frame.has_value(), "--frame"},
                                                       {o.band.has_value(), "--band"}};
  const auto* const given = std::ranges::find(options, true, &std::pair<bool, std::string_view>::first);
  return given == std::end(options) ? "" : given->second;
}

void add_time_options(Command& app, RowOptions& o, const std::string& group, const std::string& rate) {
  o.command = app.name;
  app.add_option("--rate", o.rate, rate)->type_name("HZ")->group(group);
  app.add_flag("--include-end", o.include_end, "Also write a sample at the end time")->group(group);
  app.add_option("--count", o.count, "Number of samples, both ends included")->type_name("N")->group(group);
  app.add_option("--times", o.list, "File with one time a line, in any order")->type_name(file_type)->group(group);
  app.add_option(
         "--from", o.from,
         "Start in the time of INPUT: seconds, 12f with --fps, ISO 8601; or +T since its first key [of the curve]")
      ->type_name("T")
      ->group(group);
  app.add_option("--to", o.to, "End, stated like --from [of the curve]")->type_name("T")->group(group);
  const std::string beyond = formatted("{}|{}", one_of(words<Extrapolation>), leave_out);
  app.add_option("--extrapolate", o.extrapolate,
                 "What samples outside the curve do: hold the end orientation, fail, be NaN, keep the rate "
                 "of the end, or follow the formula of the end segment [hold]; or they are left out")
      ->type_name(beyond)
      ->group(group);
  app.add_option("--outside", o.outside, "The same as --extrapolate")->type_name(beyond)->group(group);
}

void add_row_options(Command& app, RowOptions& o) {
  const std::string group = "Output";
  app.add_flag("--mark-gaps", o.mark_gaps, "Write rows with a time and empty cells for samples in gaps of the keys")
      ->group(group);
  app.add_flag("--yes", o.yes, "Write any number of samples, above 1e9 too")->group(group);
  app.add_option("--derivatives", o.derivatives, "Highest order of the rates [2 for CSV and npy, else 0]")
      ->type_name("0|1|2|3")
      ->group(group);
  app.add_option("--frame", o.frame, "Frame of the angular rates [body]")
      ->type_name(one_of(frame_choices))
      ->group(group);
}

void add_band_option(Command& app, RowOptions& o) {
  app.add_option(
         "--band", o.band,
         "Column band [rad]: the radius that is meant to hold this share of the true motion, such as 0.9, about "
         "the curve of 'measured' or of smoothed keys")
      ->type_name("SHARE")
      ->group("Output");
}

Expected<RowRequest> row_request(const RowOptions& options, const InputOptions& input, const OutputOptions& output) {
  const bool into_scene = is_scene(output.path);
  FirstError checked;
  RowRequest request{.times = checked(clock_in(input).and_then(
                         [&](const io::Clock& clock) { return time_request(options, input, clock, into_scene); })),
                     .columns = into_scene ? io::SampleColumns() : checked(columns_in(options, output)),
                     .extrapolation = checked(extrapolation_in(options)).value_or(Extrapolation::hold),
                     .outside = leaves_out(options) ? jobs::OutsideRows::left_out : jobs::OutsideRows::made,
                     .mark_gaps = checked(mark_gaps_in(options, output)),
                     .band = checked(if_given("--band", options.band, share_in))};
  return std::move(checked).or_else(std::move(request));
}

io::SampleColumns columns_for(const RowOptions& options, const OutputOptions& output, const io::FormatInfo& input) {
  return columns_in(options, output, &input).value();
}

io::SampleColumns with_positions(io::SampleColumns columns, bool positions) {
  columns.positions = positions;
  if (positions) columns.position_derivatives = std::min(columns.derivatives, most_position_derivatives);
  return columns;
}

}  // namespace orispline::cli
