// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_stream.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>

#include <orispline/base/parallel.hpp>
#include <orispline/families/handles.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/online/track_sampler.hpp>

#include "commands/sample/sample_buffer.hpp"
#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t keys_of_a_piece = 16384;
constexpr std::size_t samples_of_a_thread = 16384;  // at a time: far dearer than the thread
constexpr std::size_t most_samples_at_a_time = 8 * samples_of_a_thread;

/// The parameters of the method that columns of the file bring along with the keys.
Method with_columns(Method method, const io::KeyColumns& columns) {
  for (const io::ParameterColumn& column : columns.parameters) method.options.parameters.insert({column.name, {}});
  return method;
}

/// The size of a file in bytes; absent for a pipe.
std::optional<std::size_t> size_of_file(const std::string& path) {
  std::error_code none;
  const auto size = fs::file_size(path, none);
  return path == io::standard_stream || none ? std::nullopt : std::optional(static_cast<std::size_t>(size));
}

/// Where the keys that are still needed stand in the file.
class KeyLines {
 public:
  explicit KeyLines(std::string file) : file_(std::move(file)) {}

  /// Adds those of the next keys, and forgets the ones of keys before that one.
  void add(const std::vector<std::uint32_t>& lines, std::uint64_t oldest) {
    const auto passed = static_cast<std::size_t>(std::min<std::uint64_t>(oldest - first_, lines_.size()));
    lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(passed));
    first_ += passed;
    lines_.insert(lines_.end(), lines.begin(), lines.end());
  }
  [[nodiscard]] Error located(Error error) const {
    error.where.file = file_;
    const auto key = error.where.key;
    if (key && *key >= first_ && *key - first_ < lines_.size()) error.where.line = lines_[*key - first_];
    return error;
  }

 private:
  std::string file_;
  std::uint64_t first_ = 0;
  std::vector<std::uint32_t> lines_;
};

/// One run of the command, from the first key to the last sample.
class PiecewiseSampling {
 public:
  PiecewiseSampling(const SampleRequest& request, io::KeyReader keys)
      : request_(request),
        columns_(with_positions(request.columns, keys.columns()->position.has_value())),
        keys_(std::move(keys)),
        lines_(request.input.path),
        buffer_(columns_) {
    if (const auto bytes = size_of_file(request.input.path)) progress_.emplace(*bytes, request.progress);
  }

  [[nodiscard]] Expected<SampleReport> run() {
    while (!keys_.is_at_end()) {
      const auto done = read().and_then([this] { return keys_.is_at_end() ? end() : Expected<void>(); });
      if (!done) return tl::unexpected(done.error());
      if (auto written = write_ready(); !written) return tl::unexpected(std::move(written.error()));
    }
    return put_in_place(std::move(*output_)).map([this] { return report(); });
  }

 private:
  /// Takes the next keys. Errors: those of reading, and of keys that none can be.
  [[nodiscard]] Expected<void> read() {
    auto piece = keys_.next(keys_of_a_piece);
    if (!piece) return tl::unexpected(std::move(piece.error()));
    if (!sampler_) {
      if (auto begun = begin(piece->epoch); !begun) return begun;
      warn_of_first(*piece);
    }
    lines_.add(piece->lines, sampler_->keys() - sampler_->kept());
    repairs_ = piece->repairs;
    warn(piece->warnings);
    if (keys_.is_at_end() && piece->turns) warn_of_file(piece->turns->warnings(*request_.input.signs, piece->euler));
    const auto taken = sampler_->append(piece->data, piece->parameters);
    if (!taken) return tl::unexpected(placed(taken.error()));
    if (progress_) progress_->advance_to(keys_.bytes_read());
    return sampler_->start() ? check_range(times_wanted_, epoch_, *sampler_->start(), std::nullopt) : Expected<void>();
  }

  void warn_of_file(std::vector<Warning> warnings) const {
    for (Warning& warning : warnings) warning.where.file = request_.input.path;
    warn(warnings);
  }

