// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/mean.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::span<const double> weights_of(const Track& rows) {
  const auto found = rows.settings.find(weight_name);
  return found == rows.settings.end() ? std::span<const double>() : found->second;
}

/// Of several files the one that a row is from; null where they are one, or have no names.
const RowsOfFile* file_of(const MeanRequest& request, std::size_t row) {
  const auto next = std::ranges::upper_bound(request.files, row, {}, &RowsOfFile::first);
  return next == request.files.begin() || (next - 1)->name.empty() ? nullptr : &*(next - 1);
}

/// The place of a row of several files, by the name of its own file and the number of the row there.
Where place_in_own_file(const MeanRequest& request, Where where) {
  const RowsOfFile* const file = where.key ? file_of(request, *where.key) : nullptr;
  if (!file) return where;
  where.file = file->name;
  if (!request.rows->lines.empty()) where.line = request.rows->lines[*where.key];
  where.key = *where.key - file->first;
  return where;
}

Error located(const MeanRequest& request, Error error) {
  if (request.files.empty()) return placed(*request.rows, std::move(error));
  error.where = place_in_own_file(request, std::move(error.where));
  return error;
}

Warning located(const MeanRequest& request, Warning warning) {
  if (request.files.empty()) return request.rows->located(std::move(warning));
  warning.where = place_in_own_file(request, std::move(warning.where));
  return warning;
}

/// One of each kind, with the number of windows where there are several.
std::vector<Warning> warnings_of(const std::vector<MeanWindow>& windows, const MeanRequest& request) {
  std::vector<std::pair<Warning, std::size_t>> kinds;
  for (const MeanWindow& window : windows)
    for (const Warning& warning : window.mean.warnings) {
      const auto found = std::ranges::find_if(kinds, [&](const auto& kind) { return kind.first.code == warning.code; });
      if (found == kinds.end()) kinds.emplace_back(warning, 1);
      else ++found->second;
    }
  std::vector<Warning> warnings;
  for (auto& [warning, count] : kinds) {
    if (windows.size() > 1) {
      warning.message =
          formatted("in {} of {}, first here: {}", count, counted(windows.size(), "window"), warning.message);
      warning.numbers.emplace_back("windows", static_cast<double>(count));
    }
    warnings.push_back(located(request, std::move(warning)));
  }
  return warnings;
}

/// Where a row is in its file, else its number.
std::string row_text(const MeanRequest& request, std::size_t row) {
  const RowsOfFile* const file = file_of(request, row);
  const Track& rows = *request.rows;
  const std::string place =
      rows.lines.empty() ? formatted("row {}", file ? row - file->first : row) : formatted("line {}", rows.lines[row]);
  return file ? formatted("{} of {}", place, printable(file->name)) : place;
}

std::string orientation_text(const Eigen::Quaterniond& q) {
  return formatted("qw {:.17g}  qx {:.17g}  qy {:.17g}  qz {:.17g}", q.w(), q.x(), q.y(), q.z());
}

std::string vector_text(const Eigen::Vector3d& v, double unit, std::string_view name) {
  return formatted("{:.4g}{}, {:.4g}{}, {:.4g}{}", v.x() * unit, name, v.y() * unit, name, v.z() * unit, name);
}

/// `certified: all within 2.5° of an orientation`
std::string certificate_line(const Mean& found, std::string_view kind) {
  if (found.certified)
    return formatted("  only one       proved: no other orientation is as good; all are in a ball of {:.4g}°\n",
                     found.ball_radius * degrees);
  if (found.others_within)
    return formatted("  only one       not proved; every other {} is within {:.4g}° of it\n", kind,
                     *found.others_within * degrees);
  return formatted("  only one       not proved; no ball of less than 90° holds all orientations\n");
}

std::string position_lines(const Mean& found, std::string_view kind, const MeanRequest& request) {
  if (!found.position) return "";
  const Eigen::Vector3d& p = *found.position;
  std::string text = formatted("position {} (m)\n  px {:.17g}  py {:.17g}  pz {:.17g}\n", kind, p.x(), p.y(), p.z());
  if (const auto deviation = position_sigma_of(found))
    text += formatted("  sigma          {} along the axes of the world\n", vector_text(*deviation, 1.0, " m"));
  return text + formatted("  distances      {:.4g} m RMS, {:.4g} m at most ({})\n", *found.position_rms_distance,
                          *found.position_largest_distance, row_text(request, *found.farthest_position));
}

