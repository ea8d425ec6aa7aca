// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <optional>
#include <utility>

#include <orispline/base/first_error.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/fields/typed_numbers.hpp>
#include <orispline/fields/typed_options.hpp>
#include <orispline/jobs/align.hpp>
#include <orispline/jobs/bake.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/mean.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/jobs/task_list.hpp>
#include <orispline/jobs/tune.hpp>

// What is stated for a task by names becomes its request, and its outcome what all tasks have.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

StatedText stated_in(const TaskRequest& request) {
  return [&request](std::string_view name) { return request.option(name); };
}

/// With the name of the option that was wrong.
auto of_option(std::string_view name) {
  return [name](Error error) {
    error.option = name;
    return error;
  };
}

Expected<bool> flag(const TaskRequest& request, std::string_view name) {
  const std::string* const text = request.option(name);
  if (!text) return false;
  if (*text != "true" && *text != "false")
    return Expected<bool>(typed::wanted(*text, "true or false")).map_error(of_option(name));
  return *text == "true";
}

Expected<unsigned> threads_in(const TaskRequest& request) {
  const std::string* const text = request.option("threads");
  if (!text) return 0u;
  return typed::count(*text, 0)
      .map([](std::uint64_t count) {
        return static_cast<unsigned>(std::min<std::uint64_t>(count, std::numeric_limits<unsigned>::max()));
      })
      .map_error(of_option("threads"));
}

Expected<ChosenMethod> method_in(const TaskRequest& request, const Track& keys, const UsualMethod& usual) {
  const std::string* const text = request.option("method");
  if (!text) return chosen_method(std::nullopt, keys, usual);
  return method_from_text(*text).and_then([&](const Method& named) { return chosen_method(named, keys, usual); });
}

/// Absent where none are stated.
Expected<std::optional<std::vector<LabelledMethod>>> methods_in(const TaskRequest& request) {
  const std::string* const list = request.option("methods");
  if (!list) return std::nullopt;
  const auto texts = method_texts_in(*list);
  if (!texts) return tl::unexpected(texts.error());
  std::vector<LabelledMethod> methods;
  for (const std::string& text : *texts) {
    auto method = method_from_text(text);
    if (!method) return tl::unexpected(std::move(method.error()));
    methods.push_back({text, std::move(*method)});
  }
  return methods;
}

template <class Outcome>
TaskOutcome told(const Outcome& outcome, std::vector<Track>&& tracks) {
  return {.document = document_of(outcome),
          .summary = summary_of(outcome),
          .warnings = outcome.warnings,
          .tracks = std::move(tracks)};
}

/// Wanted where an option of smoothing is stated.
Expected<std::optional<SmoothOptions>> smoothing_in(const TaskRequest& request) {
  auto wanted = flag(request, "smooth");
  if (!wanted) return tl::unexpected(std::move(wanted.error()));
  for (const FieldInfo& field : fields_of<SmoothOptions>()) *wanted = *wanted || request.option(field.name);
  if (!*wanted) return std::nullopt;
  return typed_options<SmoothOptions>(stated_in(request)).and_then([](const SmoothOptions& options) {
    return check(options).map([&] { return std::optional(options); });
  });
}

/// Of a recording without another one.
Expected<std::vector<Decimation>> decimations_in(const TaskRequest& request) {
  if (!request.input("reference"))
    return typed_options<Decimation>(stated_in(request)).and_then([](const Decimation& decimation) {
      return check_ranges(decimation).map([&] { return std::vector{decimation}; });
    });
  for (const FieldInfo& field : fields_of<Decimation>())
    if (request.option(field.name))
      return bad_option(field.name, "found a `reference` as well, wanted samples of the keys or a reference for them");
  return std::vector<Decimation>();
}

/// What several outcomes say, as one.
TaskOutcome together(std::vector<TaskOutcome> outcomes) {
  if (outcomes.size() == 1) return std::move(outcomes.front());
  TaskOutcome all{.document = Json::array()};
  for (TaskOutcome& one : outcomes) {
    all.document.push_back(std::move(one.document));
    all.summary += one.summary;
    std::ranges::move(one.warnings, std::back_inserter(all.warnings));
    std::ranges::move(one.tracks, std::back_inserter(all.tracks));
  }
  return all;
}

}  // namespace

Expected<TaskOutcome> run_smooth(const TaskRequest& request, const Progress& progress) {
  return typed_options<SmoothOptions>(stated_in(request))
      .and_then([&](const SmoothOptions& options) {
        return smooth({.recording = request.input("recording"), .options = options}, progress);
      })
      .map([](const SmoothOutcome& outcome) { return told(outcome, {outcome.smoothing.track}); });
}

