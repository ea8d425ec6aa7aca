// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/tension_model.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/families/hermite_cumulative.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/families/tcb.hpp>
#include <orispline/families/uniform.hpp>
#include <orispline/math/bernstein.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Influences below this share of the largest possible one are rounding.
constexpr double no_influence = 1e-12;

BlendingRows combined(const BlendingRows& a, double factor, const BlendingRows& b) {
  BlendingRows rows = a;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t j = 0; j <= form_degree; ++j) rows[k].coefficients[j] += factor * b[k].coefficients[j];
  return rows;
}

bool follows_the_tension(EndRule rule) { return rule == EndRule::clamped || rule == EndRule::rest; }

/// The tensions that may vary, and the values of all others.
class Candidates {
 public:
  Candidates(const FamilyInfo& family, const FamilySettings& settings, CurveOptions options, std::size_t keys,
             const std::vector<std::string>& parameters)
      : family_(family), options_(std::move(options)), keys_(keys), parameters_(parameters) {
    for (const std::string& name : parameters_) options_.parameters[name] = settings.per_key(name).all(keys);
    first_ = follows_the_tension(settings.start.rule) ? 1 : 0;
    end_ = keys - (follows_the_tension(settings.end.rule) ? 1 : 0);
  }

  [[nodiscard]] const CurveOptions& options() const noexcept { return options_; }
  [[nodiscard]] std::size_t size() const noexcept { return keys_ * parameters_.size(); }
  [[nodiscard]] std::size_t index(std::size_t key, std::size_t parameter) const noexcept {
    return key * parameters_.size() + parameter;
  }
  [[nodiscard]] bool may_vary(std::size_t key) const noexcept { return first_ <= key && key < end_; }

  [[nodiscard]] Variable variable(std::size_t index) const {
    const std::string& name = parameters_[index % parameters_.size()];
    const std::size_t key = index / parameters_.size();
    const Parameter& p = *std::ranges::find(family_.parameters, name, &Parameter::name);
    return {name, key, options_.parameters.find(name)->second[key], p.lowest, p.highest};
  }

  /// All that vary at 0 …
  [[nodiscard]] CurveOptions at_zero() const { return with(parameters_.size(), 0); }
  /// … but those of that parameter at every second key at 1.
  [[nodiscard]] CurveOptions with(std::size_t parameter, std::size_t parity) const {
    CurveOptions probe = options_;
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      for (std::size_t key = first_; key < end_; ++key)
        probe.parameters[parameters_[p]][key] = p == parameter && key % 2 == parity ? 1.0 : 0.0;
    return probe;
  }

 private:
  const FamilyInfo& family_;
  CurveOptions options_;
  std::size_t keys_, first_, end_;
  std::vector<std::string> parameters_;
};

/// Of a family that has one.
int order_of(const FamilyInfo& family, const FamilySettings& settings) {
  return family.name == families::UniformFamily::info.name ? settings.whole("order").value_or(0) : 0;
}

/// The segments of one curve without any variable.
using Probe = std::vector<TensionSegment>;

Expected<Probe> cumulative_probe(const FamilyInfo& family, const Keyframes& keys, const CurveOptions& options,
                                 const OpenEndedWork& work) {
  return make_curve({family, options}, keys).and_then([&](const AnyCurve& curve) -> Expected<Probe> {
    Probe probe;
    for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
      if (work.stopped()) return cancellation();
      const SegmentForm segment_form = curve.form(i);
      const auto& form = std::get<CumulativeForm>(segment_form);
      const KnotSpan span = curve.knots().span(i);
      TensionSegment segment{.start = span.start(),
                             .step = span.step(),
                             .from = form.base,
                             .to = keys.orientations()[i + 1],
                             .increments = form.increments,
                             .constant = form.blending};
      for (BernsteinForm& row : segment.constant) row = elevated(row, form.degree);
      probe.push_back(std::move(segment));
    }
    return probe;
  });
}

/// Cubics with handles of these rates, each times the scale of its key.
Probe handle_probe(TensionSegment::Product product, const Keyframes& keys, const HandleRates& rates,
                   const std::vector<double>& scales) {
  const auto q = keys.orientations();
  const auto t = keys.times();
  Probe probe;
  for (std::size_t i = 0; i + 1 < q.size(); ++i) {
    const double third = (t[i + 1] - t[i]) / 3.0;
    TensionSegment segment = handle_segment(product, t[i], t[i + 1] - t[i], q[i], q[i + 1], third * rates.leaving[i],
                                            third * rates.arriving[i + 1]);
    for (double& c : segment.constant[0].coefficients) c *= scales[i];
    for (double& c : segment.constant[2].coefficients) c *= scales[i + 1];
    probe.push_back(std::move(segment));
  }
  return probe;
}

