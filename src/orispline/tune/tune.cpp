// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/tune.hpp>

#include <algorithm>
#include <iterator>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/tune/objective_sums.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t fewest_keys = 3;
/// At rest, a Gauss–Newton step lowers the energy by no more than this share.
constexpr double wanted_stationarity = 1e-8;
constexpr std::size_t most_iterations = 200;
/// An energy of this share of what it was is rounding.
constexpr double rounding_energy = 1e-16;
/// Of an objective that is no sum of affine squares, and of one with bounds.
constexpr double expected_steps = 8.0;

/// The parameters to vary.
Expected<std::vector<std::string>> parameters_of(const FamilyInfo& family, const TuneOptions& options) {
  std::vector<std::string> tunable = tunable_parameters(family);
  if (tunable.empty())
    return bad_option("method",
                      formatted("{} has no tensions to tune, wanted one of {}", family.name, tunable_methods()));
  if (options.parameters.empty()) return tunable;
  for (const std::string& name : options.parameters)
    if (std::ranges::find(tunable, name) == tunable.end())
      return bad_option("free",
                        formatted("found '{}' for {}, wanted one of {}", name, family.name, joined(tunable, ", ")));
  return options.parameters;
}

/// Where the reference's orientations lie on the segments; those beyond the ends are left out.
Expected<Goal> with_reference(Goal goal, const Track& track, const Knots& knots, const TuneOptions& options) {
  goal.reference_samples.resize(knots.segments());
  for (std::size_t i = 0; i < options.reference.times.size(); ++i) {
    const double t = options.reference.times[i];
    if (!(knots.front() <= t && t <= knots.back())) continue;
    const std::size_t segment = knots.segment_at(t);
    goal.reference_samples[segment].push_back({knots.span(segment).normalised(t), options.reference.orientations[i]});
    ++goal.sample_count;
  }
  if (goal.sample_count > 0) return goal;
  const TimeOrigin epoch(track.epoch);
  return failure(ErrorCode::bad_data,
                 formatted("the reference has no time between the first and the last key, wanted some from {} to {} s",
                           epoch.plus(knots.front()).to_string(), epoch.plus(knots.back()).to_string()));
}

/// The knots are those of the curve, which does not begin at the first key where the family approximates.
Expected<Goal> goal_of(const Method& method, const Track& track, const TuneOptions& options) {
  Goal goal{.objective = options.objective, .inertia = options.inertia.value_or(Eigen::Matrix3d::Identity())};
  if (options.objective != Objective::fit) return goal;
  return make_curve(method, track.keys).and_then([&](const AnyCurve& curve) {
    return with_reference(std::move(goal), track, curve.knots(), options);
  });
}

Expected<void> check_keys(const FamilyInfo& family, const Keyframes& keys, const CurveOptions& curve) {
  if (keys.size() < fewest_keys)
    return failure(ErrorCode::bad_data, formatted("found {} key{}, wanted at least {} to tune tensions", keys.size(),
                                                  keys.size() == 1 ? "" : "s", fewest_keys));
  if (curve.loop)
    return failure(ErrorCode::bad_argument, formatted("{}: tensions of a loop are not tuned", family.name));
  return {};
}

std::vector<double> initial_values(const TensionModel& model) {
  std::vector<double> values;
  for (const Variable& variable : model.variables) values.push_back(variable.initial);
  return values;
}

std::vector<Interval> bounds_of(const TensionModel& model, const std::optional<Interval>& bounds) {
  std::vector<Interval> all;
  for (const Variable& variable : model.variables)
    all.push_back(bounds
                      ? Interval{std::max(bounds->lowest, variable.lowest), std::min(bounds->highest, variable.highest)}
                      : Interval{variable.lowest, variable.highest});
  return all;
}

bool inside(std::span<const double> values, std::span<const Interval> bounds) {
  for (std::size_t v = 0; v < values.size(); ++v)
    if (!(bounds[v].lowest <= values[v] && values[v] <= bounds[v].highest)) return false;
  return true;
}

