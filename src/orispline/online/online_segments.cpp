// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/online_segments.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include <orispline/families/families.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/online/online_segment.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

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
  if (!method.per_key.empty()) return nullptr;
  const auto settings = settle(*method.family, method.options, RecentKeys::most);
  if (!settings) return nullptr;
  return std::ranges::find(makers, method.family->name, &Maker::name)->in_place(places, *settings);
}

std::span<const std::string_view> online_methods() noexcept { return local_names; }

}}  // namespace orispline
