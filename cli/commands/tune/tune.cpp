// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/tune/tension_model.hpp>

#include "commands/tune/tune_report.hpp"
#include "options/inertia.hpp"
#include "output/keys_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {
namespace {

constexpr auto default_objective = orispline::Objective::acceleration;

/// The command line, understood.
struct Request {
  InputRequest input;
  Method method;
  orispline::TuneOptions tuning;
};

Expected<orispline::Interval> bounds_in(OptionText option) {
  const auto numbers = numbers_in(option);
  if (!numbers || numbers->size() != 2 || !((*numbers)[0] < (*numbers)[1]))
    return wanted(option, "LOWEST,HIGHEST, the lower one first");
  return orispline::Interval{(*numbers)[0], (*numbers)[1]};
}

Expected<std::vector<std::string>> names_in(OptionText option) {
  std::vector<std::string> names;
  for (const std::string_view name : pieces_of(option.text, ',')) names.emplace_back(name);
  return names;
}

/// What the options ask of each other.
Expected<void> agree(const TuneOptions& options, const Request& request) {
  using orispline::Objective;
  if (orispline::tunable_parameters(request.method.name).empty())
    return usage_failure(formatted("--method: {} has no tensions to tune, wanted one of {}", request.method.name,
                                   orispline::tunable_methods()));
  const bool fits = request.tuning.objective == Objective::fit;
  if (fits && !options.reference) return usage_failure("--objective fit: wanted --reference FILE as well");
  if (!fits && options.reference) return usage_failure("--reference: wanted --objective fit as well");
  if (request.tuning.objective == Objective::torque && !options.inertia)
    return usage_failure("--objective torque: wanted --inertia JX,JY,JZ as well");
  if (options.output.empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  if (auto checked = check_summary(options.summary, options.output, "keys"); !checked) return checked;
  if (options.input.path == io::standard_stream && options.reference == io::standard_stream)
    return usage_failure("found '-' for INPUT and --reference, wanted it for one at most");
  return {};
}

Expected<Request> request_in(const TuneOptions& options) {
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .method = checked(method_request(options.method, options.shape)),
                  .tuning = {}};
  request.tuning = {
      .objective =
          checked(if_given("--objective", options.objective, choice_of(objective_choices))).value_or(default_objective),
      .inertia = checked(if_given("--inertia", options.inertia, inertia_in)).value_or(Eigen::Matrix3d::Identity()),
      .bounds = checked(if_given("--bounds", options.bounds, bounds_in)),
      .parameters = checked(if_given("--free", options.free, names_in)).value_or(std::vector<std::string>())};
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (auto agreed = agree(options, *read); !agreed) return tl::unexpected(std::move(agreed.error()));
  read->input.read.parameters = open_parameters(read->method);
  read->input.read.rate_orders = family_of(read->method).rate_orders;
  read->input.read.keep_table = true;
  return read;
}

/// A recording in the times of the keys.
struct Reference {
  std::vector<double> times;
  std::vector<Eigen::Quaterniond> orientations;
};

Expected<Reference> read_reference(const std::string& path, const Track& keys, InputRequest reading) {
  reading.read.parameters.clear();
  reading.read.keep_table = false;
  const auto file = io::read_track(path, reading.read, reading.signs);
  if (!file) return tl::unexpected(file.error());
  const Track& samples = file->track;
  const double shift = (samples.epoch - keys.epoch).to_double();
  Reference reference{{samples.keys.times().begin(), samples.keys.times().end()},
                      {samples.keys.orientations().begin(), samples.keys.orientations().end()}};
  for (double& t : reference.times) t += shift;
  return reference;
}

Expected<orispline::Tuning> tuned(Request request, const TuneOptions& options, const Track& track) {
  Reference reference;
  if (options.reference) {
    auto read = read_reference(*options.reference, track, request.input);
    if (!read) return tl::unexpected(std::move(read.error()));
    reference = std::move(*read);
    request.tuning.reference = {reference.times, reference.orientations};
  }
  return orispline::tune(track, request.method, request.tuning).map_error([&](Error error) {
    return placed(track, std::move(error));
  });
}

/// The keys with the values that were found; what their table states itself keeps its text there.
Track written_track(const orispline::Tuning& tuning) {
  Track keys = tuning.track;
  std::erase_if(keys.settings, [&](const auto& column) {
    return std::ranges::find(tuning.parameters, column.first) == tuning.parameters.end();
  });
  return keys;
}

}  // namespace

Expected<void> tune(const TuneOptions& options) {
  const auto request = request_in(options);
  if (!request) return tl::unexpected(request.error());
  const bool by_torque = request->tuning.objective == orispline::Objective::torque;
  if (by_torque) warn_if_any(inertia_warning(request->tuning.inertia));
  const auto file = io::read_track(request->input.path, request->input.read, request->input.signs);
  if (!file) return tl::unexpected(file.error());
  auto tuning = tuned(*request, options, file->track);
  if (!tuning) return tl::unexpected(std::move(tuning.error()));
  TuneReport report{.input = options.input.path,
                    .output = options.output,
                    .objective = request->tuning.objective,
                    .times = {file->track.keys.times().begin(), file->track.keys.times().end()},
                    .tuning = std::move(*tuning)};
  for (double& t : report.times) t += file->track.epoch.to_double();
  return write_keys(options.output, written_track(report.tuning)).and_then([&] {
    return summarise(options.summary, report);
  });
}

}  // namespace orispline::cli
