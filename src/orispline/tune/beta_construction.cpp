// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/families/beta.hpp>
#include <orispline/families/beta_through.hpp>
#include <orispline/tune/construction.hpp>
#include <orispline/tune/moving_controls.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

using families::BetaThrough;
using families::JointToKey;
using Points = std::vector<Quaternion<Slope>>;

/// β₁ and β₂ of every auxiliary point, which may change with one of the variables.
template <Number T>
struct Betas {
  std::vector<T> beta1, beta2;
};

/// Those of the keys.
Betas<double> betas_of(const FamilySettings& settings, std::size_t keys) {
  return {settings.per_key("beta1").all(keys), settings.per_key("beta2").all(keys)};
}

/// The same along one of them.
Betas<Slope> along(const Betas<double>& betas, const Variable& variable) {
  Betas<Slope> moving{{betas.beta1.begin(), betas.beta1.end()}, {betas.beta2.begin(), betas.beta2.end()}};
  (variable.parameter == "beta1" ? moving.beta1 : moving.beta2)[variable.key].c[1] = 1.0;
  return moving;
}

/// The ghosts have those of the end keys.
template <Number T>
Betas<T> with_ghosts(Betas<T> betas) {
  for (std::vector<T>* list : {&betas.beta1, &betas.beta2}) {
    list->insert(list->begin(), T(list->front()));
    list->push_back(T(list->back()));
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

template <Number T>
BetaShapeOver<T> shape_of(const Betas<T>& betas) {
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
std::vector<TensionSegment> segments_of(std::span<const Eigen::Quaterniond> points, const BetaShape& shape,
                                        std::span<const double> times) {
  std::vector<TensionSegment> segments;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    const BetaSegment<double> segment = beta_segment<double>(points, shape, i);
    segments.push_back(cumulative_segment(times[i - 1], times[i] - times[i - 1], segment.base, segment.increments));
  }
  return segments;
}

/// The published curve: segment i has the auxiliary points i … i + 3, which are keys.
class BetaConstruction final : public Construction {
 public:
  BetaConstruction(const Keyframes& keys, std::vector<Variable> list) : keys_(keys), list_(std::move(list)) {
    for (std::size_t i = 0; i + 3 < keys.size(); ++i) {
      variables_.emplace_back();
      for (std::size_t v = 0; v < list_.size(); ++v)
        if (i <= list_[v].key && list_[v].key <= i + 3) variables_.back().push_back(v);
    }
  }
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& variables() const noexcept override { return variables_; }

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto settings = settle(families::Beta::info, options, keys_.size());
    if (!settings) return std::nullopt;
    const Betas<double> betas = betas_of(*settings, keys_.size());
    const auto q = keys_.orientations();
    const auto shape = beta_shape(families::Beta::info.name, betas.beta1, betas.beta2);
    if (!shape) return std::nullopt;
    ConstructedCurve curve{segments_of(q, *shape, keys_.times().subspan(1)), {}};
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (work && work->stopped()) return std::nullopt;
      Points points;
      for (const Eigen::Quaterniond& key : q.subspan(i, 4)) points.push_back(constant<Slope>(key));
      curve.slopes.emplace_back();
      for (const std::size_t v : variables_[i]) {
        const BetaShapeOver<Slope> moving = shape_of(along(window(betas, i), local(v, i)));
        curve.slopes.back().push_back(slope_of(beta_segment<Slope>(points, moving, 1)));
      }
    }
    return curve;
  }

 private:
  /// Those of the four keys from key i on.
  static Betas<double> window(const Betas<double>& betas, std::size_t i) {
    const auto four = [i](const std::vector<double>& list) {
      const auto first = list.begin() + static_cast<std::ptrdiff_t>(i);
      return std::vector<double>(first, first + 4);
    };
    return {four(betas.beta1), four(betas.beta2)};
  }
  [[nodiscard]] Variable local(std::size_t v, std::size_t i) const {
    Variable variable = list_[v];
    variable.key -= i;
    return variable;
  }

  const Keyframes& keys_;
  std::vector<Variable> list_;
  std::vector<std::vector<std::size_t>> variables_;
};

/// The curve through the keys: all auxiliary points depend on every variable.
class BetaThroughConstruction final : public Construction {
 public:
  BetaThroughConstruction(const Keyframes& keys, std::vector<Variable> list)
      : keys_(keys), list_(std::move(list)), variables_(variables_in_reach(list_, keys.size() - 1)) {}
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& variables() const noexcept override { return variables_; }

  [[nodiscard]] std::optional<ConstructedCurve> at(const CurveOptions& options,
                                                   const OpenEndedWork* work) const override {
    const auto settings = settle(BetaThrough::info, options, keys_.size());
    if (!settings) return std::nullopt;
    const auto made = BetaThrough::construction(keys_, *settings);
    if (!made) return std::nullopt;
    const MovingControls controls(JointToKey<double>{&made->shape}, keys_.orientations(), made->points);
    if (!controls.regular()) return std::nullopt;
    const Betas<double> betas = betas_of(*settings, keys_.size());
    ConstructedCurve curve{segments_of(with_ghosts<double>(made->points), made->shape, keys_.times()),
                           std::vector<std::vector<SegmentSlope>>(variables_.size())};
    for (std::size_t v = 0; v < list_.size(); ++v) {
      if (work && work->stopped()) return std::nullopt;
      const BetaShapeOver<Slope> shape = shape_of(with_ghosts(along(betas, list_[v])));
      const Points points = with_ghosts<Slope>(controls.along(JointToKey<Slope>{&shape}));
      for (std::size_t i = 0; i < variables_.size(); ++i)
        if (!variables_[i].empty() && variables_[i].front() <= v && v <= variables_[i].back())
          curve.slopes[i].push_back(slope_of(beta_segment<Slope>(points, shape, i + 1)));
    }
    return curve;
  }

 private:
  const Keyframes& keys_;
  std::vector<Variable> list_;
  std::vector<std::vector<std::size_t>> variables_;
};

}  // namespace

std::unique_ptr<Construction> beta_construction(const Keyframes& keys, const std::vector<Variable>& variables) {
  return std::make_unique<BetaConstruction>(keys, variables);
}

std::unique_ptr<Construction> beta_through_construction(const Keyframes& keys,
                                                        const std::vector<Variable>& variables) {
  return std::make_unique<BetaThroughConstruction>(keys, variables);
}

}  // namespace orispline::inline ORISPLINE_ABI
