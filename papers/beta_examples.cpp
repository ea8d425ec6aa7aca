// SPDX-License-Identifier: Apache-2.0
// He et al. 2022, examples 1 and 2.
#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/families/beta.hpp>
#include <orispline/math/degrees.hpp>

#include "papers/beta_example.hpp"
#include "papers/papers_algebra.hpp"
#include "papers/sampling.hpp"

namespace orispline::cli {

namespace {

using report::Notation;
namespace color = report::color;

/// Quaternions as the paper prints them.
using Points = std::vector<Eigen::Quaterniond>;

Points example1() {
  return {quaternion_wxyz(-0.2011, -0.7478, 0.0791, 0.6278), quaternion_wxyz(-0.1603, 0.6073, 0.3653, 0.6871),
          quaternion_wxyz(-0.4696, 0.0554, -0.8480, -0.2394), quaternion_wxyz(-0.5268, -0.5665, -0.4194, -0.4751),
          quaternion_wxyz(0.6921, -0.2551, 0.1314, 0.6623)};
}

Points example2() {
  return {quaternion_wxyz(0.6387, -0.6301, -0.3306, 0.2927), quaternion_wxyz(0.4412, -0.7009, -0.5567, 0.0646),
          quaternion_wxyz(-0.8180, 0.5011, 0.0249, 0.2813), quaternion_wxyz(0.7494, -0.5340, -0.0433, -0.3891),
          quaternion_wxyz(0.9914, 0.0398, 0.1179, -0.0393)};
}

/// q_{1,0} … q_{2,3} of example 1 in the paper, the common one once.
Points printed_control_points() {
  return {quaternion_wxyz(-0.3796, 0.4589, 0.1106, 0.7956),    quaternion_wxyz(-0.4610, 0.6671, -0.1507, 0.5655),
          quaternion_wxyz(-0.5894, 0.4380, -0.6543, 0.1810),   quaternion_wxyz(-0.6093, 0.1514, -0.7734, -0.0877),
          quaternion_wxyz(-0.5263, -0.1607, -0.7619, -0.3415), quaternion_wxyz(-0.5474, -0.3901, -0.6038, -0.4284),
          quaternion_wxyz(-0.3509, -0.7065, -0.5548, -0.2642)};
}

Expected<BetaExample> beta_example(Points points, Signs signs, double beta2_of_point1 = beta2) {
  KeyframeData data{.orientations = std::move(points)};
  for (std::size_t i = 0; i < data.orientations.size(); ++i) data.times.push_back(static_cast<double>(i));
  return Keyframes::make(std::move(data), signs).and_then([&](const Keyframes& keys) {
    std::vector<double> all_beta2(keys.size(), beta2);
    all_beta2[1] = beta2_of_point1;
    const CurveOptions options{.parameters = {{"beta1", {beta1}}, {"beta2", std::move(all_beta2)}}};
    return settle(families::Beta::info, options, keys.size())
        .and_then([&](const FamilySettings& settings) { return families::Beta::curve(keys, settings); })
        .map([&](CubicBezierCurve curve) {
          return BetaExample{keys, std::move(curve)};
        });
  });
}

Points control_points(const CubicBezierCurve& curve) {
  Points points{curve.polygon().bases[0]};
  for (const Eigen::Vector3d& increment : curve.polygon().increments)
    points.push_back(points.back() * exp<double>(increment));
  return points;
}

/// s' and s'' of two segments where they meet, in the local parameter.
struct Joint {
  AnyQuaternion before1, before2, after1, after2;
};

/// Behind that segment.
Joint joint_of(const CubicBezierCurve& curve, std::size_t segment) {
  const auto t = Jet<double, 2>::variable(curve.knots().times()[segment + 1]);
  const auto before = curve.point(t, segment), after = curve.point(t, segment + 1);
  return {derivative(before, 1), derivative(before, 2), derivative(after, 1), derivative(after, 2)};
}

double g1_residual(const Joint& j) { return gap(j.after1, beta1 * j.before1); }

double g2_residual(const Joint& j, double delta) {
  return gap(j.after2, beta1 * beta1 * j.before2 + delta * j.before1);
}

/// The δ that leaves the least of the second constraint.
double best_delta(const Joint& j) {
  const AnyQuaternion missing = j.after2 - beta1 * beta1 * j.before2;
  return (missing * j.before1.conjugate()).scalar() / j.before1.norm();
}

/// What the condition of theorem 2, (10), leaves at a joint.
struct Theorem2 {
  double as_printed, corrected, gamma;
};

Theorem2 theorem2(const BetaExample& example, std::size_t segment) {
  const double gamma = 2.0 * (1.0 + beta1) / (beta2 + 2.0 * beta1 * (1.0 + beta1));
  const double delta = gamma + 1.0 + beta1 * beta1 * gamma;
  const auto p = example.keys.orientations();
  const Points q = control_points(example.curve);
  const auto log_of = [](const AnyQuaternion& a, const AnyQuaternion& b) { return half_log(a * b); };
  const std::size_t at = 3 * (segment + 1);
  const Eigen::Quaterniond &earlier = p[segment + 1], &here = p[segment + 2], &later = p[segment + 3];
  const AnyQuaternion joint = q[at], left = joint * log_of(q[at - 1].conjugate(), q[at + 1]);
  const AnyQuaternion first = gamma / delta * (joint * log_of(here.conjugate(), later));
  const AnyQuaternion printed = beta1 * gamma / delta * (log_of(earlier.conjugate(), here) * joint);
  const AnyQuaternion right = beta1 * beta1 * gamma / delta * (log_of(here, earlier.conjugate()) * joint);
  return {gap(left, first + printed), gap(left, first + right), gamma};
}

report::Table control_points_table(const BetaExample& example) {
  report::Table table{.title = "Example 1: the control points of the two segments, in brackets as printed",
                      .columns = {{"point"},
                                  {"qw", Notation::fixed, 6},
                                  {"qx", Notation::fixed, 6},
                                  {"qy", Notation::fixed, 6},
                                  {"qz", Notation::fixed, 6},
                                  {"printed"},
                                  {"largest difference", Notation::scientific, 1}}};
  constexpr std::array names{"q10", "q11", "q12", "q13 = q20", "q21", "q22", "q23"};
  const Points found = control_points(example.curve), printed = printed_control_points();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Eigen::Quaterniond &q = found[i], &p = printed[i];
    table.rows.push_back({names[i], q.w(), q.x(), q.y(), q.z(),
                          formatted("({:.4f}, {:.4f}, {:.4f}, {:.4f})", p.w(), p.x(), p.y(), p.z()),
                          (q.coeffs() - p.coeffs()).lpNorm<Eigen::Infinity>()});
  }
  table.notes = {
      "All seven agree to the printed digits, but only with the signs of the points as given, with steps up to 252°."};
  return table;
}

/// Of keys for which the paper prints nothing.
report::Table own_control_points_table(const BetaExample& example, const std::string& note) {
  report::Table table{.title = "The control points of the segments, signs as given",
                      .columns = {{"point"},
                                  {"qw", Notation::fixed, 6},
                                  {"qx", Notation::fixed, 6},
                                  {"qy", Notation::fixed, 6},
                                  {"qz", Notation::fixed, 6}},
                      .notes = {note, "Their times do not count: a segment lasts 1, as in the paper."}};
  const Points found = control_points(example.curve);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Eigen::Quaterniond& q = found[i];
    const bool is_last = i + 1 == found.size();
    table.rows.push_back(
        {is_last ? formatted("q{}3", i / 3) : formatted("q{}{}", i / 3 + 1, i % 3), q.w(), q.x(), q.y(), q.z()});
  }
  return table;
}

