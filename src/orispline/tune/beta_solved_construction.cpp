// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta_g2.hpp>
#include <orispline/families/beta_through.hpp>
#include <orispline/tune/moving_betas.hpp>
#include <orispline/tune/solved_construction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

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

std::unique_ptr<Construction> beta_through_construction(const Keyframes& keys, const FamilySettings&,
                                                        const std::vector<Variable>& variables) {
  return std::make_unique<BetaThroughConstruction>(keys, variables);
}

std::unique_ptr<Construction> beta_g2_global_construction(const Keyframes& keys, const FamilySettings&,
                                                          const std::vector<Variable>& variables) {
  return std::make_unique<BetaG2GlobalConstruction>(keys, variables);
}

}}  // namespace orispline