std::string lines_of(const Mean& found, const MeanOutcome& outcome) {
  const std::string_view kind = word_of(outcome.request.options.kind);
  std::string text = formatted("orientation {}\n  {}\n", kind, orientation_text(found.orientation));
  if (const auto deviation = sigma_of(found))
    text += formatted("  sigma          {} along the axes of its body\n", vector_text(*deviation, degrees, "°"));
  else
    text += formatted("  sigma          unknown: {}\n",
                      found.spread ? "all but turn about one axis" : "a single orientation");
  text += formatted("  distances      {:.4g}° RMS, {:.4g}° at most ({})\n", found.rms_distance * degrees,
                    found.largest_distance * degrees, row_text(outcome.request, found.farthest));
  text += certificate_line(found, kind);
  text += formatted("  residual       {:.2g} rad after {}\n", found.residual, counted(found.iterations, "step"));
  return text + position_lines(found, kind, outcome.request);
}

/// To the microsecond: the middle of a window is a sum of rounded times.
std::string time_text(const MeanOutcome& outcome, const MeanWindow& window) {
  const Track& rows = *outcome.request.rows;
  return rows.time_text(rows.epoch + Decimal::from_double(window.time).rounded(6));
}

/// Window by window, the first and the last ones of many.
std::string table_of(const MeanOutcome& outcome) {
  constexpr std::size_t shown = 10;
  const std::size_t count = outcome.windows.size();
  std::size_t width = 0;
  for (const MeanWindow& window : outcome.windows) width = std::max(width, time_text(outcome, window).size());
  std::string text = formatted("  {:>{}}{:>9}{:>12}{:>12}  orientation\n", "t", width, "rows", "RMS", "at most");
  for (std::size_t i = 0; i < count; ++i) {
    if (i == shown && count > 2 * shown) {
      text += "  …\n";
      i = count - shown;
    }
    const auto& window = outcome.windows[i];
    const auto& q = window.mean.orientation;
    text += formatted("  {:>{}}{:>9}{:>11.4g}°{:>11.4g}°  {:.6f} {:.6f} {:.6f} {:.6f}\n", time_text(outcome, window),
                      width, window.mean.count, window.mean.rms_distance * degrees,
                      window.mean.largest_distance * degrees, q.w(), q.x(), q.y(), q.z());
  }
  return text;
}

Json place_json(const MeanRequest& request, std::size_t row) {
  const Track& rows = *request.rows;
  const Json line = rows.lines.empty() ? Json(nullptr) : Json(rows.lines[row]);
  const RowsOfFile* const file = file_of(request, row);
  if (!file) return {{"key", row}, {"line", line}};
  return {{"file", file->name}, {"key", row - file->first}, {"line", line}};
}

Json mean_json(const Mean& found, const MeanRequest& request) {
  Json json = rotation_json(found.orientation);
  if (found.position)
    json.update({{"px", found.position->x()}, {"py", found.position->y()}, {"pz", found.position->z()}});
  const Places places{request.rows->lines};
  for (const FieldInfo& field : fields_of<Mean>())
    if (found.position || !field.name.starts_with("position")) put(json, found, {field.name}, places);
  json["farthest"] = place_json(request, found.farthest);
  if (found.farthest_position) json["farthest_position"] = place_json(request, *found.farthest_position);
  return json;
}

std::string subject(const MeanOutcome& outcome) {
  const std::vector<RowsOfFile>& files = outcome.request.files;
  const std::string_view kind = files.empty() || files.front().name.empty() ? "sets" : "files";
  return keys_text(*outcome.request.rows, "row") + (files.empty() ? "" : formatted(" from {} {}", files.size(), kind)) +
         (outcome.is_weighted() ? ", weighted" : "") + (outcome.mended.empty() ? "" : "; " + outcome.mended);
}

template <class T>
void append(std::vector<T>& list, std::span<const T> more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// That files have positions and weights alike.
Expected<void> check_alike(const Track& file, const Track& first) {
  const auto refused = [&](std::string_view what, const Track& lacking, const Track& having, std::string_view cure) {
    return failure(ErrorCode::bad_data,
                   formatted("found no {}, which {} has, wanted them in all or in none{}", what,
                             having.name.empty() ? "another set" : printable(having.name), cure),
                   {.file = lacking.name});
  };
  const bool has_positions = !file.keys.positions().empty(), has_weights = !weights_of(file).empty();
  if (has_positions != !first.keys.positions().empty())
    return refused("positions", has_positions ? first : file, has_positions ? file : first,
                   "; `no_positions` reads none");
  if (has_weights != !weights_of(first).empty())
    return refused("weights", has_weights ? first : file, has_weights ? file : first, "");
  return {};
}

}  // namespace

