// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/sample_stream.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <variant>

#include <orispline/families/handles.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// With the parameters that come along with the keys.
Method with_settings(const StreamRequest& request) {
  Method method = request.method;
  for (const std::string& name : request.settings) method.options.parameters.insert({name, {}});
  return method;
}

std::size_t rate_orders_of(const KeyframeData& keys) {
  const std::array rates{&keys.angular_velocities, &keys.angular_accelerations, &keys.angular_jerks};
  return static_cast<std::size_t>(std::ranges::count_if(rates, [](const auto* values) { return !values->empty(); }));
}

}  // namespace

bool can_stream(const StreamRequest& request) {
  const bool is_rate = std::holds_alternative<SampleGrid::Rate>(request.times.spacing);
  // All others are asked of the curve itself, which is gone by then.
  const bool only_held = request.extrapolation == Extrapolation::hold ||
                         request.extrapolation == Extrapolation::error || !(request.times.from || request.times.to);
  if (!is_rate || !only_held || can_overwind(request.method)) return false;
  const auto sampler = TrackSampler::make(with_settings(request), {});
  return sampler && !sampler->is_global();
}

void StreamSamples::KeyLines::add(const std::vector<std::uint32_t>& lines, std::uint64_t oldest) {
  const auto passed = static_cast<std::size_t>(std::min<std::uint64_t>(oldest - first_, lines_.size()));
  lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(passed));
  first_ += passed;
  lines_.insert(lines_.end(), lines.begin(), lines.end());
}

Where StreamSamples::KeyLines::located(Where where) const {
  if (where.key && *where.key >= first_ && *where.key - first_ < lines_.size())
    where.line = lines_[static_cast<std::size_t>(*where.key - first_)];
  return where;
}

StreamSamples::StreamSamples(StreamRequest request) : request_(std::move(request)) {}

Expected<void> StreamSamples::next(SampleBlock& block, std::size_t most, Work work) {
  while (!is_at_end_ && (!sampler_ || sampler_->ready() == 0))
    if (auto done = read(); !done) return done;
  const std::uint64_t first = sampler_->next(), ready = sampler_->ready();
  if (auto number = check_number(request_.times, static_cast<double>(first) + static_cast<double>(ready)); !number)
    return number;
  block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(ready, most)));
  if (block.size() == 0) return {};
  if (!origin_) origin_ = times().origin();
  if (auto taken = sampler_->take(block.room(), block.times(), work); !taken)
    return tl::unexpected(placed(std::move(taken.error())));
  for (std::size_t k = 0; k < block.size(); ++k) block.offsets()[k] = sampler_->grid()->offset(first + k);
  return {};
}

/// Takes the next keys. Errors: those of reading, and of keys that none can be.
Expected<void> StreamSamples::read() {
  auto piece = request_.next();
  if (!piece) return tl::unexpected(std::move(piece.error()));
  if (!sampler_)
    if (auto begun = begin(*piece); !begun) return begun;
  lines_.add(piece->lines, sampler_->keys() - sampler_->kept());
  request_.warn(std::move(piece->warnings));
  if (auto taken = sampler_->append(piece->keys, piece->settings); !taken)
    return tl::unexpected(placed(std::move(taken.error())));
  is_at_end_ = piece->is_last;
  const auto checked =
      sampler_->start() ? check_range(request_.times, epoch_, *sampler_->start(), std::nullopt) : Expected<void>();
  return checked.and_then([this] { return is_at_end_ ? end() : Expected<void>(); });
}

Expected<void> StreamSamples::begin(const KeyPiece& piece) {
  epoch_ = piece.epoch;
  request_.times = anchored(std::move(request_.times), epoch_);
  rate_orders_ = rate_orders_of(piece.keys);
  inner_quaternions_ = !piece.keys.inner_leaving.empty() || !piece.keys.inner_arriving.empty();
  auto sampler = TrackSampler::make(with_settings(request_), {.request = grid_request(request_.times, epoch_)},
                                    {.signs = request_.signs});
  if (!sampler) return tl::unexpected(std::move(sampler.error()));
  sampler_ = std::move(*sampler);
  warn_of_first(piece);
  return {};
}

/// What the first keys tell of the method; how far keys turn is known of all at the end.
void StreamSamples::warn_of_first(const KeyPiece& piece) const {
  auto keys = Keyframes::make(piece.keys, request_.signs);
  if (!keys) return;  // which append() tells
  Track track(*keys);
  track.name = request_.source;
  track.lines = piece.lines;
  track.settings = piece.settings;
  auto warnings = warnings_of(request_.method, track);
  // The first is of all keys, told at the end; which span the second names takes all of them too.
  std::erase_if(warnings, [&](const Warning& warning) {
    return warning.code == "near_half_turn" || (warning.code == "overshot_span" && !piece.is_last);
  });
  request_.warn(std::move(warnings));
}

/// Says that there are no more keys, and checks what depends on where they end.
Expected<void> StreamSamples::end() {
  if (auto ended = sampler_->finish().and_then([this] { return sampler_->prepare(); }); !ended)
    return tl::unexpected(placed(std::move(ended.error())));
  if (auto checked = check_range(request_.times, epoch_, domain().start, domain().end); !checked) return checked;
  auto warnings = warnings_of(sampler_->report());
  for (Warning& warning : warnings) warning.where.file = request_.source;
  request_.warn(std::move(warnings));
  if (request_.extrapolation == Extrapolation::hold) request_.warn(range_warnings(request_.times, epoch_, domain()));
  if (request_.extrapolation == Extrapolation::error)
    if (auto stray = times().outside(domain())) return tl::unexpected(std::move(*stray));
  request_.ended(static_cast<std::size_t>(*sampler_->grid()->size()));
  return {};
}

SampleTimes StreamSamples::times() const {
  return {epoch_, *grid_request(request_.times, epoch_), *sampler_->start(), *sampler_->grid()};
}

Domain StreamSamples::domain() const {
  return {*sampler_->start(), sampler_->end().value_or(std::numeric_limits<double>::infinity())};
}

/// What is wrong with the keys has its place in the file; the rest is the fault of the command line.
Error StreamSamples::placed(Error error) const {
  if (!error.option.empty()) return error;
  if (!request_.settings.empty()) error.code = ErrorCode::bad_data;
  if (error.code == ErrorCode::bad_argument && !error.where.key) return error;
  error.where = lines_.located(std::move(error.where));
  error.where.file = request_.source;
  return error;
}

SampleOutcome StreamSamples::outcome() const {
  return {.source = request_.source,
          .method = request_.method.name,
          .method_text = text_of(request_.method),
          .keys = static_cast<std::size_t>(sampler_->keys()),
          .keyframes = sampler_->report(),
          .rate_orders = rate_orders_,
          .inner_quaternions = inner_quaternions_,
          .start = epoch_ + Decimal::from_double(domain().start),
          .end = epoch_ + Decimal::from_double(domain().end)};
}

}}}  // namespace orispline::jobs
