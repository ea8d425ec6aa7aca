// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <orispline/families/key_findings.hpp>
#include <orispline/families/motion_models.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Squared misses of one key, when it is predicted from its neighbours, and how much each comparison heeds them.
struct KeyMisses {
  PerModel models;
  double trust;            ///< of the key's window: 0 across gaps and large turns
  double seven, nine;      ///< of the polynomials through the nearest seven and nine keys
  double smooth, smooth9;  ///< trust, where the motion is smooth over seven and nine keys
};

/// Weighs the models by their misses at the inner keys of a track, which come in order.
///
/// The misses are summed over blocks of keys, the blocks with random weights 64 times; a model's weight is the mean
/// share that it has where the least sum counts most. Source: docs/families/measured.md, Formula (2).
class ModelWeighing {
 public:
  explicit ModelWeighing(std::size_t keys);

  /// Of key i, 0 < i < keys - 1.
  void add(std::size_t i, const KeyMisses& misses);

  [[nodiscard]] ModelBelief belief() const;

 private:
  static constexpr std::size_t rows = model_count + 4;  ///< and each pair that compares a polynomial with another guess
  using Row = Eigen::Array<double, static_cast<int>(rows), 1>;

  [[nodiscard]] std::vector<Row> drawn() const;

  std::size_t keys_;
  std::vector<Row> blocks_;
  std::size_t block_ = 0;  ///< of the key that came last
};

}}}  // namespace orispline::families
