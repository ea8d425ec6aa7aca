// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/solved_construction.hpp>

#include <algorithm>
#include <span>
#include <vector>

#include <orispline/families/beta.hpp>
#include <orispline/families/beta_g2.hpp>
#include <orispline/families/beta_g2_handles.hpp>
#include <orispline/families/beta_through.hpp>
#include <orispline/tune/construction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

// Beta curves as functions of one β.
using families::Betas;
using MovingBetas = families::BetasOver<Slope>;
using MovingPoints = std::vector<Quaternion<Slope>>;

/// These along a variable of the keys, the first of which is key `first`.
MovingBetas along(const Betas& betas, const Variable& variable, std::size_t first = 0) {
  MovingBetas moving{{betas.beta1.begin(), betas.beta1.end()}, {betas.beta2.begin(), betas.beta2.end()}};
  (variable.parameter == "beta1" ? moving.beta1 : moving.beta2)[variable.key - first].c[1] = 1.0;
  return moving;
}

/// Those of so many keys from that one on.
Betas window(const Betas& betas, std::size_t first, std::size_t count) {
  const auto some = [&](const std::vector<double>& list) {
    const auto start = list.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(start, start + static_cast<std::ptrdiff_t>(count));
  };
  return {some(betas.beta1), some(betas.beta2)};
}

MovingPoints still_points(std::span<const Eigen::Quaterniond> points) {
  MovingPoints still;
  for (const Eigen::Quaterniond& q : points) still.push_back(constant<Slope>(q));
  return still;
}

template <Number T>
BetaShapeOver<T> shape_of(const families::BetasOver<T>& betas) {
  return beta_shape_over(betas.beta1, betas.beta2);
}

/// How a segment changes with the variable that it is a function of.
SegmentSlope slope_of(const BetaSegment<Slope>& segment) {
  Eigen::Quaterniond base, change;
  for (Eigen::Index i = 0; i < 4; ++i) {
    base.coeffs()[i] = segment.base.coeffs()[i].c[0];
    change.coeffs()[i] = segment.base.coeffs()[i].c[1];
  }
  SegmentSlope slope{.increments = {}, .from = 2.0 * (base.conjugate() * change).vec()};
  for (std::size_t k = 0; k < segment.increments.size(); ++k) slope.increments[k] = slope_part(segment.increments[k]);
  return slope;
}

/// The segments of a Beta curve of these points between these times.
std::vector<TensionSegment> beta_segments(std::span<const Eigen::Quaterniond> points, const BetaShape& shape,
                                          std::span<const double> times) {
  std::vector<TensionSegment> segments;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    const BetaSegment<double> segment = beta_segment<double>(points, shape, i);
    segments.push_back(cumulative_segment(times[i - 1], times[i] - times[i - 1], segment.base, segment.increments));
  }
  return segments;
}

using families::BetaG2;
using families::betas_of;

/// The published curve, and the same corrected: segment i has the auxiliary points i … i + 3, which are keys, and its
/// correction those of the segment before as well.
class LocalBetas final : public Construction {
 public:
  LocalBetas(const FamilyInfo& family, const Keyframes& keys, std::vector<Variable> list)
      : family_(family), keys_(keys), list_(std::move(list)) {
    for (std::size_t i = 0; i + 3 < keys.size(); ++i) {
      variables_.emplace_back();
      for (std::size_t v = 0; v < list_.size(); ++v)
        if (first_key(i) <= list_[v].key && list_[v].key <= i + 3) variables_.back().push_back(v);
    }
  }
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& variables() const noexcept override { return variables_; }

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto settings = settle(family_, options, keys_.size());
    if (!settings) return std::nullopt;
    const Betas betas = betas_of(*settings, keys_.size());
    const auto shape = beta_shape(family_.name, betas.beta1, betas.beta2);
    if (!shape) return std::nullopt;
    ConstructedCurve curve{beta_segments(keys_.orientations(), *shape, keys_.times().subspan(1)), {}};
    for (std::size_t i = 1; corrected() && i < curve.segments.size(); ++i)
      curve.segments[i].correction = families::lacking_acceleration<double>(
          curve.segments[i - 1].increments, curve.segments[i].increments, betas.beta1[i + 1], betas.beta2[i + 1]);
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (work && work->stopped()) return std::nullopt;
      curve.slopes.emplace_back();
      for (const std::size_t v : variables_[i]) curve.slopes.back().push_back(slope(betas, i, v));
    }
    return curve;
  }

 private:
  [[nodiscard]] bool corrected() const noexcept { return family_.name == BetaG2::info.name; }
  [[nodiscard]] std::size_t first_key(std::size_t segment) const noexcept {
    return corrected() && segment > 0 ? segment - 1 : segment;
  }

  [[nodiscard]] SegmentSlope slope(const Betas& betas, std::size_t i, std::size_t v) const {
    const std::size_t first = first_key(i), count = i + 4 - first;
    const MovingPoints points = still_points(keys_.orientations().subspan(first, count));
    const MovingBetas moving = along(window(betas, first, count), list_[v], first);
    const BetaShapeOver<Slope> shape = shape_of(moving);
    const BetaSegment<Slope> segment = beta_segment<Slope>(points, shape, i + 1 - first);
    SegmentSlope slope = slope_of(segment);
    if (corrected() && i > 0)
      slope.correction = slope_part(families::lacking_acceleration<Slope>(
          beta_segment<Slope>(points, shape, 1).increments, segment.increments, moving.beta1[2], moving.beta2[2]));
    return slope;
  }

  const FamilyInfo& family_;
  const Keyframes& keys_;
  std::vector<Variable> list_;
  std::vector<std::vector<std::size_t>> variables_;
};

