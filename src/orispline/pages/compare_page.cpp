// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/task_pages.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/analysis/sampled.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/pages/curve_page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

constexpr std::size_t samples_of_all = 16'000;  ///< of all curves together, for smooth lines of rates
constexpr std::size_t fewest_samples = 300, most_samples = 2000, samples_of_few_keys = 600, few_keys = 150;
constexpr std::size_t samples_of_reference = 600;
constexpr std::size_t errors_of_all = 30'000;  ///< of all curves together

/// The smooth curves of most programs: what a first look compares the default with.
constexpr std::array<std::string_view, 3> widely_used{"rotation-spline", "squad", "tcb"};

/// The id of a measure on another set of keys than the first.
std::string id_on(std::string_view id, std::size_t key_set) {
  return key_set == 0 ? std::string(id) : formatted("{}_{}", id, key_set);
}

/// On further sets of keys only what a method is chosen by.
bool is_in_page(const MeasureInfo& measure, std::size_t key_set) {
  return key_set == 0 || measure.id == "rms_deg" || measure.id == "max_deg";
}

std::vector<report::PageColumn> columns_of(const ComparedCurves& compared) {
  std::vector<report::PageColumn> columns;
  for (std::size_t i = 0; i < compared.key_sets.size(); ++i) {
    std::vector<MeasureInfo> measures = compared.measures;
    std::erase_if(measures, [&](const MeasureInfo& measure) { return !is_in_page(measure, i); });
    const std::string keys = i == 0 ? "" : ", " + compared.key_sets[i];
    for (const report::PageColumn& column : measure_columns(std::move(measures)))
      columns.push_back({.id = id_on(column.id, i),
                         .label = column.label + keys,
                         .unit = column.unit,
                         .explanation = column.explanation + keys,
                         .better = column.better,
                         .is_time = column.is_time,
                         .rounding = column.rounding});
  }
  return columns;
}

/// Of a method that has a band, where it is to hold 90 % of the truth.
Bands bands_of(const Candidate& candidate, const report::PagePath& path) {
  const auto band = BandInStretches::make(candidate.method, candidate.keys, candidate.stretches, 0.9);
  if (!band) return {};
  return bands_about(path, "90 % of the truth, as the keys tell", *band);
}

report::Fineness fineness_of(std::size_t keys, std::size_t methods) {
  const std::size_t fewest = keys > few_keys ? fewest_samples : samples_of_few_keys;
  return {.least = std::clamp(samples_of_all / methods, fewest, most_samples)};
}

std::size_t errors_of_each(std::size_t methods) {
  return std::clamp(errors_of_all / methods, fewest_samples, samples_of_few);
}

/// Where the errors of all methods are drawn.
struct PlacesOfErrors {
  report::PagePath recording{};       ///< what of it lies between the first and the last key
  std::vector<std::size_t> places{};  ///< of it: even ones, that of each method's largest error, and both sides of gaps
};

PlacesOfErrors places_of_errors(const ComparedCurves& compared, std::span<const ComparedMethod> in_page) {
  const RecordedMotion& all = compared.recording;
  const Keyframes& keys = in_page.front().candidate.keys;
  if (keys.size() == 0) return {};
  const auto [first, count] = times_within(all.times, {keys.times().front(), keys.times().back()});
  PlacesOfErrors drawn{path_of(all.times.subspan(first, count), all.orientations.subspan(first, count)),
                       evenly_picked(count, errors_of_each(in_page.size()))};
  for (const ComparedMethod& method : in_page)
    if (method.measures && method.measures->distance.count > 0)
      drawn.places.push_back(method.measures->distance.largest_at - first);
  for (std::size_t i = 1; i < count && compared.gap; ++i)
    if (drawn.recording.times[i] - drawn.recording.times[i - 1] > *compared.gap)
      drawn.places.insert(drawn.places.end(), {i - 1, i});
  std::ranges::sort(drawn.places);
  drawn.places.erase(std::unique(drawn.places.begin(), drawn.places.end()), drawn.places.end());
  return drawn;
}

/// What all curves of the page have alike.
struct ComparedCurve {
  const ComparedCurves& compared;
  PlacesOfErrors errors;
  report::Covers covers;
  report::Fineness fineness;
};