  /// What the first keys tell of the method; how far keys turn is known of all at the end.
  void warn_of_first(const io::KeyFile& piece) const {
    auto keys = Keyframes::make(piece.data, *request_.input.signs);
    if (!keys) return;  // which append() tells
    Track track(*keys);
    track.name = request_.input.path;
    track.lines = piece.lines;
    track.settings = piece.parameters;
    auto warnings = warnings_of(request_.method, track);
    std::erase_if(warnings, [](const Warning& warning) { return warning.code == "near_half_turn"; });
    warn(warnings);
  }

  [[nodiscard]] Expected<void> begin(const Decimal& epoch) {
    epoch_ = epoch;
    times_wanted_ = anchored(request_.times, epoch);
    auto sampler =
        TrackSampler::make(with_columns(request_.method, *keys_.columns()),
                           {.request = grid_request(times_wanted_, epoch)}, {.signs = *request_.input.signs});
    if (!sampler) return tl::unexpected(std::move(sampler.error()));
    sampler_ = std::move(*sampler);
    return {};
  }

  /// Says that there are no more keys, and checks what depends on where they end.
  [[nodiscard]] Expected<void> end() {
    if (auto ended = sampler_->finish().and_then([this] { return sampler_->prepare(); }); !ended)
      return tl::unexpected(placed(std::move(ended.error())));
    if (auto checked = check_range(times_wanted_, epoch_, domain().start, domain().end); !checked) return checked;
    warn_of_file(warnings_of(sampler_->report()));
    if (request_.extrapolation == Extrapolation::hold) warn(range_warnings(times_wanted_, epoch_, domain()));
    if (request_.extrapolation == Extrapolation::error)
      if (auto stray = times().outside(domain())) return tl::unexpected(std::move(*stray));
    progress_.emplace(static_cast<std::size_t>(*sampler_->grid()->size()), request_.progress);
    return {};
  }

  [[nodiscard]] Expected<void> write_ready() {
    if (sampler_->ready() == 0) return {};
    auto number = check_number(times_wanted_, static_cast<double>(samples_) + static_cast<double>(sampler_->ready()));
    if (!number) return number;
    if (!output_) {
      const auto size = sampler_->grid()->size();
      auto output = open_samples(request_.output, columns_, static_cast<std::size_t>(size.value_or(0)));
      if (!output) return tl::unexpected(std::move(output.error()));
      output_ = std::move(*output);
    }
    const std::size_t most = std::min(most_samples_at_a_time, request_.threads * samples_of_a_thread);
    const TimeOrigin origin = times().origin();
    while (const std::uint64_t ready = sampler_->ready()) {
      if (auto written = write_some(static_cast<std::size_t>(std::min<std::uint64_t>(ready, most)), origin); !written)
        return written;
      if (sampler_->end()) progress_->advance_to(static_cast<std::size_t>(sampler_->next()));
    }
    return {};
  }

  /// The next samples, made and written.
  [[nodiscard]] Expected<void> write_some(std::size_t count, const TimeOrigin& origin) {
    const std::uint64_t first = sampler_->next();
    const auto threads = static_cast<unsigned>(request_.threads);
    buffer_.resize(count);
    if (auto taken = sampler_->take(buffer_.room(), buffer_.times(), {.threads = threads}); !taken)
      return tl::unexpected(placed(std::move(taken.error())));
    for (std::size_t k = 0; k < count; ++k) buffer_.offsets()[k] = sampler_->grid()->offset(first + k);
    // Angles that run on know those of the row before.
    const std::size_t parts = columns_.form.runs_on() ? 1 : request_.threads;
    rows_.resize(std::clamp<std::size_t>(parts, 1, (count + 1023) / 1024),
                 BufferRows(columns_, {.outside = request_.outside}));
    const auto begin = [&](std::size_t i) { return count * i / rows_.size(); };
    parallel_for(rows_.size(), threads,
                 [&](std::size_t i) { rows_[i].make(buffer_, begin(i), begin(i + 1), origin, domain()); });
    for (const BufferRows& rows : rows_) {
      const auto counts = rows.write(output_->file);
      if (!counts) return tl::unexpected(counts.error());
      held_ += counts->outside;
    }
    samples_ += count;
    return {};
  }

