// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <vector>

#include <orispline/batch/path_sampler.hpp>
#include <orispline/batch/segment_sampler.hpp>
#include <orispline/online/online_curve.hpp>
#include <orispline/online/stream_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A curve of which the part between two times has the bits of the whole.
struct Piece {
  PoseCurve curve;
  Domain domain;

  /// At the end of the piece always the segment to the left, for the next one is not yet as it will be.
  [[nodiscard]] std::size_t segment_at(double t, Side side) const noexcept {
    return curve.orientation.knots().segment_at(t, t < domain.end ? side : Side::left);
  }
};

class WindowSegments final : public OnlineSegments {
 public:
  WindowSegments(const StreamMethod& method, std::size_t places) : method_(method), ring_(places) {}

  [[nodiscard]] bool allocates() const noexcept override { return true; }
  void push(const StreamKey& key, const Eigen::Quaterniond& unit) override {
    StreamKey aligned = key;
    if (key.orientation.dot(unit) < 0.0) aligned.orientation.coeffs() = -key.orientation.coeffs();
    keys_.push(aligned);
  }
  void pop() noexcept override { keys_.pop(); }
  void reset() noexcept override { keys_.clear(); }

  [[nodiscard]] Expected<Domain> store(std::size_t place, std::size_t behind, Stream stream) override {
    const std::size_t stride = method_.family->key_use.stride;
    const std::uint64_t start = keys_.count() - 1 - behind;
    auto curve = keys_.curve_from(keys_.needed_from(start, method_), method_, stream);
    if (!curve) return tl::unexpected(std::move(curve.error()));
    const Domain domain{keys_.time(start), keys_.time(start + stride)};
    ring_[place] = Piece{std::move(*curve), domain};
    if (stream == Stream::open) keys_.forget_before(keys_.needed_from(start + stride, method_));
    return domain;
  }
  [[nodiscard]] Eigen::Quaterniond orientation(double t, std::size_t place) const noexcept override {
    const Piece& piece = *ring_[place];
    return piece.curve.orientation.orientation_on(piece.segment_at(t, Side::right), t);
  }
  [[nodiscard]] Motion motion(double t, Side side, std::size_t place) const noexcept override {
    const Piece& piece = *ring_[place];
    return piece.curve.orientation.motion_on(piece.segment_at(t, side), t);
  }
  [[nodiscard]] LinearMotion linear_motion(double t, Side side, std::size_t place) const noexcept override {
    const Piece& piece = *ring_[place];
    return piece.curve.position->linear_motion_on(piece.segment_at(t, side), t);
  }
  void sample(std::span<const double> times, std::size_t place, const Samples<double>& out,
              std::size_t at) const override {
    const Piece& piece = *ring_[place];
    sample_on_segment(piece.curve, piece.segment_at(piece.domain.start, Side::right), times, out, at);
  }

 private:
  StreamMethod method_;
  StreamKeys keys_;
  std::vector<std::optional<Piece>> ring_;
};

}  // namespace

void sample_on_segment(const PoseCurve& curve, std::size_t segment, std::span<const double> times,
                       const Samples<double>& out, std::size_t at) {
  const batch::Clock clock{.times = times.data(), .start = 0.0, .step = 0.0, .first = 0.0};
  batch::SegmentSampler<double>(curve.orientation, nullptr, out).on_segment(segment, clock, at, times.size());
  if (wants_positions(out))
    batch::PathSampler<double>(*curve.position, out).on_segment(segment, clock, at, times.size());
}

std::unique_ptr<OnlineSegments> segments_of_windows(const StreamMethod& method, std::size_t places) {
  return std::make_unique<WindowSegments>(method, places);
}

}}  // namespace orispline