/// The points of one's own keys, with the signs of their file.
Points points_of(const KeysInstead& keys) {
  if (!keys.as_given.empty()) return keys.as_given;
  return {keys.keys.orientations().begin(), keys.keys.orientations().end()};
}

Expected<std::vector<NamedExample>> with_both_signs(const Points& points, double beta2_of_point1 = beta2) {
  std::vector<NamedExample> examples;
  for (const auto& [name, signs] : {std::pair{"as given", Signs::as_given}, std::pair{"shortest", Signs::shortest}}) {
    auto example = beta_example(points, signs, beta2_of_point1);
    if (!example) return tl::unexpected(std::move(example.error()));
    examples.push_back({name, std::move(*example)});
  }
  return examples;
}

/// The residuals where a segment ends and the next one begins.
std::vector<report::Cell> residuals(const std::string& signs, const BetaExample& example, std::size_t segment) {
  const Joint joint = joint_of(example.curve, segment);
  const Theorem2 theorem = theorem2(example, segment);
  const double best = best_delta(joint);
  return {signs,
          formatted("q{}0", segment + 2),
          g1_residual(joint),
          g2_residual(joint, beta2),
          std::sqrt(joint.after2.norm()),
          finite_or_dash(best),
          finite_or_dash(g2_residual(joint, best)),
          theorem.as_printed,
          theorem.corrected,
          6.0 / theorem.gamma * theorem.corrected};
}