  /// Of the curve, as far as it is known.
  [[nodiscard]] Domain domain() const {
    return {*sampler_->start(), sampler_->end().value_or(std::numeric_limits<double>::infinity())};
  }
  [[nodiscard]] SampleTimes times() const {
    return {epoch_, *grid_request(times_wanted_, epoch_), *sampler_->start(), *sampler_->grid()};
  }
  /// What is wrong with the keys has its place in the file; the rest is the fault of the command line.
  [[nodiscard]] Error placed(Error error) const {
    if (!error.option.empty()) return error;
    if (!keys_.columns()->parameters.empty()) error.code = ErrorCode::bad_data;
    const bool concerns_file = error.code != ErrorCode::bad_argument || error.where.key;
    return concerns_file ? lines_.located(std::move(error)) : error;
  }

  [[nodiscard]] SampleReport report() const {
    const auto has = [](const auto& columns) { return columns.has_value(); };
    return {.outcome = {.source = request_.input.path,
                        .method = request_.method.name,
                        .method_text = text_of(request_.method),
                        .keys = static_cast<std::size_t>(sampler_->keys()),
                        .keyframes = sampler_->report(),
                        .rate_orders = static_cast<std::size_t>(std::ranges::count_if(keys_.columns()->rates, has)),
                        .inner_quaternions = std::ranges::any_of(keys_.columns()->inner, has),
                        .start = epoch_ + Decimal::from_double(domain().start),
                        .end = epoch_ + Decimal::from_double(domain().end),
                        .samples = samples_ - (request_.outside == LeftOut::yes ? held_ : 0),
                        .held_samples = held_,
                        .leaves_out = request_.outside == LeftOut::yes},
            .input = request_.input.path,
            .output = request_.output,
            .repairs = repairs_,
            .columns = columns_};
  }

  const SampleRequest& request_;
  io::SampleColumns columns_;
  io::KeyReader keys_;
  KeyLines lines_;
  SampleBuffer buffer_;
  std::vector<BufferRows> rows_;
  Decimal epoch_;
  TimeRequest times_wanted_;  // anchored at the first key
  std::optional<TrackSampler> sampler_;
  std::optional<Noted<io::SampleWriter>> output_;
  std::optional<Progress> progress_;  // through the file, then through the samples
  io::RepairReport repairs_;
  std::size_t samples_ = 0, held_ = 0;
};

/// Where samples go into the very file that keys are read from, all keys are read before the first sample is written.
bool writes_into_input(const SampleRequest& request) {
  std::error_code unknown;  // such as on systems without these names
  const std::string input = request.input.path == io::standard_stream ? "/dev/stdin" : request.input.path;
  return request.output == io::standard_stream && std::filesystem::equivalent(input, "/dev/stdout", unknown);
}

}  // namespace

bool goes_in_pieces(const SampleRequest& request, const io::KeyReader& keys) {
  const bool is_rate = std::holds_alternative<SampleGrid::Rate>(request.times.spacing);
  // All others are asked of the curve itself, which is gone by then.
  const bool only_held = request.extrapolation == Extrapolation::hold ||
                         request.extrapolation == Extrapolation::error || !(request.times.from || request.times.to);
  // A header that counts the rows stands before them; in a pipe that cannot be done later.
  const bool counts_later = !request.columns.format->writing.counts_rows || !io::is_stream(request.output);
  if (!keys.columns() || !is_rate || !only_held || !counts_later || request.truth || request.band ||
      request.input.read.sort || request.input.read.session || keys.recipe().gap || can_overwind(request.method) ||
      writes_into_input(request))
    return false;
  const auto sampler = TrackSampler::make(with_columns(request.method, *keys.columns()), {});
  return sampler && !sampler->is_global();
}

Expected<SampleReport> sample_in_pieces(const SampleRequest& request, io::KeyReader keys) {
  return PiecewiseSampling(request, std::move(keys)).run();
}

}  // namespace orispline::cli
