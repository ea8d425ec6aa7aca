// SPDX-License-Identifier: Apache-2.0
#include "output/each_input.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <sys/resource.h>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>

#include "options/option_text.hpp"
#include "options/threads.hpp"
#include "output/exit_code.hpp"
#include "output/gathered_output.hpp"
#include "output/interruption.hpp"
#include "output/json_document.hpp"
#include "output/output_folder.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

struct Turn {
  Gathered gathered;
  std::optional<Error> error{};
};

/// Brings what was said and made to the user, one input after the other.
class InOrder {
 public:
  InOrder(std::size_t inputs, Finishing finishing, const SummaryOptions& summary)
      : turns_(inputs), finishing_(finishing), summary_(summary) {}

  /// Says what is to be said of that input and those after it which are done too, once those before it are.
  void done(std::size_t index, Turn turn) {
    const std::scoped_lock lock(mutex_);
    turns_[index] = std::move(turn);
    for (; next_ < turns_.size() && turns_[next_]; ++next_) {
      say(*turns_[next_]);
      turns_[next_].reset();
    }
  }

  /// When all are done.
  [[nodiscard]] Expected<void> finish() {
    for (const auto& [text, count] : warned_)
      if (count > 1) warn(formatted("{} more {}: {}", count - 1, count == 2 ? "input" : "inputs", text));
    if (failed_ > 0 && finishing_ == Finishing::with_the_others) return said(failed());
    if (auto finished = finish_outputs(); !finished) return finished;
    tell(told_);
    if (summary_.json)
      if (auto printed = print_document(document_ + (document_.empty() ? "[]\n" : "\n]\n")); !printed) return printed;
    if (failed_ == 0) return {};
    return said(failed());
  }

 private:
  /// Those that wait for each other; an interruption comes before all of them or behind.
  [[nodiscard]] Expected<void> finish_outputs() {
    const InterruptionHeld held;
    for (const auto& finish_output : unfinished_) {
      if (auto finished = finish_output(); !finished) return said(with_written(std::move(finished.error()), finished_));
      ++finished_;
    }
    return {};
  }

  void say(Turn& turn) {
    const std::string& input = turn.gathered.input;
    finished_ += turn.gathered.finished;
    for (const std::string& warning : turn.gathered.warnings)
      if (warned_[warning]++ == 0) warn(warning.starts_with(input) ? warning : formatted("{}: {}", input, warning));
    if (turn.error) return say_failed(input, std::move(*turn.error));
    std::ranges::move(turn.gathered.unfinished, std::back_inserter(unfinished_));
    for (const std::string& document : turn.gathered.documents) add(document);
    if (finishing_ == Finishing::with_the_others) told_ += turn.gathered.told;
    else tell(turn.gathered.told);
  }

  void say_failed(const std::string& input, Error error) {
    ++failed_;
    if (error.where.file.empty()) error.where.file = input;
    const std::string message = message_of(error);
    const ExitCode code = report(error);
    if (code > gravest_code_) gravest_code_ = code, gravest_ = error.code;
    if (summary_.json) add(document(Json{{"input", input}, {"error", message}}));
  }

  /// As an element of an array.
  void add(std::string_view document) {
    document_ += document_.empty() ? "[" : ",";
    for (const std::string_view line : pieces_of(document, '\n'))
      if (!line.empty()) document_.append("\n  ").append(line);
  }

  [[nodiscard]] Error failed() const {
    return with_written({gravest_, formatted("{} of {} failed", failed_, counted(turns_.size(), "input"))}, finished_);
  }
  static Expected<void> said(Error error) { return tl::unexpected(std::move(error)); }

  std::mutex mutex_;
  std::vector<std::optional<Turn>> turns_;
  std::size_t next_ = 0, failed_ = 0, finished_ = 0;
  Finishing finishing_;
  SummaryOptions summary_;
  ExitCode gravest_code_ = ExitCode::success;
  ErrorCode gravest_ = ErrorCode::bad_data;
  std::map<std::string, std::size_t> warned_;
  std::string told_, document_;
  std::vector<std::function<Expected<void>()>> unfinished_;
};