Expected<TaskOutcome> run_tune(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  TuneRequest job{.keys = request.input("keys"),
                  .method = checked(method_in(request, *request.input("keys"), usual_tuned)),
                  .reference = request.input("reference"),
                  .options = checked(typed_options<TuneOptions>(stated_in(request)))};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([&](TuneRequest sound) { return tune(std::move(sound), progress); })
      .map([](const TuneOutcome& outcome) { return told(outcome, {outcome.tuning.track}); });
}

Expected<TaskOutcome> run_reduce(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  ReduceRequest job{.recordings = {},
                    .options = checked(typed_options<ReduceOptions>(stated_in(request))),
                    .smoothing = checked(smoothing_in(request)),
                    .threads = checked(threads_in(request))};
  if (auto methods = checked(methods_in(request))) {
    job.methods.clear();
    for (LabelledMethod& one : *methods) job.methods.push_back(std::move(one.method));
  }
  for (const auto& [name, track] : request.inputs) job.recordings.push_back(track);
  auto sound = std::move(checked).or_else(std::move(job));
  if (!sound) return tl::unexpected(std::move(sound.error()));
  std::vector<TaskOutcome> outcomes;
  for (auto& outcome : reduce(*sound, progress)) {
    if (!outcome) return tl::unexpected(std::move(outcome.error()));
    const Track track = outcome->chosen().track;
    outcomes.push_back(told(*outcome, {track}));
  }
  return together(std::move(outcomes));
}

Expected<TaskOutcome> run_retime(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  RetimeRequest job{.keys = request.input("keys"),
                    .method = checked(method_in(request, *request.input("keys"), usual_retimed)),
                    .options = checked(typed_options<RetimeOptions>(stated_in(request)))};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([&](RetimeRequest sound) { return retime(std::move(sound), progress); })
      .map([](const RetimeOutcome& outcome) { return told(outcome, {outcome.retiming.track}); });
}

Expected<TaskOutcome> run_bake(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  BakeRequest job{.keys = request.input("keys"),
                  .method = checked(method_in(request, *request.input("keys"), {})),
                  .options = checked(typed_options<BakeSettings>(stated_in(request)))};
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([&](BakeRequest sound) { return bake(std::move(sound), progress); })
      .map([](const BakeOutcome& outcome) { return told(outcome, {}); });
}

Expected<TaskOutcome> run_mean(const TaskRequest& request, const Progress&) {
  const auto job_of = [&](const MeanOptions& options) -> Expected<MeanRequest> {
    if (request.inputs.size() == 1) return MeanRequest{.rows = request.inputs.front().second, .options = options};
    std::vector<Track> tracks;
    for (const auto& [name, track] : request.inputs) tracks.push_back(*track);
    return mean_of_all(tracks, options);
  };
  return typed_options<MeanOptions>(stated_in(request))
      .and_then(job_of)
      .and_then([](MeanRequest job) { return mean(std::move(job)); })
      .map([](const MeanOutcome& outcome) { return told(outcome, {outcome.track()}); });
}

Expected<TaskOutcome> run_align(const TaskRequest& request, const Progress& progress) {
  return typed_options<AlignOptions>(stated_in(request))
      .and_then([&](const AlignOptions& options) {
        return align({.moved = request.input("moved"), .fixed = request.input("fixed"), .options = options}, progress);
      })
      .map([](const AlignOutcome& outcome) { return told(outcome, {outcome.aligned}); });
}

Expected<TaskOutcome> run_compare(const TaskRequest& request, const Progress& progress) {
  FirstError checked;
  CompareRequest job{.keys = request.input("keys"),
                     .reference = request.input("reference"),
                     .decimations = checked(decimations_in(request)),
                     .methods = all_methods(),
                     .tune = checked(flag(request, "tune")),
                     .align = checked(flag(request, "align")),
                     .measured = checked(typed_options<MeasureOptions>(stated_in(request))),
                     .has_inertia = request.option("inertia") != nullptr,
                     .threads = checked(threads_in(request))};
  if (const std::string* const word = request.option("sort")) job.sort = *word;
  if (auto methods = checked(methods_in(request))) {
    job.methods = std::move(*methods);
    for (const LabelledMethod& one : job.methods) job.named.push_back(one.label);
  }
  return std::move(checked)
      .or_else(std::move(job))
      .and_then([&](CompareRequest sound) { return compare(std::move(sound), progress); })
      .map([](const CompareOutcome& outcome) { return told(outcome, {}); });
}

}}}  // namespace orispline::jobs
