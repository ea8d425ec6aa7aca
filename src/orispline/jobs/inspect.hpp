// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/key_statistics.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/stretches.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/families/key_findings.hpp>
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct Page;
}
namespace pages {
struct PageHead;
}

namespace jobs {

/// What was mended in a file of keys, for a look at it; a task would refuse the file.
struct KeyFaults {
  std::size_t duplicate_times = 0, out_of_order_rows = 0, invalid_rows = 0;
  std::size_t wrong_norms = 0;  ///< keys too far from a unit quaternion to be taken for one
  double largest_norm_error = 0.0;
  std::optional<std::string> defect{};  ///< what a task says about the file as it is
};

struct InspectRequest {
  std::shared_ptr<const Track> keys;
  std::vector<Method> methods{};
  KeyFaults faults{};
};

/// The continuity that one method really has on the keys.
struct InspectedMethod {
  std::string label;      ///< its name, or its text form beside another of that name
  Continuity continuity;  ///< in time
  ShapeContinuity shape;
  std::optional<KeyFindings> findings{};  ///< by the method `measured`
};

/// What keys are like, and the methods on them. Places are indices of keys.
struct InspectOutcome {
  InspectRequest request;
  KeyStatistics statistics{};
  std::vector<Stretch> stretches{};  ///< of the keys: one, where there are neither gaps nor jumps
  KeyframeReport keyframes{};        ///< the keys of a wrong norm among the non-unit ones
  std::vector<InspectedMethod> methods{};
  std::vector<PoseCurve> curves{};  ///< of the methods
  std::vector<Warning> warnings{};  ///< of the methods
};

/// Errors: those of shaped_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<InspectOutcome> inspect(InspectRequest request);

/// Described in docs/inspect-json.md, but for the file and its format.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const InspectOutcome& outcome);
/// A page for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const InspectOutcome& outcome);
/// With ORISPLINE_PAGE: the curves of the methods through the keys; where none was asked for, that of the method that
/// the keys are for, else of the default one. What is wrong with the keys stands above all else that it says.
[[nodiscard]] ORISPLINE_EXPORT report::Page page_of(const InspectOutcome& outcome, pages::PageHead head);

}  // namespace jobs

}}  // namespace orispline
