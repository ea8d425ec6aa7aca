// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/online_curve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <orispline/curve/control_points.hpp>
#include <orispline/curve/cumulative_curve.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/families/families.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The newest keys of a stream, at most the four that a segment depends on; their signs are chosen already.
struct RecentKeys {
  static constexpr std::size_t most = 4;
  std::size_t size = 0;
  std::array<double, most> times{};                     ///< [s]
  std::array<Eigen::Quaterniond, most> orientations{};  ///< body to world
  std::array<Eigen::Vector3d, most> positions{};        ///< [m]
  std::array<Eigen::Vector3d, most - 1> increments{};   ///< rotation vectors from each key to the next [rad]

  /// Adds a key; the oldest one goes when there are `most`.
  void push(double time, const Eigen::Quaterniond& orientation, const Eigen::Vector3d& position) noexcept;
};

enum class EndKey { first, last };

/// What leads from the ghost key to an end key seen inwards: rotation vector [rad] and displacement [m].
struct GhostIncrements {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), shift = Eigen::Vector3d::Zero();
};

/// Keys counted inwards from one end. The functions of an EndNeighbourhood hold one pointer to it: what is larger would
/// be put on the heap.
struct InwardKeys {
  EndKey end;
  const RecentKeys& keys;

  [[nodiscard]] std::size_t operator()(std::size_t j) const noexcept {
    return end == EndKey::first ? j : keys.size - 1 - j;
  }
  [[nodiscard]] double distance(std::size_t j) const noexcept {
    return std::abs(keys.times[(*this)(j)] - keys.times[(*this)(0)]);
  }
  [[nodiscard]] Eigen::Vector3d turn(std::size_t j) const noexcept {
    return increment<double>(keys.orientations[(*this)(0)], keys.orientations[(*this)(j)]);
  }
  [[nodiscard]] Eigen::Vector3d shift(std::size_t j) const noexcept {
    return keys.positions[(*this)(j)] - keys.positions[(*this)(0)];
  }
};

void RecentKeys::push(double time, const Eigen::Quaterniond& orientation, const Eigen::Vector3d& position) noexcept {
  if (size == most) {
    std::shift_left(times.begin(), times.end(), 1);
    std::shift_left(orientations.begin(), orientations.end(), 1);
    std::shift_left(positions.begin(), positions.end(), 1);
    std::shift_left(increments.begin(), increments.end(), 1);
    --size;
  }
  times[size] = time;
  orientations[size] = orientation;
  positions[size] = position;
  if (size > 0) increments[size - 1] = increment<double>(orientations[size - 1], orientation);
  ++size;
}

/// The ghost beyond the first or the last of these keys by the rule of that end; `weights` seen inwards from the key.
/// Errors: those of `ghost_increment`. Success allocates nothing.
Expected<GhostIncrements> ghost_beyond(EndKey which, const RecentKeys& keys, const End& end, RateWeights weights) {
  const InwardKeys inward{which, keys};
  const auto distance = [&inward](std::size_t j) { return inward.distance(j); };
  // Seen from the last key inwards time runs backwards: rates change sign.
  const Eigen::Vector3d rate = which == EndKey::first ? end.angular_velocity : Eigen::Vector3d(-end.angular_velocity);
  const auto turn =
      ghost_increment(end.rule, rate, weights,
                      {.distance = distance, .displacement = [&inward](std::size_t j) { return inward.turn(j); }});
  if (!turn) return tl::unexpected(turn.error());
  const auto shift =
      ghost_increment(rule_for_positions(end.rule), Eigen::Vector3d::Zero(), weights,
                      {.distance = distance, .displacement = [&inward](std::size_t j) { return inward.shift(j); }});
  if (!shift) return tl::unexpected(shift.error());
  return GhostIncrements{.turn = *turn, .shift = *shift};
}

/// A basis on one knot span, its polynomials formed once.
template <std::size_t M>
struct SpanBlending {
  static constexpr std::size_t increments = 3, stride = 1;
  static constexpr int degree = static_cast<int>(M) - 1;
  BernsteinRows<3, M> coefficients{};

  template <Number T>
  [[nodiscard]] std::array<T, 3> operator()(KnotSpan span, const T& t) const noexcept {
    return bernstein_sums(coefficients, span.normalised(t));
  }
};

/// What the span's blending functions are computed from at any time: their polynomials, or the basis itself.
template <class B>
auto blending_on([[maybe_unused]] KnotSpan span, const B& basis) noexcept {
  if constexpr (requires { basis.coefficients(span); })
    return SpanBlending<std::tuple_size_v<typename decltype(basis.coefficients(span))::value_type>>{
        basis.coefficients(span)};
  else return basis;
}

