// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/track_state.hpp>

#include <cmath>
#include <concepts>
#include <vector>

#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/online/stream_parts.hpp>
#include <orispline/online/track_stretch.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::uint64_t mark = 0x344b434152545249u;  // "IRTRACK4", lowest byte first

tl::unexpected<Error> no_state(const std::string& why) {
  return failure(ErrorCode::bad_data, "the bytes are no state of a track: " + why);
}

void write(StateWriter& out, const std::optional<double>& number) {
  out.whole(number ? 1 : 0);
  out.real(number.value_or(0.0));
}
std::optional<double> read_optional(StateReader& in) {
  const bool there = in.below(2) == 1;
  const double number = in.real();
  return there ? std::optional(number) : std::nullopt;
}

void write(StateWriter& out, const End& end) {
  out.whole(static_cast<std::uint64_t>(end.rule));
  out.vector(end.angular_velocity);
}
End read_end(StateReader& in) {
  const auto rule = static_cast<EndRule>(in.below(static_cast<std::uint64_t>(EndRule::secant) + 1));
  return {.rule = rule, .angular_velocity = in.vector()};
}

void write(StateWriter& out, const std::optional<Decimal>& time) { out.text(time ? time->to_string() : ""); }
Expected<std::optional<Decimal>> read_decimal(StateReader& in) {
  const std::string text = in.text();
  if (text.empty()) return std::nullopt;
  return Decimal::parse(text);
}

void write(StateWriter& out, const TrackGrid& grid) {
  out.real(grid.step);
  write(out, grid.start);
  const auto* const rate = grid.request ? std::get_if<SampleGrid::Rate>(&grid.request->spacing) : nullptr;
  const bool is_plain = !rate || (rate->seconds == 1.0 && grid.request->last == SampleGrid::LastSample::before_end);
  const bool has_parts = !grid.request && grid.parts != 1.0;
  out.whole(has_parts ? 4 : !grid.request ? 0 : !rate ? 2 : is_plain ? 1 : 3);  // 3 and 4 are younger than the others
  if (has_parts) out.real(grid.parts);
  if (!grid.request) return;
  if (rate) out.real(rate->hertz);
  else out.whole(std::get<SampleGrid::Count>(grid.request->spacing).samples);
  if (!is_plain) {
    out.real(rate->seconds);
    out.whole(static_cast<std::uint64_t>(grid.request->last));
  }
  write(out, grid.request->start);
  write(out, grid.request->end);
}
Expected<TrackGrid> read_grid(StateReader& in) {
  TrackGrid grid{.step = in.real()};
  grid.start = read_optional(in);
  const std::uint64_t kind = in.below(5);
  if (kind == 4) grid.parts = in.real();
  if (kind == 0 || kind == 4) return grid;
  SampleGrid::Request request{.spacing = SampleGrid::Rate{0.0}};
  if (kind == 1 || kind == 3) {
    SampleGrid::Rate rate{in.real()};
    if (kind == 3) rate.seconds = in.real();
    if (kind == 3) request.last = static_cast<SampleGrid::LastSample>(in.below(2));
    request.spacing = rate;
  } else request.spacing = SampleGrid::Count{static_cast<std::size_t>(in.whole())};
  for (auto* time : {&request.start, &request.end}) {
    auto read = read_decimal(in);
    if (!read) return tl::unexpected(std::move(read.error()));
    *time = *read;
  }
  grid.request = request;
  return grid;
}

void write(StateWriter& out, const KeyAlignment& alignment) {
  out.whole(alignment.report.sign_flips);
  out.whole(alignment.report.non_unit_keys);
  out.real(alignment.report.largest_norm_error);
  out.whole(alignment.report.near_half_turns);
  out.whole(alignment.report.first_near_half_turn);
  out.whole(alignment.negated ? 1 : 0);
}
KeyAlignment read_alignment(StateReader& in, std::uint64_t keys) {
  KeyAlignment alignment{.keys = static_cast<std::size_t>(keys)};
  alignment.report.sign_flips = static_cast<std::size_t>(in.whole());
  alignment.report.non_unit_keys = static_cast<std::size_t>(in.whole());
  alignment.report.largest_norm_error = in.real();
  alignment.report.near_half_turns = static_cast<std::size_t>(in.whole());
  alignment.report.first_near_half_turn = static_cast<std::size_t>(in.whole());
  alignment.negated = in.below(2) == 1;
  return alignment;
}