bool MeanOutcome::is_weighted() const { return !weights_of(*request.rows).empty(); }

Track MeanOutcome::track() const {
  KeyframeData data;
  for (const MeanWindow& window : windows) {
    data.times.push_back(request.has_times ? window.time : 0.0);
    data.orientations.push_back(window.mean.orientation);
    if (window.mean.position) data.positions.push_back(*window.mean.position);
  }
  Track track(*Keyframes::make(std::move(data)));
  if (request.has_times) track.epoch = request.rows->epoch;
  return track;
}

Expected<MeanRequest> mean_of_all(std::span<const Track> files, const MeanOptions& options) {
  if (options.every)
    return bad_option("every",
                      formatted("found {} sets of rows, each with a clock of its own, wanted one", files.size()));
  MeanRequest request{.rows = {}, .options = options, .has_times = false};
  KeyframeData data;
  Track rows;
  std::vector<double>* weights = nullptr;
  if (!weights_of(files.front()).empty()) weights = &rows.settings[std::string(weight_name)];
  for (const Track& file : files) {
    if (auto alike = check_alike(file, files.front()); !alike) return tl::unexpected(std::move(alike.error()));
    request.files.push_back({file.name, data.orientations.size()});
    append(data.orientations, file.keys.orientations());
    append(data.positions, file.keys.positions());
    if (weights) append(*weights, weights_of(file));
    append(rows.lines, std::span(file.lines));
  }
  for (std::size_t i = 0; i < data.orientations.size(); ++i) data.times.push_back(static_cast<double>(i));
  return Keyframes::make(std::move(data)).map([&](const Keyframes& keys) {
    rows.keys = keys;
    request.rows = std::make_shared<const Track>(std::move(rows));
    return std::move(request);
  });
}

Expected<MeanOutcome> mean(MeanRequest request) {
  const Track& rows = *request.rows;
  const Keyframes& keys = rows.keys;
  auto windows =
      mean_in_windows(keys.times(), {keys.orientations(), keys.positions(), weights_of(rows)}, request.options);
  if (!windows) return tl::unexpected(located(request, std::move(windows.error())));
  std::vector<Warning> warnings = warnings_of(*windows, request);
  return MeanOutcome{.request = std::move(request), .windows = std::move(*windows), .warnings = std::move(warnings)};
}

Json document_of(const MeanOutcome& outcome) {
  const Track& rows = *outcome.request.rows;
  Json json{
      {"kind", word_of(outcome.request.options.kind)}, {"rows", rows.keys.size()}, {"weighted", outcome.is_weighted()}};
  if (!outcome.request.options.every) {
    json.update(mean_json(outcome.windows.front().mean, outcome.request));
    return json;
  }
  json["every_s"] = *outcome.request.options.every;
  Json windows = Json::array();
  const Track means = outcome.track();
  for (std::size_t i = 0; i < outcome.windows.size(); ++i) {
    Json one{{"time_s", means.time_of(i).to_string()}};
    one.update(mean_json(outcome.windows[i].mean, outcome.request));
    windows.push_back(std::move(one));
  }
  json["windows"] = std::move(windows);
  return json;
}

std::string summary_of(const MeanOutcome& outcome) {
  if (!outcome.request.options.every) return subject(outcome) + "\n" + lines_of(outcome.windows.front().mean, outcome);
  return formatted("{}: {} of {:.6g} s\n", subject(outcome), counted(outcome.windows.size(), "window"),
                   *outcome.request.options.every) +
         table_of(outcome);
}

std::string line_of(const MeanOutcome& outcome) {
  const std::string_view kind = word_of(outcome.request.options.kind);
  const std::size_t count = outcome.windows.size();
  if (count > 1) return formatted("{}s of {}", kind, counted(count, "window"));
  const Mean& found = outcome.windows.front().mean;
  return formatted("{} of {}, {:.4g}° RMS, {:.4g}° at most", kind, counted(found.count, "row"),
                   found.rms_distance * degrees, found.largest_distance * degrees);
}

}}}  // namespace orispline::jobs
