// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/hermite_keys.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <orispline/clip/cubic_channel.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/families/hermite.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/number.hpp>
#include <orispline/reduce/hermite_span.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// How many keys on either side of a change get new rates: farther ones feel less than a fiftieth of it.
constexpr std::size_t rates_moved = 2;
constexpr int passes = 6;
/// How many earlier ends of a span are tried.
constexpr std::size_t most_ends = 16;

/// Keys in a chain of spans that hold, which becomes shorter.
template <CurvePoint P>
class HermiteChain {
 public:
  HermiteChain(const CubicSamples<P>& samples, double tolerance, const RatesAtEnds& given)
      : samples_(samples),
        last_(samples.size() - 1),
        is_given_{.first = given.first.has_value(), .last = given.last.has_value()},
        next_(samples.size(), none),
        previous_(samples.size(), none),
        rates_(samples.size(), Eigen::Vector3d::Zero()),
        spans_(samples.size()),
        may_be_spared_(samples.size(), true) {
    if (given.first) rates_.front() = *given.first;
    if (given.last) rates_.back() = *given.last;
    const double bound =
        std::same_as<P, Eigen::Quaterniond> ? elementary::sine_cosine(0.5 * std::min(tolerance, 3.0)).sine : tolerance;
    square_bound_ = bound * bound;
  }

  /// Spans from the first sample on: each ends where the next one gets farthest.
  void build(const std::function<bool()>& stopped) {
    std::size_t known = 1;  // a sample that the next span is taken to reach
    for (std::size_t key = 0; key < last_;) {
      if (stopped && stopped()) return append_rest(key);
      const std::size_t reached = farthest({.first = key, .inner = {}, .last = std::max(known, key + 1)});
      Change best{.first = key, .inner = {reached}, .last = reached + 1};
      if (reached < last_) {
        best.last = farthest(best);
        const std::size_t tried_back = (reached - key) * 3 / 4, step = tried_back / most_ends + 1;
        for (std::size_t less = step; less < tried_back && best.last < last_; less += step) {
          Change other{.first = key, .inner = {reached - less}, .last = best.last + 1};
          if (!holds(other)) continue;
          other.last = farthest(other);
          best = other;
        }
      }
      const bool is_put = put_first_of(best);
      if (!is_put && known > key + 1) {
        known = key + 1;
        continue;
      }
      if (!is_put) append_neighbour(key);
      key = next_[key];
      known = is_put ? std::min(best.last, last_) : key + 1;
    }
  }

  /// Takes keys out, and puts one in the place of two, until no key can be spared.
  void thin(const std::function<bool()>& stopped) {
    bool has_changed = true;
    for (int pass = 0; pass < passes && has_changed; ++pass) {
      has_changed = false;
      for (std::size_t key = next_[0]; key != last_; key = next_[key]) {
        if (stopped && stopped()) return;
        while (key != last_ && may_be_spared_[key]) {
          const auto found = spared(key);
          if (!found) {
            may_be_spared_[key] = false;
            break;
          }
          has_changed = true;
          key = *found;
        }
        if (key == last_) break;
      }
    }
  }