void write(StateWriter& out, const CurveOptions& options) {
  out.whole(options.parameters.size());
  for (const auto& [name, values] : options.parameters) {
    out.text(name);
    out.reals(values);
  }
  out.whole(options.choices.size());
  for (const auto& [name, word] : options.choices) {
    out.text(name);
    out.text(word);
  }
  write(out, options.start);
  write(out, options.end);
}
CurveOptions read_options(StateReader& in) {
  CurveOptions options;
  for (std::size_t left = in.count(); left > 0; --left) {
    std::string name = in.text();
    options.parameters[std::move(name)] = in.reals();
  }
  for (std::size_t left = in.count(); left > 0; --left) {
    std::string name = in.text();
    options.choices[std::move(name)] = in.text();
  }
  options.start = read_end(in);
  options.end = read_end(in);
  return options;
}

void write(StateWriter& out, const BlendingData& data) {
  out.text(data.name);
  out.text(data.title);
  out.whole(data.parameters.size());
  for (const BlendingParameter& parameter : data.parameters) {
    out.text(parameter.name);
    for (const double number : {parameter.initial, parameter.lowest, parameter.highest}) out.real(number);
  }
  out.whole(data.rows.size());
  for (const auto& row : data.rows) {
    out.whole(row.size());
    for (const std::string& entry : row) out.text(entry);
  }
  out.whole(data.first ? static_cast<std::uint64_t>(1 - *data.first) : 0);  // it is 0 or below
  out.text(data.ends);
  out.whole(static_cast<std::uint64_t>(data.basis));
}
BlendingData read_blending(StateReader& in) {
  BlendingData data{.name = in.text(), .title = in.text()};
  for (std::size_t left = in.count(); left > 0; --left)
    data.parameters.push_back({.name = in.text(), .initial = in.real(), .lowest = in.real(), .highest = in.real()});
  for (std::size_t left = in.count(); left > 0; --left) {
    auto& row = data.rows.emplace_back();
    for (std::size_t entries = in.count(); entries > 0; --entries) row.push_back(in.text());
  }
  if (const auto first = static_cast<int>(in.below(BlendingFamily::most_rows + 1)); first > 0) data.first = 1 - first;
  data.ends = in.text();
  data.basis = static_cast<BlendingBasis>(in.below(static_cast<std::uint64_t>(BlendingBasis::bezier) + 1));
  return data;
}

/// The name of a method, or none and the rows of a family of one's own.
void write_family(StateWriter& out, const Method& method) {
  const BlendingData* const own = blending_of(method);
  out.text(own ? std::string_view() : family_of_method(method).value()->name);
  if (own) write(out, *own);
}
Expected<Method> read_family(StateReader& in) {
  const std::string name = in.text();
  if (!name.empty()) return Method(name);
  BlendingData data = read_blending(in);
  if (!in.is_sound()) return no_state("they end too early");
  auto family = BlendingFamily::make(std::move(data));
  if (!family) return no_state(family.error().message);
  return Method(std::move(*family));
}

void write(StateWriter& out, const Eigen::Vector3d& v) { out.vector(v); }
void write(StateWriter& out, const Eigen::Quaterniond& q) {
  for (const double component : q.coeffs()) out.real(component);
}
template <class T>
T read_entry(StateReader& in) {
  Eigen::Vector3d xyz = in.vector();
  if constexpr (std::same_as<T, Eigen::Vector3d>) return xyz;
  else return quaternion_xyzw(xyz.x(), xyz.y(), xyz.z(), in.real());
}
template <class T>
std::vector<T> read_entries(StateReader& in, std::size_t count) {
  std::vector<T> entries;
  for (std::size_t i = 0; i < count; ++i) entries.push_back(read_entry<T>(in));
  return entries;
}

void write(StateWriter& out, const TrackStretch& stretch) {
  out.whole(stretch.is_finished() ? 1 : 0);
  out.whole(stretch.first_key());
  write(out, stretch.start());
  out.whole(stretch.keys().first());
  const KeyframeData& data = stretch.keys().data();
  out.reals(data.times);
  for (const Eigen::Quaterniond& q : data.orientations) write(out, q);
  for_each_part([&](const auto& part) {
    const auto& list = data.*part.list;
    out.whole(list.empty() ? 0 : 1);
    for (const auto& value : list) write(out, value);
  });
  out.whole(stretch.keys().settings().size());
  for (const auto& values : stretch.keys().settings()) out.reals(values);
}