/// Outputs that wait for each other keep their files locked, which the system counts.
Expected<void> make_room_for(std::size_t outputs) {
  constexpr rlim_t others = 64;
  rlimit files{};
  if (getrlimit(RLIMIT_NOFILE, &files) != 0 || files.rlim_cur >= outputs + others) return {};
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
  if (files.rlim_cur >= outputs + others) return {};
  return usage_failure(
      formatted("--all-or-none: found {} inputs, wanted {} at most, for all outputs stay open until "
                "the last one is complete; 'ulimit -n' raises the limit of open files",
                outputs, files.rlim_cur - others));
}

/// Each recording in the place of its file, `walk-2.tum` of `walk.tum`; their numbers.
Expected<std::vector<std::string>> split_by_session(InputFiles& inputs, const WorkOnEach& each) {
  std::vector<InputFile> files;
  std::vector<std::string> sessions;
  for (const InputFile& file : inputs.files) {
    const auto count = each.sessions(file.path);
    if (!count) return tl::unexpected(count.error());
    const std::filesystem::path name = file.name;
    for (std::size_t session = 1; session <= *count; ++session) {
      sessions.push_back(std::to_string(session));
      auto numbered = name;
      numbered.replace_filename(formatted("{}-{}{}", name.stem().string(), session, name.extension().string()));
      files.push_back({file.path, numbered.string()});
    }
  }
  inputs.files = std::move(files);
  return sessions;
}

Expected<std::vector<InputTurn>> turns_of(const SeveralInputs& inputs, const WorkOnEach& each, std::size_t threads) {
  if (inputs.folder->empty()) return usage_failure("--output-folder: found an empty name, wanted FOLDER");
  auto found = files_of(inputs);
  if (!found) return tl::unexpected(std::move(found.error()));
  std::vector<std::string> sessions(found->files.size());
  if (each.sessions) {
    auto split = split_by_session(*found, each);
    if (!split) return tl::unexpected(std::move(split.error()));
    sessions = std::move(*split);
  }
  auto outputs = outputs_in(*inputs.folder, found->files, each.extension, inputs.list, each.scenes);
  if (!outputs) return tl::unexpected(std::move(outputs.error()));
  warn(found->warnings);
  std::vector<InputTurn> turns;
  const std::string threads_of_each = std::to_string(std::max<std::size_t>(1, threads / outputs->size()));
  for (std::size_t i = 0; i < outputs->size(); ++i)
    turns.push_back(
        {std::move(found->files[i].path), std::move((*outputs)[i]), threads_of_each, std::move(sessions[i])});
  return turns;
}

}  // namespace

Expected<void> work_on_each(const SeveralInputs& inputs, const SummaryOptions& summary, const WorkOnEach& each) {
  const auto threads = threads_in(inputs.threads);
  if (!threads) return tl::unexpected(threads.error());
  const auto turns = turns_of(inputs, each, *threads);
  if (!turns) return tl::unexpected(turns.error());
  const Finishing finishing = inputs.all_or_none ? Finishing::with_the_others : Finishing::at_once;
  auto ready = each.check(turns->front()).and_then([&] { return check_folder(*inputs.folder); }).and_then([&] {
    return inputs.all_or_none ? make_room_for(turns->size()) : Expected<void>();
  });
  if (!ready) return ready;
  if (each.wants_report && turns->size() > 1)
    return usage_failure(formatted("--report: found {} inputs, wanted one: a page shows one recording", turns->size()));
  InOrder in_order(turns->size(), finishing, summary);
  parallel_for(turns->size(), static_cast<unsigned>(*threads), [&](std::size_t i) {
    Turn turn{.gathered = {.input = (*turns)[i].input, .finishing = finishing}};
    {
      const GatheringHere gathering(turn.gathered);
      if (auto worked = each.work((*turns)[i]); !worked) turn.error = std::move(worked.error());
    }
    in_order.done(i, std::move(turn));
  });
  return in_order.finish();
}

}  // namespace orispline::cli
