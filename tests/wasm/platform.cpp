// SPDX-License-Identifier: Apache-2.0
// What is other code in WebAssembly than elsewhere, or stands on such: tasks that are asked to stop, parts of work,
// files in memory and those that are not there.
#include <cstdio>
#include <string>
#include <vector>

#include <batch/specimen_curves.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/base/stop_token.hpp>
#include <orispline/files.hpp>
#include <orispline/orispline.hpp>
#include <orispline/reduce.hpp>

namespace orispline { namespace {

using io::Input;
using io::OutputFile;

bool all_is_right = true;

void expect(bool is_right, const char* what) {
  if (!is_right) std::printf("not so: %s\n", what);
  all_is_right = all_is_right && is_right;
}

void stop_tokens_share_their_source() {
  StopSource source;
  const StopSource copy = source;
  const StopToken none, token = source.get_token();
  expect(!none.stop_possible() && !none.stop_requested(), "a token of no source is never asked");
  expect(token.stop_possible() && !token.stop_requested(), "a token is not asked at first");
  expect(source.request_stop() && !source.request_stop(), "the first request is told from others");
  expect(token.stop_requested() && copy.stop_requested() && copy.get_token().stop_requested(), "all are asked at once");
}

void tasks_stop_when_they_are_asked() {
  const Track recording(
      testing_support::keyframes(testing_support::random_walk(5, 400, testing_support::Spacing::even)));
  StopSource source;
  std::vector<double> shares;
  const Progress progress{.stop = source.get_token(), .show = [&](double share) {
                            shares.push_back(share);
                            if (shares.size() == 2) source.request_stop();
                          }};
  const auto stopped = reduce(recording, Method("auto"), {.tolerance = {.angle = 1e-3}}, progress);
  expect(!stopped && stopped.error().code == ErrorCode::cancelled, "a task stops");
  expect(shares.size() == 2 && shares[0] < shares[1], "a task says how far it is");
}

void parts_are_done_one_by_one() {
  std::vector<std::size_t> done;
  parallel_for(3, 8, [&done](std::size_t i) { done.push_back(i); });
  expect(done == std::vector<std::size_t>{0, 1, 2}, "all parts are done, in their order");
}

void files_are_in_memory() {
  const std::string rows = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0,0,0.6\n";
  const auto track = io::read_track(Input::in_memory("keys.csv", rows));
  expect(track && track->track.keys.size() == 2, "keys are read");
  auto file = OutputFile::in_memory("keys.csv");
  expect(track && io::write_tracks(file, {&track->track, 1}, {}) && file.finish(), "keys are written");
  expect(std::move(file).bytes() == rows, "keys are written as they were read");
}

void files_that_are_not_there_are_refused() {
  const auto absent = io::read_track("absent.csv");
  expect(!absent && absent.error().code == ErrorCode::bad_access, "a file that cannot be opened is an error");
  const auto output = OutputFile::open("absent.csv");
  expect(!output && output.error().code == ErrorCode::bad_access, "a file that cannot be made is an error");
}

}}  // namespace orispline

int main() {
  using namespace orispline;
  stop_tokens_share_their_source();
  tasks_stop_when_they_are_asked();
  parts_are_done_one_by_one();
  files_are_in_memory();
  files_that_are_not_there_are_refused();
  return all_is_right ? 0 : 1;
}