/// A segment of a cumulative curve that holds all that it depends on: evaluated by the formulas of the whole curve, it
/// gives the same bits.
template <CumulativeBasis B>
struct OnlineSegment {
  std::array<double, RecentKeys::most> times{};  ///< its knots and their neighbours [s]
  std::size_t knots = 0;                         ///< how many of these there are
  std::size_t start = 0;                         ///< its first knot among them
  Eigen::Quaterniond base = Eigen::Quaterniond::Identity();
  std::array<Eigen::Vector3d, B::increments> increments{};
  std::array<Eigen::Vector3d, B::increments + 1> points{};
  decltype(blending_on(KnotSpan{}, std::declval<const B&>())) blending{};

  [[nodiscard]] KnotSpan span() const noexcept {
    return {std::span(times).first(knots), start, times[1] - times[0], times[knots - 1] - times[knots - 2]};
  }

  /// From each of the positions to the next.
  [[nodiscard]] std::array<Eigen::Vector3d, B::increments> displacements() const noexcept {
    std::array<Eigen::Vector3d, B::increments> all;
    for (std::size_t k = 0; k < B::increments; ++k) all[k] = points[k + 1] - points[k];
    return all;
  }

  /// The segment as segment `start` of a curve that has nothing else.
  [[nodiscard]] PoseCurve curve(const B& basis) const {
    const Knots all({times.begin(), times.begin() + static_cast<std::ptrdiff_t>(knots)});
    return {.orientation = CumulativeCurve<B>(all, basis, polygon<Eigen::Quaterniond>(base, increments)),
            .position = CumulativePath<B>(all, basis, polygon<Eigen::Vector3d>(points[0], displacements()))};
  }

  /// Becomes, in place, the segment between the inner two of four keys.
  void blend(const B& basis, const RecentKeys& four_keys) noexcept {
    static_assert(B::increments == RecentKeys::most - 1);
    times = four_keys.times;
    knots = RecentKeys::most;
    start = 1;
    base = four_keys.orientations[0];
    increments = four_keys.increments;
    points = four_keys.positions;
    blending = blending_on(span(), basis);
  }

 private:
  /// That has these increments on the segment.
  template <CurvePoint P>
  [[nodiscard]] ControlPolygon<P> polygon(const P& first, const std::array<Displacement<P>, B::increments>& own) const {
    ControlPolygon<P> whole{
        .bases = std::vector<P>(knots - 1, first),
        .increments = std::vector<Displacement<P>>((knots - 2) * B::stride + B::increments, Displacement<P>::Zero())};
    std::ranges::copy(own, whole.increments.begin() + static_cast<std::ptrdiff_t>(start * B::stride));
    return whole;
  }
};

/// The segment from key `s` of these to the next one, two keys blended: slerp.
template <CumulativeBasis B>
requires(B::increments == 1) [[nodiscard]] OnlineSegment<B> two_key_segment(const RecentKeys& keys, std::size_t s) {
  return {.times = {keys.times[s], keys.times[s + 1]},
          .knots = 2,
          .base = keys.orientations[s],
          .increments = {keys.increments[s]},
          .points = {keys.positions[s], keys.positions[s + 1]}};
}

/// The segment from key `s` of these to the next one at an end of the curve, four keys blended. The ghosts of the ends
/// stand in for the keys that are not there. Errors: those of the ghosts.
template <CumulativeBasis B>
requires(B::increments == 3)
    [[nodiscard]] Expected<OnlineSegment<B>> end_segment(const B& basis, const RecentKeys& keys, std::size_t s,
                                                         const End& curve_start, const End& curve_end) {
  const bool has_before = s > 0, has_after = s + 2 < keys.size;
  const std::size_t first = has_before ? s - 1 : s, last = has_after ? s + 2 : s + 1;
  OnlineSegment<B> segment{.knots = last - first + 1, .start = s - first};
  for (std::size_t k = first; k <= last; ++k) segment.times[k - first] = keys.times[k];
  segment.increments[1] = keys.increments[s];
  segment.points[1] = keys.positions[s];
  segment.points[2] = keys.positions[s + 1];
  if (has_before) {
    segment.base = keys.orientations[s - 1];
    segment.increments[0] = keys.increments[s - 1];
    segment.points[0] = keys.positions[s - 1];
  } else {
    const auto ghost = ghost_beyond(EndKey::first, keys, curve_start, start_weights(basis, segment.span()));
    if (!ghost) return tl::unexpected(ghost.error());
    segment.base = keys.orientations[s] * exp<double>(-ghost->turn);
    segment.increments[0] = ghost->turn;
    segment.points[0] = keys.positions[s] - ghost->shift;
  }
  if (has_after) {
    segment.increments[2] = keys.increments[s + 1];
    segment.points[3] = keys.positions[s + 2];
  } else {
    const auto ghost = ghost_beyond(EndKey::last, keys, curve_end, end_weights(basis, segment.span()).mirrored());
    if (!ghost) return tl::unexpected(ghost.error());
    segment.increments[2] = -ghost->turn;
    segment.points[3] = keys.positions[s + 1] - ghost->shift;
  }
  segment.blending = blending_on(segment.span(), basis);
  return segment;
}

