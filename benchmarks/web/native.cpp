// SPDX-License-Identifier: Apache-2.0
// The native library as the package's peer: `native KEYS` obeys the lines of its input and answers each by one line.
//   make METHOD CALLS                processor time [s] of making so many curves
//   sample METHOD RATES COUNT CALLS  that of so many times COUNT samples, with rates up to the order RATES, and their
//   times,
//                                    each time into new memory
//   fill METHOD RATES COUNT CALLS    the same without times, into memory that was touched before
//   write METHOD RATES COUNT FILE    `written`: the numbers of `sample`, quantity after quantity
//   draw COUNT CALLS METHOD...       that of drawing a curve of each method, as the studio does: making it, COUNT even
//                                    samples and both sides of every key with all rates, the orders that keys reach
//   drawn COUNT FILE METHOD...       `written`: times, orientations, rates and orders of these curves, all as doubles
// KEYS: doubles, the times of the keys and then w, x, y, z of each.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <orispline.h>

namespace {

[[noreturn]] void stop(const std::string& why) {
  std::cerr << "native: " << why << '\n';
  std::exit(1);
}

void check(orispline_code code, const orispline_error* error) {
  if (code != ORISPLINE_OK) stop(orispline_error_text(error));
}

struct Keys {
  std::vector<double> times, orientations;
};

Keys read(const char* name) {
  std::ifstream file(name, std::ios::binary | std::ios::ate);
  if (!file) stop(std::string("found no file ") + name + ", wanted the keys");
  const std::size_t count = static_cast<std::size_t>(file.tellg()) / (5 * sizeof(double));
  Keys keys{std::vector<double>(count), std::vector<double>(4 * count)};
  file.seekg(0);
  for (auto* column : {&keys.times, &keys.orientations})
    file.read(reinterpret_cast<char*>(column->data()), static_cast<std::streamsize>(column->size() * sizeof(double)));
  return keys;
}

orispline_curve* made(const Keys& keys, const std::string& method) {
  orispline_error* error = nullptr;
  orispline_keys* checked = nullptr;
  orispline_curve* curve = nullptr;
  check(orispline_keys_make(keys.times.data(), keys.orientations.data(), keys.times.size(), ORISPLINE_WXYZ,
                            ORISPLINE_SHORTEST, nullptr, 0, &checked, &error),
        error);
  check(orispline_curve_make(checked, method.c_str(), &curve, &error), error);
  orispline_keys_free(checked);
  return curve;
}

/// Even samples from the first key on, the `count`-th after which is the last key.
class Samples {
 public:
  Samples(const Keys& keys, std::size_t rates, std::size_t count)
      : numbers(std::make_unique_for_overwrite<double[]>((5 + 3 * rates) * count)),
        size((5 + 3 * rates) * count),
        start_(keys.times.front()),
        step_((keys.times.back() - start_) / static_cast<double>(count)),
        count_(count),
        outputs_{{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, numbers.get() + count, 0}} {
    for (std::size_t k = 0; k < rates; ++k)
      outputs_.push_back({static_cast<orispline_quantity>(ORISPLINE_ANGULAR_VELOCITY + k), ORISPLINE_DOUBLE,
                          numbers.get() + (5 + 3 * k) * count, 0});
  }

  void fill(const orispline_curve* curve) {
    orispline_error* error = nullptr;
    check(orispline_sample_even(curve, start_, step_, count_, ORISPLINE_WXYZ, nullptr, 1, outputs_.data(),
                                outputs_.size(), &error),
          error);
  }

  /// As the package makes them.
  void fill_times() {
    for (std::size_t k = 0; k < count_; ++k) numbers[k] = static_cast<double>(k) * step_ + start_;
  }

  std::unique_ptr<double[]> numbers;  ///< times, orientations, angular velocities and angular accelerations
  std::size_t size;

 private:
  double start_, step_;  ///< [s]
  std::size_t count_;
  std::vector<orispline_output> outputs_;
};

Samples sampled(const Keys& keys, const orispline_curve* curve, std::size_t rates, std::size_t count) {
  Samples samples(keys, rates, count);
  samples.fill_times();
  samples.fill(curve);
  return samples;
}

/// Times of samples, of which those on the left of a key are asked for at the last double before it.
struct Times {
  std::vector<double> shown, asked;

