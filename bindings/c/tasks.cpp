// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/formatted.hpp>
#include <orispline/fields/warning_json.hpp>
#include <orispline/jobs/task_list.hpp>

#include "errors.hpp"
#include "json_text.hpp"
#include "keys.hpp"
#include "options.hpp"
#include "progress.hpp"

namespace orispline::c {

namespace {

/// What a task made, and what there is to say of it as texts.
struct Outcome {
  std::string document, summary, warnings;
  std::vector<std::shared_ptr<const Track>> tracks{};

  explicit Outcome(jobs::TaskOutcome outcome)
      : document(json_text(outcome.document)),
        summary(std::move(outcome.summary)),
        warnings(json_text(warnings_json(outcome.warnings))) {
    for (Track& track : outcome.tracks) tracks.push_back(std::make_shared<const Track>(std::move(track)));
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

Expected<jobs::TaskRequest> request_of(const orispline_input* inputs, std::size_t input_count,
                                       const char* const* options, std::size_t option_count) {
  auto stated = stated_options(options, option_count);
  if (!stated) return tl::unexpected(std::move(stated.error()));
  jobs::TaskRequest request{.inputs = {}, .options = std::move(*stated)};
  if (input_count == 0) return request;
  if (auto there = check_pointer(inputs, "inputs"); !there) return tl::unexpected(std::move(there.error()));
  for (const orispline_input& input : std::span(inputs, input_count)) {
    if (!input.name) return bad_option("inputs", "found one without a name, wanted one");
    const auto keys = checked(input.keys).map_error([&](Error error) {
      error.option = input.name;
      return error;
    });
    if (!keys) return tl::unexpected(keys.error());
    request.inputs.emplace_back(input.name, (*keys)->track);
  }
  return request;
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
  return guarded(error, [&] {
    return cleared(outcome, "outcome")
        .and_then([&] { return check_pointer(task, "task"); })
        .and_then([&] { return request_of(inputs, input_count, options, option_count); })
        .and_then([&](const jobs::TaskRequest& request) {
          return jobs::run_task(task, request, progress_by(progress, context));
        })
        .map([&](jobs::TaskOutcome made) { *outcome = handle_of<orispline_outcome>(Outcome(std::move(made))); });
  });
}

const char* orispline_outcome_document(const orispline_outcome* outcome) {
  return c::text_of(outcome, &Outcome::document);
}
const char* orispline_outcome_summary(const orispline_outcome* outcome) {
  return c::text_of(outcome, &Outcome::summary);
}
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

void orispline_outcome_free(orispline_outcome* outcome) { free_handle(outcome); }