  [[nodiscard]] HermiteKeys keys() const {
    HermiteKeys keys;
    for (std::size_t key = 0; key != none; key = next_[key]) {
      keys.samples.push_back(key);
      keys.rates.push_back(rates_[key]);
    }
    return keys;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  using Span = HermiteSpan<P>;

  /// Keys in the place of those between two keys; the last one may be new, at the end of the chain.
  struct Change {
    std::size_t first;
    std::vector<std::size_t> inner;
    std::size_t last;
  };
  /// A row of keys whose rates may change but for its ends.
  struct Row {
    std::vector<std::size_t> keys;
    std::vector<Eigen::Vector3d> rates;
    std::vector<Span*> spans;
    std::vector<std::unique_ptr<Span>> made;  ///< those of the change
    FreeEnds free;
  };

  [[nodiscard]] std::unique_ptr<Span> made(std::size_t i, std::size_t j) const {
    return std::make_unique<Span>(samples_.targets, i * samples_.stride, j * samples_.stride, j > i + 1);
  }
  /// Readers may turn the other way by nearly 180°, and do by more.
  [[nodiscard]] bool may_join(std::size_t i, std::size_t j) const {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      return j == i + 1 || samples_.targets.points[i * samples_.stride].dot(
                               samples_.targets.points[j * samples_.stride]) > cosine_near_half_turn;
    else return true;
  }

  [[nodiscard]] Row row_of(const Change& change) const {
    Row row;
    std::size_t first = change.first;
    for (std::size_t k = 0; k < rates_moved && previous_[first] != none; ++k) first = previous_[first];
    for (std::size_t key = first; key != change.first; key = next_[key]) {
      row.keys.push_back(key);
      row.spans.push_back(spans_[key].get());
    }
    row.keys.push_back(change.first);
    const auto join = [&](std::size_t to) {
      row.made.push_back(made(row.keys.back(), to));
      row.spans.push_back(row.made.back().get());
      row.keys.push_back(to);
    };
    for (const std::size_t key : change.inner) join(key);
    join(change.last);
    for (std::size_t k = 0; k < rates_moved && next_[row.keys.back()] != none; ++k) {
      row.spans.push_back(spans_[row.keys.back()].get());
      row.keys.push_back(next_[row.keys.back()]);
    }
    for (const std::size_t key : row.keys) row.rates.push_back(rates_[key]);
    const bool ends_chain = next_[row.keys.back()] == none;
    row.free = {.first = first == 0 && !is_given_.first,
                .last = ends_chain && !(is_given_.last && row.keys.back() == last_)};
    return row;
  }

  [[nodiscard]] bool holds(Row& row) const {
    for (std::size_t k = 0; k + 1 < row.keys.size(); ++k)
      if (!may_join(row.keys[k], row.keys[k + 1])) return false;
    return find_rates<P>(row.spans, row.rates, row.free, square_bound_);
  }

  /// Makes the change where it holds.
  bool put(const Change& change) {
    Row row = row_of(change);
    if (!holds(row)) return false;
    commit(change, row);
    return true;
  }

  void commit(const Change& change, Row& row) {
    for (std::size_t key = next_[change.first]; key != none && key < change.last; key = next_[key]) spans_[key].reset();
    std::size_t key = change.first;
    for (std::size_t k = 0; k < row.made.size(); ++k) {
      const std::size_t to = k < change.inner.size() ? change.inner[k] : change.last;
      next_[key] = to;
      previous_[to] = key;
      spans_[key] = std::move(row.made[k]);
      key = to;
    }
    for (std::size_t k = 0; k < row.keys.size(); ++k) {
      rates_[row.keys[k]] = row.rates[k];
      may_be_spared_[row.keys[k]] = true;
    }
  }

  /// The neighbouring sample as the next key, with the rates before as they are.
  void append_neighbour(std::size_t key) {
    Row row{.keys = {key, key + 1}, .rates = {rates_[key], rates_[key + 1]}, .spans = {}, .made = {}, .free = {}};
    row.made.push_back(made(key, key + 1));
    row.spans.push_back(row.made.back().get());
    row.free.last = !(is_given_.last && key + 1 == last_);
    row.free.first = key == 0 && !is_given_.first;
    fit_rates<P>(row.spans, row.rates, row.free);
    commit({.first = key, .inner = {}, .last = key + 1}, row);
  }

  [[nodiscard]] bool holds(const Change& change) const {
    Row row = row_of(change);
    return holds(row);
  }

  /// The last sample that the end of a change at the end of the chain was found to get to, from its own on, which is
  /// taken to hold.
  [[nodiscard]] std::size_t farthest(Change change) const {
    std::size_t reached = change.last, step = 1, beyond = last_ + 1;
    const auto reaches = [&](std::size_t to) {
      change.last = to;
      return holds(change);
    };
    while (reached < last_) {
      const std::size_t to = std::min(reached + step, last_);
      if (!reaches(to)) {
        beyond = to;
        break;
      }
      reached = to;
      step *= 2;
    }
    while (beyond - reached > 1) {
      const std::size_t middle = reached + (beyond - reached) / 2;
      (reaches(middle) ? reached : beyond) = middle;
    }
    return reached;
  }

  /// The first span of a change at the end of the chain, with the rates of the whole change.
  bool put_first_of(const Change& change) {
    const Change first{.first = change.first, .inner = {}, .last = change.inner.front()};
    if (first.last == last_) return put(first);
    Row row = row_of(change);
    if (!holds(row)) return put(first);
    row.made.resize(1);
    row.keys.pop_back();
    row.rates.pop_back();
    commit(first, row);
    return true;
  }

  void append_rest(std::size_t key) {
    for (; key < last_; ++key) append_neighbour(key);
  }

  /// Where to go on after the key was taken out, or it and the next one became one; nothing where neither was found.
  std::optional<std::size_t> spared(std::size_t key) {
    const std::size_t before = previous_[key], after = next_[key];
    if (put({.first = before, .inner = {}, .last = after})) return after;
    if (after == last_) return std::nullopt;
    const std::size_t end = next_[after], between = (key + after) / 2;
    for (const std::size_t to : {between, key, after, (between + key) / 2, (between + after) / 2})
      if (put({.first = before, .inner = {to}, .last = end})) return to;
    return std::nullopt;
  }

  const CubicSamples<P>& samples_;
  std::size_t last_;
  double square_bound_;
  FreeEnds is_given_;                         ///< which rates at the ends of the chain are
  std::vector<std::size_t> next_, previous_;  ///< of every sample that is a key
  std::vector<Eigen::Vector3d> rates_;
  std::vector<std::unique_ptr<Span>> spans_;  ///< from a key to the next
  std::vector<bool> may_be_spared_;           ///< whether a key may be spared, as far as is known
};

/// Of the tolerance, for the keys of rotations; the rest is for the cubics.
constexpr double share_of_rates = 0.88;

Eigen::Vector3d rate_between(const CubicTargets<Eigen::Quaterniond>& targets, std::size_t i) {
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(targets.points[i]).conjugate() * Eigen::Quaterniond(targets.points[i + 1]);
  return log<double>(turn) / (targets.times[i + 1] - targets.times[i]);
}
Eigen::Vector3d rate_between(const CubicTargets<Eigen::Vector3d>& targets, std::size_t i) {
  return (targets.points[i + 1] - targets.points[i]) / (targets.times[i + 1] - targets.times[i]);
}

Expected<RotationChannel> channel_of(const CubicSamples<Eigen::Quaterniond>& samples, HermiteKeys found,
                                     double tolerance, const Method& method) {
  KeyframeData data{.angular_velocities = std::move(found.rates)};
  for (const std::size_t sample : found.samples) {
    data.times.push_back(samples.targets.times[sample * samples.stride]);
    data.orientations.emplace_back(samples.targets.points[sample * samples.stride]);
  }
  return Keyframes::make(std::move(data))
      .and_then([&](const Keyframes& keys) { return make_curve(method, keys); })
      .map([&](const AnyCurve& curve) { return cubic_channel(curve, (1.0 - share_of_rates) * tolerance).channel; });
}

Expected<VectorChannel> channel_of(const CubicSamples<Eigen::Vector3d>& samples, HermiteKeys found, double,
                                   const Method&) {
  VectorChannel channel{.interpolation = ChannelInterpolation::cubicspline};
  for (const std::size_t sample : found.samples) {
    channel.times.push_back(samples.targets.times[sample * samples.stride]);
    channel.values.push_back(samples.targets.points[sample * samples.stride]);
  }
  channel.in_tangents = channel.out_tangents = std::move(found.rates);
  return channel;
}

}  // namespace

