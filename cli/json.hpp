// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <orispline/curve/family.hpp>

#include "compare_report.hpp"
#include "convert_report.hpp"
#include "inspect_report.hpp"
#include "reduce_report.hpp"
#include "reproduce_report.hpp"
#include "retime_report.hpp"
#include "sample_report.hpp"
#include "tune_report.hpp"

// The JSON documents that the commands print, described in docs/inspect-json.md.

namespace orispline::cli {

[[nodiscard]] std::string json_of(std::span<const FamilyInfo> families);
[[nodiscard]] std::string json_of(const InspectReport& report);
[[nodiscard]] std::string json_of(const SampleReport& report);
[[nodiscard]] std::string json_of(const ConvertReport& report);
[[nodiscard]] std::string json_of(const TuneReport& report);
[[nodiscard]] std::string json_of(const ReduceReport& report);
[[nodiscard]] std::string json_of(std::span<const ReduceReport> reports);
[[nodiscard]] std::string json_of(const RetimeReport& report);
[[nodiscard]] std::string json_of(const CompareReport& report);
[[nodiscard]] std::string json_of(std::span<const Experiment> experiments);
[[nodiscard]] std::string json_of(const std::vector<ExperimentReport>& reports);

}  // namespace orispline::cli
