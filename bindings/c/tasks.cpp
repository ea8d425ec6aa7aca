// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/formatted.hpp>
#include <orispline/fields/warning_json.hpp>
#include <orispline/jobs/task_list.hpp>

#include "errors.hpp"
#include "json_text.hpp"
#include "keys.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "values.hpp"

namespace orispline::c {

namespace {

/// What a task made, and what there is to say of it as texts.
struct Outcome {
  std::string document, summary, line, warnings;
  std::vector<std::shared_ptr<const Track>> tracks{};
  std::vector<Value> others{};  ///< rates and skeletons

  /// `file`: of the skeleton that the task took; null where it took none.
  Outcome(jobs::TaskOutcome outcome, const std::shared_ptr<const scenes::Scene>& file)
      : document(json_text(outcome.document)),
        summary(std::move(outcome.summary)),
        line(std::move(outcome.line)),
        warnings(json_text(warnings_json(outcome.warnings))) {
    for (Track& track : outcome.tracks) tracks.push_back(std::make_shared<const Track>(std::move(track)));
    for (GyroTrack& gyro : outcome.gyros) others.push_back({std::make_shared<const GyroTrack>(std::move(gyro))});
    for (MotionFile& scene : outcome.scenes)
      others.push_back({std::make_shared<const MotionFile>(std::move(scene)), file});
  }

  [[nodiscard]] std::size_t size() const noexcept { return tracks.size() + others.size(); }
  [[nodiscard]] Value value(std::size_t index) const {
    return index < tracks.size() ? Value{tracks[index]} : others[index - tracks.size()];
  }
};

}  // namespace

template <>
struct HandleOf<orispline_outcome> {
  using Body = Outcome;
  static constexpr Kind kind = Kind::outcome;
  static constexpr std::string_view name = "outcome";
};

namespace {

/// What a task is asked for, and the file of the first skeleton among its inputs.
struct Asked {
  jobs::TaskRequest request{};
  std::shared_ptr<const scenes::Scene> file{};
};

Expected<Value> value_of(const orispline_input& input) {
  return checked(input.keys).map([](const Keys* keys) { return Value{keys->track}; });
}
Expected<Value> value_of(const orispline_named_value& input) {
  return checked(input.value).map([](const Value* value) { return *value; });
}

/// What one of the functions that run a task is called with; `inputs` are of the type that it takes.
struct Call {
  const char* task;
  const void* inputs;
  std::size_t input_count;
  const char* const* options;
  std::size_t option_count;
  orispline_progress progress;
  void* context;
};

template <class Input>
Expected<void> take_inputs(Asked& asked, const Call& call) {
  for (const Input& input : std::span(static_cast<const Input*>(call.inputs), call.input_count)) {
    if (!input.name) return bad_option("inputs", "found one without a name, wanted one");
    auto value = value_of(input);
    if (!value) {
      value.error().option = input.name;
      return tl::unexpected(std::move(value.error()));
    }
    if (!asked.file) asked.file = value->file;
    asked.request.inputs.emplace_back(input.name, std::move(value->value));
  }
  return {};
}

Expected<void> take_call(Asked& asked, const Call& call, Expected<void> (*take)(Asked&, const Call&)) {
  auto stated = stated_options(call.options, call.option_count);
  if (!stated) return tl::unexpected(std::move(stated.error()));
  for (auto& [name, text] : *stated) asked.request.options.emplace_back(std::move(name), std::move(text));
  if (call.input_count == 0) return {};
  if (auto there = check_pointer(call.inputs, "inputs"); !there) return there;
  return take(asked, call);
}

Expected<void> run(const Call& call, Expected<void> (*take)(Asked&, const Call&), orispline_outcome** outcome) {
  if (auto there = cleared(outcome, "outcome"); !there) return there;
  if (auto there = check_pointer(call.task, "task"); !there) return there;
  Asked asked;
  if (auto taken = take_call(asked, call, take); !taken) return taken;
  auto made = jobs::run_task(call.task, asked.request, progress_by(call.progress, call.context));
  if (!made) return tl::unexpected(std::move(made.error()));
  *outcome = handle_of<orispline_outcome>(Outcome(std::move(*made), asked.file));
  return {};
}

const char* text_of(const orispline_outcome* outcome, std::string Outcome::*text) {
  const Outcome* const body = body_of(outcome);
  return body ? (body->*text).c_str() : nullptr;
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_tasks_json(char** json, orispline_error** error) {
  return guarded(error,
                 [&] { return cleared(json, "json").map([&] { *json = text_of_c(json_text(jobs::tasks_json())); }); });
}

orispline_code orispline_task_run(const char* task, const orispline_input* inputs, size_t input_count,
                                  const char* const* options, size_t option_count, orispline_progress progress,
                                  void* context, orispline_outcome** outcome, orispline_error** error) {
  const Call call{task, inputs, input_count, options, option_count, progress, context};
  return guarded(error, [&] { return run(call, take_inputs<orispline_input>, outcome); });
}

orispline_code orispline_task_run_with(const char* task, const orispline_named_value* inputs, size_t input_count,
                                       const char* const* options, size_t option_count, orispline_progress progress,
                                       void* context, orispline_outcome** outcome, orispline_error** error) {
  const Call call{task, inputs, input_count, options, option_count, progress, context};
  return guarded(error, [&] { return run(call, take_inputs<orispline_named_value>, outcome); });
}

const char* orispline_outcome_document(const orispline_outcome* outcome) {
  return c::text_of(outcome, &Outcome::document);
}
const char* orispline_outcome_summary(const orispline_outcome* outcome) {
  return c::text_of(outcome, &Outcome::summary);
}
const char* orispline_outcome_line(const orispline_outcome* outcome) { return c::text_of(outcome, &Outcome::line); }
const char* orispline_outcome_warnings(const orispline_outcome* outcome) {
  return c::text_of(outcome, &Outcome::warnings);
}

size_t orispline_outcome_track_count(const orispline_outcome* outcome) {
  const Outcome* const body = body_of(outcome);
  return body ? body->tracks.size() : 0;
}

orispline_code orispline_outcome_track(const orispline_outcome* outcome, size_t index, orispline_keys** keys,
                                       orispline_error** error) {
  return guarded(error, [&] {
    return cleared(keys, "keys")
        .and_then([&] { return checked(outcome); })
        .and_then([&](const Outcome* body) -> Expected<void> {
          if (index >= body->tracks.size())
            return bad_option("index", formatted("found {}, wanted one of {} tracks", index, body->tracks.size()));
          *keys = handle_of<orispline_keys>({body->tracks[index]});
          return {};
        });
  });
}

size_t orispline_outcome_value_count(const orispline_outcome* outcome) {
  const Outcome* const body = body_of(outcome);
  return body ? body->size() : 0;
}

orispline_code orispline_outcome_value(const orispline_outcome* outcome, size_t index, orispline_value** value,
                                       orispline_error** error) {
  return guarded(error, [&] {
    return cleared(value, "value")
        .and_then([&] { return checked(outcome); })
        .and_then([&](const Outcome* body) -> Expected<void> {
          if (index >= body->size())
            return bad_option("index", formatted("found {}, wanted one of {} values", index, body->size()));
          *value = handle_of<orispline_value>(body->value(index));
          return {};
        });
  });
}

void orispline_outcome_free(orispline_outcome* outcome) { free_handle(outcome); }