/// The values of the least linearised energy, where that is known.
using ClosedForm = std::optional<std::vector<double>>;

/// Everywhere the same one within the bounds.
ClosedForm closed_form(const std::optional<double>& value, std::span<const Interval> bounds) {
  if (!value) return std::nullopt;
  std::vector<double> values;
  for (const Interval& b : bounds) values.push_back(std::clamp(*value, b.lowest, b.highest));
  return values;
}

/// An objective as a function of what is varied, where it is sought, and when it is rounding.
struct Search {
  SumOfSquares& sum;
  std::vector<Interval> bounds;
  double rounding;
  OpenEndedWork& work;
};

/// The least linearised energy within the bounds.
std::vector<double> closed_form(const TensionModel& model, std::span<const Interval> bounds, OpenEndedWork& work) {
  const Goal linearised{.objective = Objective::linearised};
  TensionSum sum(model, linearised, &work);
  std::vector<double> values = initial_values(model);
  const std::vector<double> step = newton_step(sum, values.size());
  for (std::size_t v = 0; v < values.size(); ++v) values[v] += step[v];
  if (inside(values, bounds)) return values;
  return minimised(sum, std::move(values), bounds, {most_iterations}, work).values;
}

/// The least energy near the closed form or, where that is worse than they are, near the initial values.
Minimum refined(const Search& search, const std::vector<double>& closed, const std::vector<double>& initial,
                double before) {
  search.sum.move_to(closed);
  const bool is_better = value_of(search.sum) < before || !inside(initial, search.bounds);
  return minimised(search.sum, is_better ? closed : initial, search.bounds, {most_iterations, search.rounding},
                   search.work);
}

Warning not_at_rest(std::string_view method, const Tuning& tuning) {
  return {
      .code = "not_at_rest",
      .message = formatted("{}: after {} another step would still lower the energy by {:.2g} of itself, wanted {:.2g} "
                           "at most; these tensions are better than those before, and others may be better still",
                           method, counted(tuning.iterations, "iteration"), tuning.stationarity, wanted_stationarity),
      .numbers = {{"stationarity", tuning.stationarity}, {"iterations", static_cast<double>(tuning.iterations)}}};
}

/// By which share of the energy, where more than rounding, a further step would lower it.
double stationarity_of(const Search& search, std::span<const double> values, const Tuning& tuning) {
  const double decrease = descent(search.sum, values, search.bounds).decrease;
  const double negligible = std::max(search.rounding, rounding_energy * tuning.energy_before);
  return decrease <= negligible ? 0.0 : decrease / std::max(tuning.energy_after, negligible);
}

/// From the closed form on, if there is one, where the energy before is more than rounding.
Expected<Tuning> tuned(const FamilyInfo& family, const TensionModel& model, const Search& search,
                       const ClosedForm& closed, Objective objective) {
  Minimum minimum{initial_values(model), 0};
  Tuning tuning{.energy_before = value_of(search.sum)};
  const bool is_least = tuning.energy_before <= search.rounding && inside(minimum.values, search.bounds);
  const bool is_closed = closed && objective == Objective::linearised;
  if (!is_least && is_closed) minimum.values = *closed;
  else if (!is_least) minimum = refined(search, closed.value_or(minimum.values), minimum.values, tuning.energy_before);
  if (search.work.stopped()) return cancellation();
  search.sum.move_to(minimum.values);
  tuning.energy_after = value_of(search.sum);
  if (!is_least && !is_closed) tuning.stationarity = stationarity_of(search, minimum.values, tuning);
  if (search.work.stopped()) return cancellation();
  tuning.iterations = minimum.iterations;
  tuning.method = {family, model.with(minimum.values)};
  if (tuning.stationarity <= wanted_stationarity) return tuning;
  if (tuning.energy_after < tuning.energy_before) {
    tuning.warnings.push_back(not_at_rest(family.name, tuning));
    return tuning;
  }
  return failure(ErrorCode::not_converged, formatted("{}: no better tensions were found, though another step should "
                                                     "lower the energy by {:.2g} of itself, wanted {:.2g} at most",
                                                     family.name, tuning.stationarity, wanted_stationarity));
}

