// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/first_error.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

Domain before(const RetimeClipsOutcome& outcome, std::size_t clip) { return outcome.request.file.clips[clip].domain(); }

double length_of(Domain domain) { return domain.end - domain.start; }

/// `rate: nowhere above 400 °/s (limit 400), joint 'LeftFoot', largest found 399.9 at 1.2 s after the start`
std::string certificate_line(const RetimeClipsOutcome& outcome, const Certificate& c) {
  return formatted("  {}: nowhere above {} (limit {:.6g}), joint {}, largest found {:.6g} at {:.6g} s\n", c.name,
                   c.text_of(c.bound), c.limit / c.shown.size,
                   in_quotes(outcome.request.file.skeleton.shown_name(c.body)), c.found / c.shown.size, c.time);
}

std::string lines_of(const RetimeClipsOutcome& outcome, std::size_t i) {
  const ClipRetiming& retiming = outcome.clips[i];
  const double scale = retiming.time_scale;
  std::string text = formatted(
      "{}: {:.6g} s before, {:.6g} s after, {}{}\n", in_quotes(retiming.clip.name), length_of(before(outcome, i)),
      length_of(retiming.clip.domain()),
      scale < 1.0 ? formatted("faster by {:.6g}", 1.0 / scale) : formatted("slowed by {:.6g}", scale),
      retiming.slowing == outcome.request.options.slowing ? "" : ", all intervals alike: each by itself saves no time");
  for (const Certificate& c : outcome.certificates(i)) text += certificate_line(outcome, c);
  if (retiming.rests > 0) text += formatted("  {} of all joints between equal keys\n", counted(retiming.rests, "rest"));
  return text;
}

Json json_of(const RetimeClipsOutcome& outcome, std::size_t i) {
  const ClipRetiming& retiming = outcome.clips[i];
  Json json{{"clip", retiming.clip.name},
            {"slowing", word_of(retiming.slowing)},
            {"duration_before_s", length_of(before(outcome, i))},
            {"duration_after_s", length_of(retiming.clip.domain())},
            {"time_scale", retiming.time_scale},
            {"rests", retiming.rests},
            {"slack", retiming.slack},
            {"measured", retiming.measured}};
  for (const Certificate& c : outcome.certificates(i)) {
    json[c.id_of("limit")] = c.limit / c.in_ids.size;
    json[c.id_of("bound")] = c.bound / c.in_ids.size;
    json[c.id_of("max")] = c.found / c.in_ids.size;
    json[formatted("{}_joint", c.id)] = outcome.request.file.skeleton[c.body].name;
  }
  return json;
}

}  // namespace

std::vector<Certificate> RetimeClipsOutcome::certificates(std::size_t clip) const {
  return clips[clip].peaks.empty() ? std::vector<Certificate>()
                                   : certificates_of(request.options.limits, clips[clip].peaks);
}

Expected<void> check(const RetimeClipsRequest& request) {
  const MotionLimits& limits = request.options.limits;
  if (request.file.format.has_no_unit && (limits.speed || limits.linear_acceleration))
    return bad_option(limits.speed ? "max_speed" : "max_linear_acceleration",
                      formatted("found {}, which has no unit of length, wanted glTF, as the conversion with "
                                "`position_scale` writes it",
                                request.file.format.file));
  return check_for_clips(request.options);
}

Expected<RetimeClipsOutcome> retime_clips(RetimeClipsRequest request, const Progress& progress) {
  const auto in_file = [name = request.file.name](Error error) {
    if (error.where.file.empty()) error.where.file = name;
    return error;
  };
  if (auto sound = check(request); !sound) return tl::unexpected(in_file(std::move(sound.error())));
  if (request.file.clips.empty())
    return tl::unexpected(in_file(failure(ErrorCode::bad_data, "found no clip, wanted one").value()));
  const MotionFile& file = request.file;
  std::vector<Expected<ClipRetiming>> made(file.clips.size());
  parallel_for(made.size(), request.threads, [&](std::size_t i) {
    made[i] = retime_clip(file.skeleton, file.clips[i], request.method, request.options,
                          made.size() == 1 ? progress : Progress{});
  });
  FirstError checked;
  RetimeClipsOutcome outcome;
  for (Expected<ClipRetiming>& one : made) {
    ClipRetiming& retiming = outcome.clips.emplace_back(checked(std::move(one)));
    std::ranges::move(std::exchange(retiming.warnings, {}), std::back_inserter(outcome.warnings));
  }
  outcome.request = std::move(request);
  return std::move(checked).or_else(std::move(outcome)).map_error(in_file);
}

std::string summary_of(const RetimeClipsOutcome& outcome) {
  const std::string& name = outcome.request.file.name;
  constexpr std::size_t most_shown = 10;
  const std::size_t shown = std::min(most_shown, outcome.clips.size());
  std::string text = formatted("{}{}, {}\n", counted(outcome.clips.size(), "clip"),
                               name.empty() ? "" : " from " + printable(name), text_of(outcome.request.method));
  for (std::size_t i = 0; i < shown; ++i) text += lines_of(outcome, i);
  if (shown < outcome.clips.size()) text += formatted("… and {} clips more\n", outcome.clips.size() - shown);
  return text;
}

Json document_of(const RetimeClipsOutcome& outcome) {
  Json clips = Json::array();
  for (std::size_t i = 0; i < outcome.clips.size(); ++i) clips.push_back(json_of(outcome, i));
  Json json{{"method", outcome.request.method.name}, {"slowing_asked_for", word_of(outcome.request.options.slowing)}};
  json["clips"] = std::move(clips);
  return json;
}

}}}  // namespace orispline::jobs
