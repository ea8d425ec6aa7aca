// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <orispline/base/first_error.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs/align.hpp>
#include <orispline/jobs/bake.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/mean.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/jobs/task_request.hpp>
#include <orispline/jobs/tune.hpp>

// The tasks on tracks and gyros: what is stated by names becomes a request, and its outcome what all tasks have.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

Expected<ChosenMethod> method_in(const TaskRequest& request, const Track& keys, const UsualMethod& usual) {
  if (request.method) return *request.method;
  const std::string* const text = request.option("method");
  if (!text) return chosen_method(std::nullopt, keys, usual);
  return method_from_text(*text).and_then([&](const Method& named) { return chosen_method(named, keys, usual); });
}

/// Null where no gyro is stated under that name.
std::shared_ptr<const GyroTrack> gyro_in(const TaskRequest& request, std::string_view name) {
  const TaskValue* const value = request.value(name);
  const auto* const gyro = value ? std::get_if<std::shared_ptr<const GyroTrack>>(value) : nullptr;
  return gyro ? *gyro : nullptr;
}

/// Wanted where an option of smoothing is stated.
Expected<std::optional<SmoothOptions>> smoothing_in(const TaskRequest& request) {
  auto wanted = flag(request, "smooth");
  if (!wanted) return tl::unexpected(std::move(wanted.error()));
  for (const FieldInfo& field : fields_of<SmoothOptions>()) *wanted = *wanted || is_stated(request, field.name);
  if (!*wanted && !is_stated(request, "cutoff")) return std::nullopt;
  return smoothing_options_in(request).map([](const SmoothOptions& options) { return std::optional(options); });
}

/// Of a recording without another one.
Expected<std::vector<Decimation>> decimations_in(const TaskRequest& request) {
  if (!request.decimations.empty()) return request.decimations;
  if (!request.input("reference"))
    return options_in<Decimation>(request).and_then([](const Decimation& decimation) {
      return check_ranges(decimation).map([&] { return std::vector{decimation}; });
    });
  for (const FieldInfo& field : fields_of<Decimation>())
    if (request.stated(field.name))
      return bad_option(field.name, "found a `reference` as well, wanted samples of the keys or a reference for them");
  return std::vector<Decimation>();
}

/// What several outcomes say, as one.
TaskOutcome together(std::vector<TaskOutcome> outcomes) {
  if (outcomes.size() == 1) return std::move(outcomes.front());
  TaskOutcome all{.document = Json::array()};
  for (TaskOutcome& one : outcomes) {
    all.document.push_back(one.document);
    all.summary += one.summary;
    std::ranges::copy(one.warnings, std::back_inserter(all.warnings));
    std::ranges::move(std::exchange(one.tracks, {}), std::back_inserter(all.tracks));
  }
  all.parts = std::move(outcomes);
  return all;
}

/// The rates with times since the epoch of the recording.
std::shared_ptr<const GyroRates> rates_beside(const Track& recording, const GyroTrack& gyro) {
  auto rates = std::make_shared<GyroRates>(gyro.rates);
  if (gyro.epoch == recording.epoch) return rates;
  for (std::size_t k = 0; k < rates->times.size(); ++k)
    rates->times[k] = (gyro.time_of(k) - recording.epoch).to_double();
  return rates;
}

/// The keys, with their standard deviations as settings behind all others.
Track with_sigmas(const Smoothing& smoothed) {
  Track track = smoothed.track;
  if (!smoothed.sigmas) return track;
  const auto add = [&track](std::string_view letters, const std::vector<Eigen::Vector3d>& vectors) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      std::vector<double>& column = track.settings[formatted("sigma_{}{}", letters, "xyz"[axis])];
      column.clear();
      for (const Eigen::Vector3d& v : vectors) column.push_back(v[axis]);
    }
  };
  add("", smoothed.sigmas->orientations);
  add("w", smoothed.sigmas->angular_velocities);
  return track;
}

/// The keys with the values that were found; what their table states itself keeps its text there.
Track tuned_track(const TuneOutcome& outcome) {
  const Track& given = *outcome.request.keys;
  Track keys = outcome.tuning.track;
  std::erase_if(keys.settings, [&](const auto& column) {
    const auto same = given.settings.find(column.first);
    return same != given.settings.end() && *same == column && !given.table.rows.empty();
  });
  return keys;
}

