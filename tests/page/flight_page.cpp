// SPDX-License-Identifier: Apache-2.0
// flight_page KEYS TRUTH HTML: a report of methods on the flight of the examples, for the tests of the page.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/distance.hpp>
#include <orispline/base/version.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/report/page_samples.hpp>

namespace orispline { namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

/// The largest norm, over all samples.
double peak(const std::vector<Eigen::Vector3d>& vectors) {
  double largest = 0.0;
  for (const Eigen::Vector3d& v : vectors) largest = std::max(largest, v.norm());
  return largest;
}

report::PageMethod method_on(const FamilyInfo& family, const Keyframes& keys, const report::PagePath& truth) {
  report::PageMethod method{.name = std::string(family.name)};
  const auto curve = make_pose_curve(family.name, keys);
  if (!curve) return method.failure = describe(curve.error()), method;
  const DistanceStatistics distance = distance_to_reference(curve->orientation, {truth.times, truth.orientations});
  method.continuity = "C" + std::to_string(continuity_at_keys(curve->orientation).order());
  method.samples = report::drawn_samples(*curve);
  report::PageErrors errors{.times = truth.times};
  for (std::size_t i = 0; i < truth.times.size(); ++i)
    errors.values.push_back(angular_distance(curve->orientation(truth.times[i]), truth.orientations[i]) / degree);
  errors = report::largest(errors, 2000);
  method.samples.error_times = errors.times;
  method.samples.errors = errors.values;
  method.measures = {{"rms_deg", distance.rms / degree},
                     {"mean_deg", distance.mean / degree},
                     {"max_deg", distance.largest / degree},
                     {"max_at_s", truth.times[distance.largest_at]},
                     {"peak_rate", peak(method.samples.angular_velocities)},
                     {"peak_acceleration", peak(method.samples.angular_accelerations)}};
  return method;
}

Expected<report::Page> flight_page(const char* keys_path, const char* truth_path) {
  auto file = io::read_keys(keys_path);
  auto truth_file = io::read_keys(truth_path);
  if (!file || !truth_file) return tl::unexpected(!file ? file.error() : truth_file.error());
  const auto keys = Keyframes::make(std::move(file->data));
  if (!keys) return tl::unexpected(keys.error());
  const report::PagePath truth{truth_file->data.times, truth_file->data.orientations};
  report::Page page{.title = "Which curve for this flight?",
                    .command = "flight_page flight_keys.csv flight_truth.csv",
                    .date = "2026-01-02 03:04",
                    .version = std::string(version),
                    .body = report::PageBody::aircraft,
                    .keys = report::page_keys(*keys),
                    .reference = report::thinned(truth)};
  page.columns = {{"rms_deg", "RMS", "deg", "Root mean square of the angle to the reference"},
                  {"mean_deg", "Mean", "deg", "Mean angle to the reference"},
                  {"max_deg", "Max", "deg", "Largest angle to the reference"},
                  {"max_at_s", "at", "s", "Time of the largest angle", report::Better::neither, true},
                  {"peak_rate", "Peak |ω|", "rad/s", "Largest angular velocity"},
                  {"peak_acceleration", "Peak |α|", "rad/s²", "Largest angular acceleration"}};
  page.sorted_by = "rms_deg";
  for (const FamilyInfo& family : families_info()) page.methods.push_back(method_on(family, *keys, truth));
  page.methods.push_back({.name = "impossible", .failure = "key 3: found </script><b>NaN</b>, wanted a number"});
  const auto first = std::ranges::find(page.methods, "auto", &report::PageMethod::name);
  std::rotate(page.methods.begin(), first, first + 1);
  const auto second = std::ranges::find(page.methods, "quintic", &report::PageMethod::name);
  std::rotate(page.methods.begin() + 1, second, second + 1);
  return page;
}

}}  // namespace orispline

int main(int argc, char** argv) {
  if (argc != 4) return std::fputs("usage: flight_page KEYS TRUTH HTML\n", stderr), 2;
  const auto written = orispline::flight_page(argv[1], argv[2]).and_then([&](const orispline::report::Page& page) {
    return orispline::io::OutputFile::open(argv[3]).and_then([&](orispline::io::OutputFile file) {
      return file.write(orispline::report::document(page)).and_then([&] { return file.finish(); });
    });
  });
  if (!written) return std::fprintf(stderr, "%s\n", orispline::describe(written.error()).c_str()), 1;
}