report::Table residuals_table(const std::string& title, const std::vector<NamedExample>& examples) {
  report::Table table{.title = title + ": the residual of the constraints at the joint; 0 would be G1 and G2",
                      .columns = {{"signs"},
                                  {"joint"},
                                  {"G1", Notation::scientific, 1},
                                  {"G2", Notation::shortest, 3},
                                  {"|s''|", Notation::shortest, 3},
                                  {"best delta", Notation::fixed, 4},
                                  {"G2 with it", Notation::shortest, 3},
                                  {"(10) printed", Notation::shortest, 3},
                                  {"(10) corrected", Notation::shortest, 3},
                                  {"times 6/gamma", Notation::shortest, 3}}};
  for (const auto& [signs, example] : examples)
    for (std::size_t segment = 0; segment + 1 < example.curve.knots().segments(); ++segment)
      table.rows.push_back(residuals(signs, example, segment));
  table.notes = {"G1: |s2'(0) - beta1 s1'(1)|. G2: |s2''(0) - beta1² s1''(1) - delta s1'(1)| with delta = beta2 = 0.5.",
                 "No delta makes it G2, and condition (10) fails as printed and as corrected (docs/errata.md).",
                 "The corrected (10) is the G2 constraint itself, up to the factor 6/gamma."};
  return table;
}

Expected<std::vector<Variant>> variants(const Points& points) {
  std::vector<Variant> result;
  for (const auto& [value, name] :
       {std::pair{0.5, color::blue}, std::pair{2.0, color::ink}, std::pair{4.0, color::red}}) {
    auto examples = with_both_signs(points, value);
    if (!examples) return tl::unexpected(std::move(examples.error()));
    result.push_back({value, name, std::move(*examples)});
  }
  return result;
}

report::Table effect_table(const std::vector<Variant>& all, const std::string& title) {
  report::Table table{.title = title + " with beta2 of point 1 at 0.5, 2 and 4",
                      .columns = {{"signs"},
                                  {"beta2"},
                                  {"first joint to point 1 [degrees]", Notation::fixed, 3},
                                  {"moved by at most [degrees]", Notation::fixed, 3},
                                  {"at u", Notation::fixed, 3},
                                  {"at the first joint", Notation::fixed, 3},
                                  {"at the last joint", Notation::fixed, 3}}};
  for (const std::size_t signs : {0U, 1U}) {
    const AnyCurve base(all[0].examples[signs].example.curve);
    for (const Variant& variant : all) {
      const auto& [name, example] = variant.examples[signs];
      const AnyCurve curve(example.curve);
      const Domain domain = curve.domain();
      const auto moved = [&](double t) { return degrees * angular_distance(curve(t), base(t)); };
      const double most = std::ranges::max(even_times(domain, 401), {}, moved);
      table.rows.push_back({name, variant.beta2_of_point1,
                            degrees * angular_distance(curve(domain.start), example.keys.orientations()[1]),
                            moved(most), most - domain.start, moved(domain.start), moved(domain.end)});
    }
  }
  table.notes = {"A larger beta2 draws the joint to its control point. The last joint depends on other points only.",
                 "u counts from the first joint, 1 at the next one."};
  return table;
}

Findings findings_of_example2(const std::vector<Variant>& all, const std::string& name, const std::string& title) {
  std::vector<pages::NamedCurve> motions;
  for (const Variant& variant : all)
    for (const auto& [signs, example] : variant.examples)
      motions.push_back(
          {formatted("β₁,₂ = {:g}, signs {}", variant.beta2_of_point1, signs), example.keys, {example.curve}});
  return {{residuals_table(name, all[0].examples), effect_table(all, title)}, {effect_picture(all)}, motions};
}

}  // namespace

Expected<Findings> experiment::beta_example1() {
  return with_both_signs(example1()).map([](const std::vector<NamedExample>& examples) {
    const BetaExample& given = examples[0].example;
    return Findings{{control_points_table(given), residuals_table("Example 1", examples)},
                    example1_pictures(given),
                    {{"signs as given", given.keys, {given.curve}}}};
  });
}

Expected<Findings> experiment::beta_example1_on(const KeysInstead& keys) {
  return with_both_signs(points_of(keys)).map([&](const std::vector<NamedExample>& examples) {
    const BetaExample& given = examples[0].example;
    return Findings{{own_control_points_table(given, keys.note), residuals_table("These keys", examples)},
                    example1_pictures(given),
                    {{"signs as given", given.keys, {given.curve}}}};
  });
}

Expected<Findings> experiment::beta_example2() {
  return variants(example2()).map([](const std::vector<Variant>& all) {
    return findings_of_example2(all, "Example 2", "Figure 4: example 2");
  });
}

Expected<Findings> experiment::beta_example2_on(const KeysInstead& keys) {
  return variants(points_of(keys)).map([&](const std::vector<Variant>& all) {
    Findings findings = findings_of_example2(all, "These keys", "Figure 4: these keys");
    findings.tables.back().notes.push_back(keys.note);
    return findings;
  });
}

}  // namespace orispline::cli