/// All but the recordings.
Expected<ReduceRequest> reduce_request_in(const TaskRequest& request) {
  if (auto fits = check_unset(request, {"closed", "position_scale"},
                              "found orientations at times, wanted the clips of a skeleton");
      !fits)
    return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  ReduceRequest job{.recordings = {},
                    .options = checked(options_in<ReduceOptions>(request)),
                    .smoothing = checked(smoothing_in(request)),
                    .threads = checked(threads_in(request))};
  if (auto methods = checked(methods_in(request))) {
    job.methods.clear();
    for (LabelledMethod& one : *methods) job.methods.push_back(std::move(one.method));
  }
  return std::move(checked).or_else(std::move(job));
}

/// All but the recordings.
Expected<CompareRequest> compare_request_in(const TaskRequest& request) {
  FirstError checked;
  CompareRequest job{.decimations = checked(decimations_in(request)),
                     .methods = all_methods(),
                     .tune = checked(flag(request, "tune")),
                     .align = checked(flag(request, "align")),
                     .measured = checked(options_in<MeasureOptions>(request)),
                     .has_inertia = is_stated(request, "inertia"),
                     .threads = checked(threads_in(request))};
  if (const std::string* const word = request.option("sort")) job.sort = *word;
  if (auto methods = checked(methods_in(request))) {
    job.methods = std::move(*methods);
    job.named = request.named;
    if (request.methods.empty())
      for (const LabelledMethod& one : job.methods) job.named.push_back(one.label);
  }
  return std::move(checked).or_else(std::move(job));
}

Recording recording_in(const TaskRequest& request, std::string_view name) {
  if (auto gyro = gyro_in(request, name)) return gyro;
  return request.input(name);
}

Expected<TaskOutcome> align_rates(const TaskRequest& request, const AlignOptions& options, const Progress& progress) {
  return jobs::align_rates(
             {.moved = recording_in(request, "moved"), .fixed = recording_in(request, "fixed"), .options = options},
             progress)
      .map([](RateAlignOutcome outcome) {
        const auto aligned = outcome.aligned;
        TaskOutcome all = told(std::move(outcome));
        if (const auto* const track = std::get_if<Track>(&aligned)) all.tracks = {*track};
        else all.gyros = {std::get<GyroTrack>(aligned)};
        return all;
      });
}

}  // namespace

Expected<TaskOutcome> run_smooth(const TaskRequest& request, const Progress& progress) {
  return smoothing_options_in(request)
      .and_then([&](const SmoothOptions& options) {
        SmoothRequest job{.recording = request.input("recording"), .options = options};
        if (const auto gyro = gyro_in(request, "gyro")) job.gyro = rates_beside(*job.recording, *gyro);
        return smooth(std::move(job), progress);
      })
      .map_error([&](Error error) { return with_cutoff(request, std::move(error)); })
      .map([&](SmoothOutcome outcome) {
        outcome.mended = request.reading.mended;
        Track track = with_sigmas(outcome.smoothing);
        return told(std::move(outcome), {std::move(track)});
      });
}

Expected<TaskOutcome> run_tune(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  TuneRequest job{.keys = request.input("keys"),
                  .method = checked(method_in(request, *request.input("keys"), usual_tuned)),
                  .reference = request.input("reference"),
                  .options = checked(options_in<TuneOptions>(request))};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([&](TuneRequest sound) { return tune(std::move(sound), progress); })
      .map([](TuneOutcome outcome) {
        Track track = tuned_track(outcome);
        return told(std::move(outcome), {std::move(track)});
      });
}

Expected<TaskOutcome> run_reduce(const TaskRequest& request, const Progress& progress) {
  auto job = reduce_request_in(request);
  if (!job) return tl::unexpected(std::move(job.error()));
  for (const auto& [name, value] : request.inputs)
    job->recordings.push_back(std::get<std::shared_ptr<const Track>>(value));
  std::vector<TaskOutcome> outcomes;
  for (auto& outcome : reduce(*job, progress)) {
    if (!outcome) return tl::unexpected(with_cutoff(request, std::move(outcome.error())));
    outcome->mended = request.reading.mended;
    Track track = outcome->chosen().track;
    outcomes.push_back(told(std::move(*outcome), {std::move(track)}));
  }
  return together(std::move(outcomes));
}