template <CurvePoint P>
HermiteKeys fewest_hermite_keys(const CubicSamples<P>& samples, double tolerance, const RatesAtEnds& given,
                                const std::function<bool()>& stopped) {
  HermiteChain<P> chain(samples, tolerance, given);
  chain.build(stopped);
  chain.thin(stopped);
  return chain.keys();
}

template HermiteKeys fewest_hermite_keys(const CubicSamples<Eigen::Quaterniond>&, double, const RatesAtEnds&,
                                         const std::function<bool()>&);
template HermiteKeys fewest_hermite_keys(const CubicSamples<Eigen::Vector3d>&, double, const RatesAtEnds&,
                                         const std::function<bool()>&);

bool seeks_rates(const Method& method) {
  if (method.name != families::HermiteC1::info.name) return false;
  const auto form = method.options.choices.find("form");
  return form == method.options.choices.end() || form->second == families::HermiteC1::forms.front();
}

template <CurvePoint P>
Eigen::Vector3d rate_at_seam(const CubicTargets<P>& targets) {
  return 0.5 * (rate_between(targets, 0) + rate_between(targets, targets.times.size() - 2));
}

template <CurvePoint P>
Expected<Channel<P>> hermite_channel(const CubicSamples<P>& samples, double tolerance, const Method& method,
                                     const RatesAtEnds& given) {
  const double of_keys = std::same_as<P, Eigen::Quaterniond> ? share_of_rates * tolerance : tolerance;
  return channel_of(samples, fewest_hermite_keys(samples, of_keys, given), tolerance, method);
}

template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Quaterniond>&);
template Eigen::Vector3d rate_at_seam(const CubicTargets<Eigen::Vector3d>&);
template Expected<Channel<Eigen::Quaterniond>> hermite_channel(const CubicSamples<Eigen::Quaterniond>&, double,
                                                               const Method&, const RatesAtEnds&);
template Expected<Channel<Eigen::Vector3d>> hermite_channel(const CubicSamples<Eigen::Vector3d>&, double, const Method&,
                                                            const RatesAtEnds&);

}}  // namespace orispline