/// What is tuned, with all that it needs.
struct Problem {
  const FamilyInfo& family;
  const Keyframes& keys;
  const CurveOptions& curve;
  const std::vector<std::string>& parameters;
  const Goal& goal;
  const TuneOptions& options;
  OpenEndedWork& work;
};

Expected<Tuning> tuned_affine(const Problem& p) {
  return tension_model(p.family, p.keys, p.curve, p.parameters, p.work).and_then([&](const TensionModel& model) {
    TensionSum sum(model, p.goal, &p.work);
    const Search search{sum, bounds_of(model, p.options.bounds), rounding_of(p.goal, p.keys), p.work};
    return tuned(p.family, model, search, closed_form(model, search.bounds, p.work), p.goal.objective);
  });
}

Expected<Tuning> tuned_construction(const Problem& p) {
  return construction_model(p.family, p.keys, p.curve, p.parameters).and_then([&](const ConstructionModel& made) {
    ConstructionSum sum(made, p.goal, &p.work);
    const Search search{sum, bounds_of(made.model, p.options.bounds), rounding_of(p.goal, p.keys), p.work};
    return tuned(p.family, made.model, search, closed_form(made.closed_form, search.bounds), p.goal.objective);
  });
}

}  // namespace

Expected<void> check(const TuneOptions& options) {
  if (options.objective == Objective::torque && !options.inertia)
    return bad_option("objective", "found torque, wanted `inertia` as well");
  if (options.objective == Objective::fit && options.reference.times.empty())
    return bad_option("objective", "found fit, wanted `reference` as well");
  if (options.objective != Objective::fit && !options.reference.times.empty())
    return bad_option("reference", "it is used by the objective fit alone, wanted `objective` fit as well");
  if (options.bounds && !(options.bounds->lowest < options.bounds->highest))
    return bad_option("bounds", formatted("found {} and {}, wanted the lower one first", options.bounds->lowest,
                                          options.bounds->highest));
  if (!options.inertia) return {};
  return checked_inertia(*options.inertia).map([](const auto&) {});
}

std::string tunable_methods() {
  std::vector<std::string_view> names;
  for (const FamilyInfo& family : families_info())
    if (!tunable_parameters(family).empty()) names.push_back(family.name);
  return joined(names, ", ");
}

Expected<Tuning> tune(const Track& track, const Method& given, const TuneOptions& options, const Progress& progress) {
  const auto info = family_of_method(given);
  if (!info) return tl::unexpected(info.error());
  if (auto checked = check(options); !checked) return tl::unexpected(std::move(checked.error()));
  const Method method = completed(given, **info, track);
  const Keyframes& keys = track.keys;
  const auto parameters = parameters_of(**info, options);
  if (!parameters) return tl::unexpected(parameters.error());
  if (auto checked = check_keys(**info, keys, method.options); !checked)
    return tl::unexpected(std::move(checked.error()));
  const auto goal = goal_of(method, track, options);
  if (!goal) return tl::unexpected(goal.error());
  OpenEndedWork work(progress, expected_steps);
  const Problem problem{**info, keys, method.options, *parameters, *goal, options, work};
  return (is_constructed((*info)->name) ? tuned_construction(problem) : tuned_affine(problem)).map([&](Tuning tuning) {
    tuning.parameters = *parameters;
    tuning.track = track;
    for (auto& [name, values] : settings_per_key(tuning.method, keys.size()))
      tuning.track.settings[name] = std::move(values);
    tuning.track.recipe = recipe_for(tuning.method, tuning.track);
    if (options.objective == Objective::torque)
      std::ranges::move(warnings_of(goal->inertia), std::back_inserter(tuning.warnings));
    std::ranges::move(warnings_of(tuning.method, track), std::back_inserter(tuning.warnings));
    work.finish();
    return tuning;
  });
}

}}  // namespace orispline
