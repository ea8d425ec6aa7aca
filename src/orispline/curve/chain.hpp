// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/chain_jacobian.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Unknown vectors in a row and as many equations, each of which involves one unknown and its two neighbours: what the
/// curves solve that depend on all keys.
///
/// A problem holds its present state. `residual(steps)` are the values of the equations [rad] or [m] at the state moved
/// by the steps, over any Number; `move(steps)` moves the state. In a closed chain the first and the last are
/// neighbours. `plausible()` is false at a solution of the equations that is not a curve worth having. A problem that
/// knows the derivatives of its equations tells them by `jacobian(take)`.
template <class P>
concept ChainProblem = std::copyable<P> && requires(P& p, const P& c, std::span<const Vector3<double>> steps) {
  { c.size() } -> std::convertible_to<std::size_t>;
  { c.closed() } -> std::convertible_to<bool>;
  { c.template residual<double>(steps) } -> std::same_as<std::vector<Vector3<double>>>;
  { c.plausible() } -> std::convertible_to<bool>;
  p.move(steps);
};

namespace chain {

/// Residuals below this [rad], [m] solve a chain.
inline constexpr double tolerance = 1e-12;

using Steps = std::vector<Eigen::Vector3d>;

/// A problem without its type.
struct Equations {
  std::size_t size;
  bool closed;
  std::function<Steps(const Steps&)> residual;
  std::function<void(const TakeBlock&)> jacobian;  ///< at the state
  std::function<void(const Steps&)> move;
};

struct Outcome {
  double residual;    ///< the largest [rad], [m]
  std::size_t worst;  ///< the equation that has it
  [[nodiscard]] bool solved() const noexcept { return residual <= tolerance; }
};

/// Newton's method with a Jacobian that is kept while it serves, damped; where it stalls, Levenberg–Marquardt. Linear
/// cost in the size of the chain. Moves the state to the best point found.
[[nodiscard]] Outcome solve(const Equations& equations);

[[nodiscard]] Error not_converged(std::string_view method, const Outcome& outcome, double share);

/// The derivatives of a problem's equations: its own, or from its residual over duals.
template <ChainProblem P>
void differentiate(const P& problem, const TakeBlock& take) {
  if constexpr (requires { problem.jacobian(take); }) problem.jacobian(take);
  else
    differentiate(
        problem.size(), problem.closed(),
        [&](const DualSteps& steps) { return problem.template residual<Dual9>(steps); }, take);
}

template <ChainProblem P>
[[nodiscard]] Outcome solve(P& problem) {
  return solve(Equations{.size = problem.size(),
                         .closed = problem.closed(),
                         .residual = [&](const Steps& steps) { return problem.template residual<double>(steps); },
                         .jacobian = [&](const TakeBlock& take) { differentiate(problem, take); },
                         .move = [&](const Steps& steps) { problem.move(steps); }});
}

}  // namespace chain

/// Solves a chain: directly, or where that fails by continuation from keys whose increments are shortened.
///
/// `make(share, before)` states the problem for increments of `share` times their length, 0 < share ≤ 1; `before` is
/// the last solved problem, null at first. Errors: not_converged with the residual and the key where it is largest.
template <class Make>
[[nodiscard]] auto solve_chain(std::string_view method, Make make)
    -> Expected<std::invoke_result_t<Make, double, std::nullptr_t>> {
  using Problem = std::invoke_result_t<Make, double, std::nullptr_t>;
  Problem direct = make(1.0, nullptr);
  const chain::Outcome first = chain::solve(direct);
  if (first.solved() && direct.plausible()) return direct;
  std::optional<Problem> last;
  double share = 0.0, advance = 0.125;
  while (share < 1.0) {
    const double next = std::min(1.0, share + advance);
    Problem problem = make(next, last ? &*last : nullptr);
    if (chain::solve(problem).solved() && problem.plausible()) {
      last = std::move(problem);
      share = next;
      advance = std::min(1.5 * advance, 0.25);
    } else {
      advance *= 0.5;
      if (advance < 1.0 / 256) return tl::unexpected(chain::not_converged(method, first, share));
    }
  }
  return std::move(*last);
}

}}  // namespace orispline