KeyframeData read_data(StateReader& in) {
  KeyframeData data{.times = in.reals()};
  data.orientations = read_entries<Eigen::Quaterniond>(in, data.times.size());
  for_each_part([&]<class T>(const KeyPart<T>& part) {
    if (in.below(2) == 1) data.*part.list = read_entries<T>(in, data.times.size());
  });
  return data;
}

Expected<TrackStretch> read_stretch(StateReader& in, std::uint64_t next, const StreamMethod& method,
                                    const std::optional<SampleGrid>& grid) {
  const Stream stream = in.below(2) == 1 ? Stream::finished : Stream::open;
  const std::uint64_t first_key = in.whole();
  const auto start = read_optional(in);
  const std::uint64_t first = in.whole();
  KeyframeData data = read_data(in);
  std::vector<std::vector<double>> settings;
  for (std::size_t left = in.count(); left > 0; --left) settings.push_back(in.reals());
  if (!in.is_sound()) return failure(ErrorCode::bad_data, "they end too early");
  return StreamKeys::from_kept(first, std::move(data), std::move(settings), method).and_then([&](StreamKeys keys) {
    return TrackStretch::from_kept(std::move(keys), stream, first_key, start, next, method, grid);
  });
}

}  // namespace

std::vector<std::byte> TrackState::bytes_of(const TrackSampler& sampler) {
  StateWriter out;
  out.whole(mark);
  write_family(out, sampler.given_);
  write(out, sampler.given_.options);
  out.whole(sampler.options_.signs == Signs::shortest ? 0 : 1);
  write(out, sampler.options_.gap);
  write(out, sampler.grid_);
  out.whole(sampler.keys_);
  out.whole(sampler.next_);
  for (const auto& time : {sampler.newest_, sampler.start_, sampler.end_}) write(out, time);
  write(out, sampler.alignment_);
  for_each_stream_part([&](const auto& part) { out.whole(sampler.parts_.*part.is_there ? 1 : 0); });
  out.whole(sampler.finished_ ? 1 : 0);
  out.whole(sampler.stretches_.size());
  for (const TrackStretch& stretch : sampler.stretches_) write(out, stretch);
  return std::move(out).sealed();
}

Expected<TrackSampler> TrackState::sampler_from(std::span<const std::byte> bytes) {
  StateReader in(bytes);
  if (!in.is_sound() || in.whole() != mark) return no_state("their mark or their checksum is wrong");
  auto family = read_family(in);
  if (!family) return tl::unexpected(std::move(family.error()));
  Method method = std::move(*family);
  method.options = read_options(in);
  TrackOptions options{.signs = in.below(2) == 0 ? Signs::shortest : Signs::as_given};
  options.gap = read_optional(in);
  const auto grid = read_grid(in);
  if (!grid) return no_state(grid.error().message);
  if (!in.is_sound()) return no_state("they end too early");
  auto sampler = TrackSampler::make(method, *grid, options);
  if (!sampler) return no_state(sampler.error().message);
  if (auto rest = read_rest(in, *sampler); !rest) return no_state(rest.error().message);
  return sampler;
}

Expected<void> TrackState::read_rest(StateReader& in, TrackSampler& sampler) {
  sampler.keys_ = in.whole();
  sampler.next_ = in.below(static_cast<std::uint64_t>(SampleGrid::most_samples) + 1);
  for (auto* time : {&sampler.newest_, &sampler.start_, &sampler.end_}) *time = read_optional(in);
  sampler.alignment_ = read_alignment(in, sampler.keys_);
  for_each_stream_part([&](const auto& part) { sampler.parts_.*part.is_there = in.below(2) == 1; });
  sampler.finished_ = in.below(2) == 1;
  const auto is_endless = [](const std::optional<double>& time) { return time && !std::isfinite(*time); };
  if (is_endless(sampler.start_) || is_endless(sampler.end_) || sampler.end_.has_value() != sampler.finished_ ||
      (sampler.end_ && !sampler.start_))
    return failure(ErrorCode::bad_data, "one of their curves has no start or no end");
  if (auto placed = sampler.place_grid(); !placed) return placed;
  for (std::size_t left = in.count(); left > 0; --left) {
    auto stretch = read_stretch(in, sampler.next_, sampler.method_, sampler.times_);
    if (!stretch) return tl::unexpected(std::move(stretch.error()));
    sampler.stretches_.push_back(std::move(*stretch));
  }
  return in.is_complete() ? sampler.check_order() : Expected<void>(failure(ErrorCode::bad_data, "they end elsewhere"));
}

}}  // namespace orispline