/// The handles are of tension 0; `options` scales them by 1 - tension.
Expected<Probe> slerp_probe(const FamilyInfo& family, const Keyframes& keys, CurveOptions options) {
  const std::vector<double> tension = std::exchange(options.parameters["tension"], {0.0});
  return settle(family, options, keys.size()).map([&](const FamilySettings& settings) {
    std::vector<double> scales;
    scales.reserve(tension.size());
    for (const double value : tension) scales.push_back(1.0 - value);
    return handle_probe(TensionSegment::Product::slerps, keys, families::Tcb::handle_rates(keys, settings), scales);
  });
}

/// `hermite-cumulative`: the tensions are the scales of the rates.
Probe hermite_probe(const Keyframes& keys, const CurveOptions& options) {
  const std::vector<Eigen::Vector3d> rates = families::HermiteCumulative::key_rates(keys);
  return handle_probe(TensionSegment::Product::bezier, keys, {.leaving = rates, .arriving = rates},
                      options.parameters.at("tension"));
}

Expected<Probe> probe_of(const FamilyInfo& family, const Keyframes& keys, const CurveOptions& options,
                         const OpenEndedWork& work) {
  if (family.name == families::Tcb::info.name) return slerp_probe(family, keys, options);
  if (family.name == families::HermiteCumulative::info.name) return hermite_probe(keys, options);
  return cumulative_probe(family, keys, options, work);
}

/// What unit changes of a candidate do to the second derivative of a segment, squared and summed over its Bernstein
/// coefficients: of the whole, and of its parts as if they could not cancel.
struct Influence {
  double whole = 0.0, parts = 0.0;
  [[nodiscard]] bool counts() const noexcept { return whole > no_influence * no_influence * parts; }
};

Influence influence_of(const TensionSegment& segment, const BlendingRows& slope) {
  Influence influence;
  for (std::size_t j = 0; j + 2 <= form_degree; ++j) {
    Eigen::Vector3d whole = Eigen::Vector3d::Zero();
    double parts = 0.0;
    for (std::size_t k = 0; k < slope.size(); ++k) {
      const auto& c = slope[k].coefficients;
      const double second = c[j] - 2.0 * c[j + 1] + c[j + 2];
      whole += second * segment.increments[k];
      parts += std::abs(second) * segment.increments[k].norm();
    }
    influence.whole += whole.squaredNorm();
    influence.parts += parts * parts;
  }
  return influence;
}

/// Adds the slopes that the probe of one parameter and parity shows.
void add_slopes(Probe& segments, const Probe& probe, const Candidates& candidates, std::size_t parameter,
                std::size_t parity) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::size_t key = i % 2 == parity ? i : i + 1;
    if (!candidates.may_vary(key)) continue;
    segments[i].variables.push_back(candidates.index(key, parameter));
    segments[i].slopes.push_back(combined(probe[i].constant, -1.0, segments[i].constant));
  }
}

/// Which candidates change anything at all.
std::vector<bool> influential(const Probe& segments, std::size_t candidates) {
  std::vector<Influence> sums(candidates);
  for (const TensionSegment& segment : segments)
    for (std::size_t v = 0; v < segment.variables.size(); ++v) {
      const Influence here = influence_of(segment, segment.slopes[v]);
      sums[segment.variables[v]].whole += here.whole;
      sums[segment.variables[v]].parts += here.parts;
    }
  std::vector<bool> counts;
  counts.reserve(sums.size());
  for (const Influence& sum : sums) counts.push_back(sum.counts());
  return counts;
}

/// The segment with the influential candidates as its variables, numbered anew; the others keep their values.
TensionSegment renumbered(TensionSegment segment, const Candidates& candidates, const std::vector<bool>& counts,
                          const std::vector<std::size_t>& numbers) {
  std::vector<std::size_t> order(segment.variables.size());
  for (std::size_t v = 0; v < order.size(); ++v) order[v] = v;
  std::ranges::sort(order, {}, [&](std::size_t v) { return segment.variables[v]; });
  TensionSegment result = segment;
  result.variables.clear();
  result.slopes.clear();
  for (const std::size_t v : order) {
    const std::size_t candidate = segment.variables[v];
    if (counts[candidate]) {
      result.variables.push_back(numbers[candidate]);
      result.slopes.push_back(segment.slopes[v]);
    } else {
      result.constant = combined(result.constant, candidates.variable(candidate).initial, segment.slopes[v]);
    }
  }
  return result;
}

