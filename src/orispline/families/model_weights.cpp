// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/model_weights.hpp>

#include <algorithm>
#include <cstdint>
#include <span>

#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr std::size_t keys_per_block = 8, draws = 32;  // each draw, and the same with the blocks in reverse order
constexpr double hold = 1.08;                          // how much less a model must miss than the plain spline
constexpr double floor = 4e-24;  // added to a squared miss [rad²]: keys that are exact leave nothing to compare

/// An odd number of blocks.
std::size_t blocks_of(std::size_t inner_keys) { return 2 * (inner_keys / (2 * keys_per_block)) + 1; }

/// The first inner key of a block; the same seen from the other end.
std::size_t cut(std::size_t block, std::size_t blocks, std::size_t inner_keys) {
  return 2 * block < blocks ? block * inner_keys / blocks : inner_keys - (blocks - block) * inner_keys / blocks;
}

/// Number `counter` of a sequence of exponentially distributed ones, the same on every machine (splitmix64).
double exponential(std::uint64_t counter) {
  std::uint64_t z = counter * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  z ^= z >> 31;
  return -elementary::natural_logarithm((static_cast<double>(z >> 11) + 0.5) * 0x1p-53);
}

double power30(double x) {
  const double x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8;
  return x16 * x8 * x4 * x2;
}

/// Adds the shares that one draw gives: the 30th power of the least sum over each.
void add_shares(std::span<const double> sums, std::span<double> shares) {
  const double least = *std::ranges::min_element(sums);
  std::array<double, model_count> powers{};
  double all = 0.0;
  for (std::size_t m = 0; m < sums.size(); ++m) {
    powers[m] = sums[m] > 0.0 ? power30(least / sums[m]) : 1.0;
    all += powers[m];
  }
  for (std::size_t m = 0; m < sums.size(); ++m) shares[m] += powers[m] / all / (2.0 * draws);
}

/// Holds the plain spline against models that miss hardly less, and takes a model of noise behind a hump of the sums
/// for what it is: motion between the keys that they do not show, not noise.
void handicap(std::span<double> sums) {
  const double plain = sums[0] > 0.0 ? sums[0] : 1.0;
  double hump = sums[0] / plain;
  for (std::size_t m = 1; m < model_count; ++m) {
    const double sum = sums[m];
    sums[m] *= hold;
    if (m >= noise_models) continue;
    sums[m] *= hump * hump;
    hump = std::max(hump, sum / plain);
  }
}

}  // namespace

ModelWeighing::ModelWeighing(std::size_t keys) : keys_(keys), blocks_(blocks_of(keys - 2), Row::Zero()) {}

void ModelWeighing::add(std::size_t i, const KeyMisses& misses) {
  while (cut(block_ + 1, blocks_.size(), keys_ - 2) < i) ++block_;
  Row row;
  row.head<static_cast<int>(model_count)>() = misses.trust * (misses.models + floor);
  row.tail<4>() << misses.smooth * (misses.models[0] + floor), misses.smooth * (misses.seven + floor),
      misses.smooth9 * (misses.seven + floor), misses.smooth9 * (misses.nine + floor);
  blocks_[block_] += row;
}

/// The sums of every draw, and of its mirror image, which makes a track's weights those of the same track backwards.
std::vector<ModelWeighing::Row> ModelWeighing::drawn() const {
  std::vector<Row> sums(2 * draws, Row::Zero());
  std::uint64_t counter = 0;
  for (std::size_t d = 0; d < draws; ++d)
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const double weight = exponential(++counter);
      sums[d] += weight * blocks_[b];
      sums[draws + d] += weight * blocks_[blocks_.size() - 1 - b];
    }
  return sums;
}

ModelBelief ModelWeighing::belief() const {
  std::array<double, model_count> models{};
  std::array<double, 2> seven{}, nine{};
  const auto sums = drawn();
  for (Row row : sums) {
    const std::span<double> all(row.data(), rows);
    handicap(all.first(model_count));
    add_shares(all.first(model_count), models);
    add_shares(all.subspan(model_count, 2), seven);
    add_shares(all.subspan(model_count + 2, 2), nine);
  }
  const auto any = [&](std::size_t row) {
    return std::ranges::any_of(sums, [&](const Row& s) { return s[static_cast<Eigen::Index>(row)] > 0.0; });
  };
  ModelBelief belief;
  if (any(0)) belief.models = models;
  if (any(model_count)) belief.polynomial = seven[1];
  if (any(model_count + 2)) belief.polynomial9 = nine[1];
  return belief;
}

}}}  // namespace orispline::families