using families::BetaG2;
using families::betas_of;
using families::BetaThrough;
using families::JointToKey;

/// The ghosts have the betas of the end keys.
MovingBetas with_ghosts(MovingBetas betas) {
  for (std::vector<Slope>* list : {&betas.beta1, &betas.beta2}) {
    list->insert(list->begin(), Slope(list->front()));
    list->push_back(Slope(list->back()));
  }
  return betas;
}

template <Number T>
std::vector<Quaternion<T>> with_ghosts(std::vector<Quaternion<T>> points) {
  const std::size_t last = points.size() - 1;
  const Quaternion<T> before = reflection<T>(points[0], points[1]);
  const Quaternion<T> after = reflection<T>(points[last], points[last - 1]);
  points.insert(points.begin(), before);
  points.push_back(after);
  return points;
}

class BetaThroughConstruction final : public SolvedConstruction {
 public:
  using SolvedConstruction::SolvedConstruction;

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto settings = settle(BetaThrough::info, options, keys().size());
    if (!settings) return std::nullopt;
    const auto made = BetaThrough::construction(keys(), *settings);
    if (!made) return std::nullopt;
    const MovingControls controls(JointToKey<double>{&made->shape}, keys().orientations(), made->points);
    if (!controls.regular()) return std::nullopt;
    const Betas betas = betas_of(*settings, keys().size());
    return with_slopes(beta_segments(with_ghosts<double>(made->points), made->shape, keys().times()), work,
                       [&](const Variable& variable) {
                         const BetaShapeOver<Slope> shape = shape_of(with_ghosts(along(betas, variable)));
                         return [shape, points = with_ghosts<Slope>(controls.along(JointToKey<Slope>{&shape}))](
                                    std::size_t i) { return slope_of(beta_segment<Slope>(points, shape, i + 1)); };
                       });
  }
};

class BetaG2GlobalConstruction final : public SolvedConstruction {
 public:
  using SolvedConstruction::SolvedConstruction;

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto settings = settle(BetaG2::info, options, keys().size());
    if (!settings) return std::nullopt;
    const Betas betas = betas_of(*settings, keys().size());
    if (!beta_shape(BetaG2::info.name, betas.beta1, betas.beta2)) return std::nullopt;
    const auto chain = BetaG2::handles(keys(), *settings);
    if (!chain) return std::nullopt;
    BandedMatrix matrix(3 * keys().size(), 5);
    chain::differentiate(*chain, [&](std::size_t equation, std::size_t handle, const Eigen::Matrix3d& block) {
      matrix.add(3 * equation, 3 * handle, block);
    });
    const BandedLu equations(std::move(matrix));
    if (!equations.regular()) return std::nullopt;
    const auto q = keys().orientations();
    const auto t = keys().times();
    std::vector<TensionSegment> segments;
    for (std::size_t i = 0; i + 1 < q.size(); ++i)
      segments.push_back(cumulative_segment(t[i], t[i + 1] - t[i], q[i], chain->increments(i)));
    return with_slopes(std::move(segments), work, [&](const Variable& variable) {
      const MovingBetas moving = along(betas, variable);
      return [&chain, q, moving, v = moved_handles(*chain, equations, moving)](std::size_t i) {
        return slope_of(BetaSegment<Slope>{constant<Slope>(q[i]), chain->template increments<Slope>(i, v, moving)});
      };
    });
  }

 private:
  using Chain = families::HandleChain<Eigen::Quaterniond>;

  /// The handles as functions of what the betas are functions of.
  static std::vector<Vector3<Slope>> moved_handles(const Chain& chain, const BandedLu& equations,
                                                   const MovingBetas& betas) {
    std::vector<Vector3<Slope>> handles;
    for (const Eigen::Vector3d& v : chain.handles()) handles.push_back(constant<Slope>(v));
    const std::vector<Vector3<Slope>> missing = chain.missing<Slope>(handles, betas);
    Eigen::VectorXd change(3 * static_cast<Eigen::Index>(handles.size()));
    for (std::size_t i = 0; i < handles.size(); ++i)
      change.segment<3>(3 * static_cast<Eigen::Index>(i)) = -slope_part(missing[i]);
    change = equations.solve(std::move(change));
    for (std::size_t i = 0; i < handles.size(); ++i)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        handles[i][axis].c[1] = change[3 * static_cast<Eigen::Index>(i) + axis];
    return handles;
  }
};

}  // namespace

std::unique_ptr<Construction> beta_construction(const Keyframes& keys, const FamilySettings&,
                                                const std::vector<Variable>& variables) {
  return std::make_unique<LocalBetas>(families::Beta::info, keys, variables);
}

std::unique_ptr<Construction> beta_g2_construction(const Keyframes& keys, const FamilySettings& settings,
                                                   const std::vector<Variable>& variables) {
  if (BetaG2::is_global(settings)) return beta_g2_global_construction(keys, settings, variables);
  return std::make_unique<LocalBetas>(BetaG2::info, keys, variables);
}

std::unique_ptr<Construction> beta_through_construction(const Keyframes& keys, const FamilySettings&,
                                                        const std::vector<Variable>& variables) {
  return std::make_unique<BetaThroughConstruction>(keys, variables);
}

std::unique_ptr<Construction> beta_g2_global_construction(const Keyframes& keys, const FamilySettings&,
                                                          const std::vector<Variable>& variables) {
  return std::make_unique<BetaG2GlobalConstruction>(keys, variables);
}

}}  // namespace orispline
