// SPDX-License-Identifier: Apache-2.0
#include "quantity.hpp"

#include <algorithm>

#include "errors.hpp"

namespace orispline::python {

namespace {

template <class T>
std::span<T>& target_of(Samples<T>& samples, What what) {
  switch (what) {
    case What::orientation:
      return samples.orientations;
    case What::angular_velocity:
      return samples.angular_velocities;
    case What::angular_acceleration:
      return samples.angular_accelerations;
    case What::angular_jerk:
      return samples.angular_jerks;
    case What::position:
      return samples.positions;
    case What::velocity:
      return samples.velocities;
    default:
      return samples.accelerations;
  }
}

}  // namespace

template <class T>
Quantity<T>::Quantity(const PythonCurve& curve, int asked, bool world, int beyond, unsigned threads)
    : curve_(curve),
      what_{asked},
      frame_(world && what_ >= What::angular_velocity && what_ <= What::angular_jerk ? RateFrame::world
                                                                                     : RateFrame::body),
      beyond_{beyond},
      work_{threads} {
  if (what_ >= What::position && !curve.pose().position)
    raise({ErrorCode::bad_argument, "these keys have no positions, wanted positions= of Keys or Curve", {}});
}

template <class T>
Expected<void> Quantity<T>::at(std::span<const double> times, T* memory) {
  if (beyond_ == Extrapolation::error)
    if (auto inside = check_inside(curve_.pose().orientation, times); !inside) return inside;
  const std::size_t most = samples_at_a_time(work_);
  for (std::size_t begin = 0; begin < times.size(); begin += most)
    if (auto done = part(times.subspan(begin, std::min(most, times.size() - begin)), memory + width() * begin); !done)
      return done;
  return {};
}

template <class T>
Expected<void> Quantity<T>::part(std::span<const double> times, T* memory) {
  const auto room = [count = times.size()](std::vector<T>& numbers, std::size_t columns) {
    numbers.resize(columns * count);
    return std::span<T>(numbers);
  };
  Samples<T> out;
  target_of(out, what_) = {memory, width() * times.size()};
  if (what_ != What::orientation) out.orientations = room(orientations_, 4);
  if (frame_ == RateFrame::world && what_ == What::angular_jerk) {
    out.angular_velocities = room(angular_velocities_, 3);
    out.angular_accelerations = room(angular_accelerations_, 3);
  }
  return curve_.sampler().sample_at<T>(times, out, beyond_, frame_, work_);
}

template class Quantity<double>;
template class Quantity<float>;

}  // namespace orispline::python