Expected<TaskOutcome> run_retime(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  RetimeRequest job{.keys = request.input("keys"),
                    .method = checked(method_in(request, *request.input("keys"), usual_retimed)),
                    .options = checked(options_in<RetimeOptions>(request))};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([&](RetimeRequest sound) { return retime(std::move(sound), progress); })
      .map([](RetimeOutcome outcome) {
        Track track = outcome.retiming.track;
        return told(std::move(outcome), {std::move(track)});
      });
}

Expected<TaskOutcome> run_bake(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  BakeRequest job{.keys = request.input("keys"),
                  .method = checked(method_in(request, *request.input("keys"), {})),
                  .options = checked(options_in<BakeSettings>(request))};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([&](BakeRequest sound) { return bake(std::move(sound), progress); })
      .map([](BakeOutcome outcome) { return told(std::move(outcome)); });
}

Expected<TaskOutcome> run_mean(const TaskRequest& request, const Progress&) {
  const auto job_of = [&](const MeanOptions& options) -> Expected<MeanRequest> {
    if (request.inputs.size() == 1)
      return MeanRequest{
          .rows = request.input("rows"), .options = options, .has_times = request.reading.rows_have_times};
    std::vector<Track> tracks;
    for (const auto& [name, value] : request.inputs) tracks.push_back(*std::get<std::shared_ptr<const Track>>(value));
    return mean_of_all(tracks, options);
  };
  return options_in<MeanOptions>(request)
      .and_then(job_of)
      .and_then([](MeanRequest job) { return mean(std::move(job)); })
      .map([&](MeanOutcome outcome) {
        outcome.mended = request.reading.mended;
        Track track = outcome.track();
        return told(std::move(outcome), {std::move(track)});
      });
}

Expected<TaskOutcome> run_align(const TaskRequest& request, const Progress& progress) {
  return options_in<AlignOptions>(request).and_then([&](const AlignOptions& options) -> Expected<TaskOutcome> {
    if (gyro_in(request, "moved") || gyro_in(request, "fixed")) return align_rates(request, options, progress);
    return align({.moved = request.input("moved"), .fixed = request.input("fixed"), .options = options}, progress)
        .map([](AlignOutcome outcome) {
          Track track = outcome.aligned;
          return told(std::move(outcome), {std::move(track)});
        });
  });
}

Expected<TaskOutcome> run_compare(const TaskRequest& request, const Progress& progress) {
  return compare_request_in(request)
      .and_then([&](CompareRequest job) {
        job.keys = request.input("keys");
        job.reference = request.input("reference");
        return compare(std::move(job), progress);
      })
      .map([](CompareOutcome outcome) { return told(std::move(outcome)); });
}

Expected<TaskOutcome> run_inspect(const TaskRequest& request, const Progress&) {
  return methods_in(request)
      .and_then([&](const auto& methods) {
        InspectRequest job{.keys = request.input("keys"), .faults = request.reading.faults};
        if (methods)
          for (const LabelledMethod& one : *methods) job.methods.push_back(one.method);
        return inspect(std::move(job));
      })
      .map([](InspectOutcome outcome) { return told(std::move(outcome)); });
}

Expected<void> check_smooth(const TaskRequest& request) {
  return smoothing_options_in(request).map([](const SmoothOptions&) {});
}

Expected<void> check_reduce(const TaskRequest& request) {
  return reduce_request_in(request).map([](const ReduceRequest&) {});
}

Expected<void> check_retime(const TaskRequest& request) {
  return options_in<RetimeOptions>(request).and_then([](const RetimeOptions& options) { return check(options); });
}

Expected<void> check_bake(const TaskRequest& request) {
  return options_in<BakeSettings>(request).and_then([](const BakeSettings& options) { return check_ranges(options); });
}

Expected<void> check_compare(const TaskRequest& request) {
  return compare_request_in(request).and_then([](const CompareRequest& job) { return check(job); });
}

template <class Options>
Expected<void> check_typed(const TaskRequest& request) {
  return options_in<Options>(request).map([](const Options&) {});
}
template Expected<void> check_typed<TuneOptions>(const TaskRequest& request);
template Expected<void> check_typed<MeanOptions>(const TaskRequest& request);
template Expected<void> check_typed<AlignOptions>(const TaskRequest& request);

}}}  // namespace orispline::jobs