  void add(double shown_time, double asked_time) {
    shown.push_back(shown_time);
    asked.push_back(asked_time);
  }
};

/// `count` even times, which begin at 0 s, and both sides of every key between the ends.
Times times_of(const Keys& keys, std::size_t count) {
  const double end = keys.times.back(), before = -std::numeric_limits<double>::infinity();
  Times times;
  auto key = std::next(keys.times.begin());
  for (std::size_t k = 0; k < count; ++k) {
    const double time = k + 1 == count ? end : end * static_cast<double>(k) / static_cast<double>(count - 1);
    bool is_key = false;
    for (; *key < end && *key <= time; ++key) {
      is_key = *key == time;
      times.add(*key, std::nextafter(*key, before));
      times.add(*key, *key);
    }
    if (!is_key) times.add(time, time);
  }
  return times;
}

/// A curve as the studio draws it.
class Drawn {
 public:
  Drawn(const Keys& keys, const std::string& method, std::size_t count)
      : times_(times_of(keys, count)),
        numbers_(std::make_unique_for_overwrite<double[]>(width * times_.asked.size())),
        orders_(keys.times.size()) {
    orispline_curve* curve = made(keys, method);
    const std::size_t rows = times_.asked.size();
    std::vector<orispline_output> outputs{{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, numbers_.get(), 0}};
    for (std::size_t k = 0; k < 3; ++k)
      outputs.push_back({static_cast<orispline_quantity>(ORISPLINE_ANGULAR_VELOCITY + k), ORISPLINE_DOUBLE,
                         numbers_.get() + (4 + 3 * k) * rows, 0});
    orispline_error* error = nullptr;
    check(orispline_sample_at(curve, times_.asked.data(), rows, ORISPLINE_WXYZ, nullptr, 1, outputs.data(),
                              outputs.size(), &error),
          error);
    check(orispline_curve_orders(curve, orders_.data(), orders_.size(), &error), error);
    orispline_curve_free(curve);
  }

  void write(std::ostream& file) const {
    const std::vector<double> orders(orders_.begin(), orders_.end());
    const auto put = [&file](const double* numbers, std::size_t count) {
      file.write(reinterpret_cast<const char*>(numbers), static_cast<std::streamsize>(count * sizeof(double)));
    };
    put(times_.shown.data(), times_.shown.size());
    put(numbers_.get(), width * times_.shown.size());
    put(orders.data(), orders.size());
  }

 private:
  static constexpr std::size_t width = 4 + 3 * 3;  // of orientation and rates
  Times times_;
  std::unique_ptr<double[]> numbers_;
  std::vector<std::int32_t> orders_;
};

template <class Work>
double taken(int calls, const Work& work) {
  const std::clock_t start = std::clock();
  for (int call = 0; call < calls; ++call) work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void obey_drawing(const Keys& keys, const std::string& order, std::istringstream& words) {
  std::size_t count = 0;
  std::string third;
  words >> count >> third;
  const std::vector<std::string> methods{std::istream_iterator<std::string>(words), {}};
  if (order == "draw") {
    std::cout << taken(std::stoi(third), [&] {
      for (const std::string& method : methods) Drawn(keys, method, count);
    }) << std::endl;
    return;
  }
  std::ofstream file(third, std::ios::binary);
  for (const std::string& method : methods) Drawn(keys, method, count).write(file);
  file.close();
  std::cout << "written" << std::endl;
}

void obey(const Keys& keys, const std::string& line) {
  std::istringstream words(line);
  std::string order, method, file;
  std::size_t rates = 0, count = 0;
  int calls = 0;
  words >> order;
  if (order == "draw" || order == "drawn") {
    obey_drawing(keys, order, words);
    return;
  }
  words >> method;
  if (order == "make") {
    words >> calls;
    std::cout << taken(calls, [&] { orispline_curve_free(made(keys, method)); }) << std::endl;
    return;
  }
  words >> rates >> count;
  orispline_curve* curve = made(keys, method);
  if (order == "sample") {
    words >> calls;
    std::cout << taken(calls, [&] { sampled(keys, curve, rates, count); }) << std::endl;
  } else if (order == "fill") {
    words >> calls;
    Samples samples = sampled(keys, curve, rates, count);
    std::cout << taken(calls, [&] { samples.fill(curve); }) << std::endl;
  } else if (order == "write") {
    words >> file;
    const Samples samples = sampled(keys, curve, rates, count);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(samples.numbers.get()),
               static_cast<std::streamsize>(samples.size * sizeof(double)));
    std::cout << "written" << std::endl;
  } else {
    stop("found the order '" + order + "', wanted make, sample, fill, write, draw or drawn");
  }
  orispline_curve_free(curve);
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) stop("found no name, wanted that of the file of keys");
  const Keys keys = read(words[1]);
  for (std::string line; std::getline(std::cin, line);) obey(keys, line);
}