Expected<TensionModel> model_of(Probe segments, const Candidates& candidates, const OpenEndedWork& work) {
  const std::vector<bool> counts = influential(segments, candidates.size());
  TensionModel model{.variables = {}, .segments = {}, .options = candidates.options()};
  std::vector<std::size_t> numbers(candidates.size());
  for (std::size_t c = 0; c < counts.size(); ++c)
    if (counts[c]) {
      numbers[c] = model.variables.size();
      model.variables.push_back(candidates.variable(c));
    }
  for (TensionSegment& segment : segments) {
    if (work.stopped()) return cancellation();
    model.segments.push_back(renumbered(std::move(segment), candidates, counts, numbers));
  }
  return model;
}

}  // namespace

BernsteinForm elevated(BernsteinForm form, std::size_t degree) {
  auto& c = form.coefficients;
  for (std::size_t n = degree + 1; n <= form_degree; ++n)
    for (std::size_t j = n; j > 0; --j) {
      const double share = static_cast<double>(j) / static_cast<double>(n);
      c[j] = share * c[j - 1] + (1.0 - share) * c[j];
    }
  return form;
}

TensionSegment handle_segment(TensionSegment::Product product, double start, double step,
                              const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                              const Eigen::Vector3d& leaving, const Eigen::Vector3d& arriving) {
  // In the tangent space the cubic's control points are 0, the first handle, the increment less the second one, and the
  // increment.
  return {.product = product,
          .start = start,
          .step = step,
          .from = from,
          .to = to,
          .increments = {leaving, increment<double>(from, to), arriving},
          .constant = {elevated(BernsteinForm{{0.0, 1.0}}, 3), elevated(BernsteinForm{{0.0, 0.0, 1.0, 1.0}}, 3),
                       elevated(BernsteinForm{{0.0, 0.0, -1.0}}, 3)}};
}

TensionSegment cumulative_segment(double start, double step, const Eigen::Quaterniond& from,
                                  const Increments& increments) {
  return {
      .product = TensionSegment::Product::cumulative,
      .start = start,
      .step = step,
      .from = from,
      .to = displaced_in_turn(from, increments),
      .increments = increments,
      .constant = {elevated(BernsteinForm{{0.0, 1.0, 1.0, 1.0}}, 3), elevated(BernsteinForm{{0.0, 0.0, 1.0, 1.0}}, 3),
                   elevated(BernsteinForm{{0.0, 0.0, 0.0, 1.0}}, 3)}};
}

BernsteinForm correction_form() { return elevated(BernsteinForm{{0.0, 0.0, 0.05}}, 5); }  // u² (1-u)³ / 2

CurveOptions TensionModel::with(const std::vector<double>& values) const {
  CurveOptions changed = options;
  for (std::size_t v = 0; v < variables.size(); ++v)
    changed.parameters[variables[v].parameter][variables[v].key] = values[v];
  return changed;
}

std::vector<std::string> tunable_parameters(const FamilyInfo& family) {
  std::vector<std::string> names;
  for (const Parameter& parameter : family.parameters)
    if (parameter.tunable) names.emplace_back(parameter.name);
  return names;
}

Expected<TensionModel> tension_model(const FamilyInfo& family, const Keyframes& keys, const CurveOptions& options,
                                     const std::vector<std::string>& parameters, const OpenEndedWork& work) {
  const auto settings = settle(family, options, keys.size());
  if (!settings) return tl::unexpected(settings.error());
  if (settings->start.rule == EndRule::handle || settings->end.rule == EndRule::handle)
    return failure(ErrorCode::bad_argument, "tcb: tensions are not tuned with the end rule handle, wanted natural");
  if (const auto order = order_of(family, *settings); order > 3)
    return failure(ErrorCode::bad_argument,
                   formatted("uniform: tensions of order {} are not tuned, wanted order 1, 2 or 3", order));
  const Candidates candidates(family, *settings, options, keys.size(), parameters);
  auto segments = probe_of(family, keys, candidates.at_zero(), work);
  if (!segments) return tl::unexpected(std::move(segments.error()));
  for (std::size_t p = 0; p < parameters.size(); ++p)
    for (const std::size_t parity : {0u, 1u}) {
      const auto probe = probe_of(family, keys, candidates.with(p, parity), work);
      if (!probe) return tl::unexpected(probe.error());
      add_slopes(*segments, *probe, candidates, p, parity);
    }
  return model_of(std::move(*segments), candidates, work);
}

}}  // namespace orispline
