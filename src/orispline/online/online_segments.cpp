// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/online_segments.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <orispline/online/online_segment.hpp>
#include <orispline/families/families.hpp>

namespace orispline {
namespace {

template <CumulativeBasis B>
class SegmentsOf final : public OnlineSegments {
 public:
  SegmentsOf(B basis, std::size_t places, const FamilySettings& settings)
      : basis_(std::move(basis)), start_(settings.start), end_(settings.end), ring_(places) {}

  [[nodiscard]] std::size_t look_ahead() const noexcept override { return B::increments == 1 ? 0 : 1; }
  [[nodiscard]] Expected<void> store(std::size_t place, const RecentKeys& keys, std::size_t s) override {
    if constexpr (B::increments == 1) {
      ring_[place] = two_key_segment<B>(keys, s);
    } else if (s > 0 && s + 2 < keys.size) {
      ring_[place].blend(basis_, keys);
    } else {
      return store_end(place, keys, s);
    }
    return {};
  }
  [[nodiscard]] Eigen::Quaterniond orientation(double t, std::size_t place) const noexcept override {
    const OnlineSegment<B>& s = ring_[place];
    return cumulative_point(s.blending, s.span(), t, s.base, std::span(s.increments));
  }
  [[nodiscard]] Motion motion(double t, std::size_t place) const noexcept override {
    const OnlineSegment<B>& s = ring_[place];
    return cumulative_motion(s.blending, s.span(), t, s.base, std::span(s.increments));
  }
  [[nodiscard]] LinearMotion linear_motion(double t, std::size_t place) const noexcept override {
    const OnlineSegment<B>& s = ring_[place];
    const auto displacements = s.displacements();
    return motion_from_jet(
        cumulative_point(s.blending, s.span(), Jet<double, 3>::variable(t), s.points[0], std::span(displacements)));
  }

 private:
  [[nodiscard]] Expected<void> store_end(std::size_t place, const RecentKeys& keys,
                                         std::size_t s) requires(B::increments == 3) {
    auto segment = end_segment(basis_, keys, s, start_, end_);
    if (!segment) return tl::unexpected(std::move(segment.error()));
    ring_[place] = *segment;
    return {};
  }

  B basis_;
  End start_, end_;
  std::vector<OnlineSegment<B>> ring_;
};

using Made = Expected<std::unique_ptr<OnlineSegments>>;

template <CumulativeBasis B>
Made segments_of(B basis, std::size_t places, const FamilySettings& settings) {
  return std::make_unique<SegmentsOf<B>>(std::move(basis), places, settings);
}

/// How a family's segments are made; null for those whose segments blend other things than two or four keys.
template <class F>
constexpr auto maker() -> Made (*)(std::size_t, const FamilySettings&) {
  if constexpr (requires(const FamilySettings& settings) { F::basis(settings); })
    return [](std::size_t places, const FamilySettings& settings) {
      return segments_of(F::basis(settings), places, settings);
    };
  else if constexpr (std::same_as<F, families::UniformFamily>)
    return [](std::size_t places, const FamilySettings& settings) {
      return F::template with_basis<std::unique_ptr<OnlineSegments>>(
          settings, [&](auto basis) { return segments_of(std::move(basis), places, settings); });
    };
  else if constexpr (std::same_as<F, families::Slerp>)
    return [](std::size_t places, const FamilySettings& settings) {
      return segments_of(families::Slerp::Basis{}, places, settings);
    };
  else return nullptr;
}

constexpr auto all_families = []<class... F>(std::tuple<F...>*) {
  return std::array{OnlineMethod{&F::info, maker<F>()}...};
}(static_cast<Families*>(nullptr));

constexpr auto is_online = [](const OnlineMethod& method) { return method.segments != nullptr; };
constexpr std::size_t count_of_online = static_cast<std::size_t>(std::ranges::count_if(all_families, is_online));
constexpr auto names = [] {
  std::array<std::string_view, count_of_online> online;
  std::size_t count = 0;
  for (const OnlineMethod& method : all_families)
    if (is_online(method)) online[count++] = method.family->name;
  return online;
}();

}  // namespace

std::span<const std::string_view> online_methods() noexcept { return names; }

Expected<OnlineMethod> find_online_method(std::string_view name) {
  for (const OnlineMethod& method : all_families)
    if (is_online(method) && method.family->name == name) return method;
  return failure(ErrorCode::bad_argument,
                 fmt::format("no online curve of method '{}', wanted one of {}", name, fmt::join(names, ", ")));
}

}  // namespace orispline