template <CumulativeBasis B>
class SegmentsOf final : public OnlineSegments {
 public:
  SegmentsOf(B basis, std::size_t places, const FamilySettings& settings)
      : basis_(std::move(basis)), start_(settings.start), end_(settings.end), ring_(places) {}

  [[nodiscard]] bool allocates() const noexcept override { return false; }
  void push(const StreamKey& key, const Eigen::Quaterniond& unit) override {
    keys_.push(key.time, unit, key.position.value_or(Eigen::Vector3d::Zero()));
  }
  /// Only the first segments can fail, by the ghost of the first key: nothing has left the recent keys yet.
  void pop() noexcept override { --keys_.size; }
  void reset() noexcept override { keys_.size = 0; }

  [[nodiscard]] Expected<Domain> store(std::size_t place, std::size_t behind, Stream) override {
    const std::size_t s = keys_.size - 1 - behind;
    if constexpr (B::increments == 1) {
      ring_[place] = two_key_segment<B>(keys_, s);
    } else if (s > 0 && s + 2 < keys_.size) {
      ring_[place].blend(basis_, keys_);
    } else if (auto stored = store_end(place, s); !stored) {
      return tl::unexpected(std::move(stored.error()));
    }
    return Domain{keys_.times[s], keys_.times[s + 1]};
  }
  [[nodiscard]] Eigen::Quaterniond orientation(double t, std::size_t place) const noexcept override {
    const OnlineSegment<B>& s = ring_[place];
    return cumulative_point(s.blending, s.span(), t, s.base, std::span(s.increments));
  }
  [[nodiscard]] Motion motion(double t, Side, std::size_t place) const noexcept override {
    const OnlineSegment<B>& s = ring_[place];
    return cumulative_motion(s.blending, s.span(), t, s.base, std::span(s.increments));
  }
  [[nodiscard]] LinearMotion linear_motion(double t, Side, std::size_t place) const noexcept override {
    const OnlineSegment<B>& s = ring_[place];
    const auto displacements = s.displacements();
    return motion_from_jet(
        cumulative_point(s.blending, s.span(), Jet<double, 3>::variable(t), s.points[0], std::span(displacements)));
  }
  void sample(std::span<const double> times, std::size_t place, const Samples<double>& out,
              std::size_t at) const override {
    sample_on_segment(ring_[place].curve(basis_), ring_[place].start, times, out, at);
  }

 private:
  [[nodiscard]] Expected<void> store_end(std::size_t place, std::size_t s) requires(B::increments == 3) {
    auto segment = end_segment(basis_, keys_, s, start_, end_);
    if (!segment) return tl::unexpected(std::move(segment.error()));
    ring_[place] = *segment;
    return {};
  }

  B basis_;
  End start_, end_;
  RecentKeys keys_;
  std::vector<OnlineSegment<B>> ring_;
};

using Made = std::unique_ptr<OnlineSegments>;

template <CumulativeBasis B>
Made segments_of(B basis, std::size_t places, const FamilySettings& settings) {
  return std::make_unique<SegmentsOf<B>>(std::move(basis), places, settings);
}

/// A family whose basis is the same for all settings.
template <class F>
concept FixedBasis = requires {
  requires std::is_empty_v<typename F::Basis>;
  requires F::Basis::increments == 1;
};
template <class F>
Made in_place([[maybe_unused]] std::size_t places, [[maybe_unused]] const FamilySettings& settings) {
  if constexpr (requires { F::basis(settings); }) return segments_of(F::basis(settings), places, settings);
  else if constexpr (requires { typename F::template Basis<1>; })
    return F::template with_basis<Made>(
               settings, [&](auto basis) -> Expected<Made> { return segments_of(std::move(basis), places, settings); })
        .value();
  else if constexpr (FixedBasis<F>) return segments_of(typename F::Basis{}, places, settings);
  else return nullptr;
}

struct Maker {
  std::string_view name;
  Made (*in_place)(std::size_t places, const FamilySettings& settings);
};

constexpr auto makers = []<class... F>(std::tuple<F...>*) {
  return std::array{Maker{F::info.name, in_place<F>}...};
}(static_cast<Families*>(nullptr));

constexpr auto local_names = []<class... F>(std::tuple<F...>*) {
  std::array<std::string_view, (std::size_t{0} + ... + (F::info.is_global() ? 0 : 1))> names;
  std::size_t count = 0;
  ((F::info.is_global() ? void() : void(names[count++] = F::info.name)), ...);
  return names;
}(static_cast<Families*>(nullptr));

}  // namespace

std::unique_ptr<OnlineSegments> segments_in_place(const StreamMethod& method, std::size_t places) {
  if (!method.per_key.empty() || method.own) return nullptr;
  const auto settings = settle(*method.family, method.options, RecentKeys::most);
  if (!settings) return nullptr;
  return std::ranges::find(makers, method.family->name, &Maker::name)->in_place(places, *settings);
}

std::span<const std::string_view> online_methods() noexcept { return local_names; }

}}  // namespace orispline