report::PageMethod method_of(const ComparedMethod& method, const ComparedCurve& of_all) {
  report::PageMethod result{.name = method.label};
  if (!method.measures) {
    result.failure = describe(method.measures.error());
    return result;
  }
  result.continuity = continuity_of(*method.measures);
  const auto curve = curve_of(method.candidate);
  if (!curve) return result;  // it was made before
  result.samples = samples_of(*curve, of_all.compared.inertia, of_all.fineness);
  auto errors = report::with_gaps(
      report::largest_near(errors_at(*curve, of_all.errors.recording), of_all.errors.places), of_all.covers);
  result.samples.error_times = std::move(errors.times);
  result.samples.errors = std::move(errors.values);
  result.bands = bands_of(method.candidate, result.samples.path);
  return result;
}

void add_measures(report::PageMethod& method, const ComparedCurves& compared) {
  const MeasureTimes times = on_page(compared.recording.times);
  for (const ComparedMethod& other : compared.methods) {
    if (other.label != method.name || !other.measures) continue;
    for (const MeasureInfo& measure : compared.measures)
      if (const auto value = measure.value(*other.measures, times);
          value && is_in_page(measure, other.key_set) && measure.is_finite(*other.measures))
        method.measures.emplace(id_on(measure.id, other.key_set), *value);
  }
}

std::string id_of_word(const std::vector<MeasureInfo>& measures, std::string_view word) {
  const auto found = std::ranges::find(measures, word, &MeasureInfo::word);
  return word.empty() || found == measures.end() || found->id == "continuity" ? "" : std::string(found->id);
}

/// Names of the methods that the page shows at first, the second one beside the first; empty where there is none.
struct Pair {
  std::string first{}, second{};
};

/// One curve says little: a reader is to see what the choice of a method changes.
Pair pair_that_teaches(const ComparedCurves& compared, std::size_t in_page) {
  std::vector<const ComparedMethod*> working;
  for (const ComparedMethod& method : compared.methods.first(in_page))
    if (method.measures) working.push_back(&method);
  if (working.empty()) return {};
  const auto named = [&](std::string_view label) { return std::ranges::find(working, label, &ComparedMethod::label); };
  const auto usual = named(default_method);
  Pair pair{.first = usual != working.end() ? (*usual)->label : working.front()->label};
  for (const std::string& label : compared.named)
    if (pair.second.empty() && label != pair.first && named(label) != working.end()) pair.second = label;
  if (!pair.second.empty()) return pair;
  for (const ComparedMethod* method : working)
    if (method->label != pair.first && std::ranges::find(widely_used, method->label) != widely_used.end())
      pair.second = method->label;
  return pair;
}

}  // namespace

report::Page compare_page(const ComparedCurves& compared, const PageHead& head, unsigned threads) {
  const Keyframes& keys = compared.methods.front().candidate.keys;
  const report::PagePath truth = path_of(compared.recording.times, compared.recording.orientations);
  const auto in_page = static_cast<std::size_t>(
      std::ranges::count(compared.methods, std::size_t{0}, &ComparedMethod::key_set));  // they stand first
  report::Page page = begun_page(formatted("{} on {}", counted(in_page, "method"), counted(keys.size(), "key")), head,
                                 compared.epoch, keys);
  const ComparedCurve of_all{compared, places_of_errors(compared, compared.methods.first(in_page)),
                             covers_of(compared.recording.times, compared.gap), fineness_of(keys.size(), in_page)};
  page.reference = report::with_gaps(report::thinned(truth, samples_of_reference), of_all.covers);
  std::ranges::move(notes_on_samples(of_all.errors.recording.times.size(), errors_of_each(in_page)),
                    std::back_inserter(page.notes));
  page.columns = columns_of(compared);
  page.sorted_by = id_of_word(compared.measures, compared.sorted_by);
  auto [first, second] = pair_that_teaches(compared, in_page);
  page.first = std::move(first);
  page.second = std::move(second);
  page.methods.resize(in_page);
  parallel_for(in_page, threads, [&](std::size_t i) {
    page.methods[i] = method_of(compared.methods[i], of_all);
    add_measures(page.methods[i], compared);
  });
  return page;
}

}}}  // namespace orispline::pages
