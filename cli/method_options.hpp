// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/curve/pose_curve.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline::cli {

inline constexpr std::string_view default_method = "auto";

/// How the user wants a method to be shaped, as typed.
struct MethodOptions {
  std::vector<std::string> settings;  ///< NAME=X[,X…] or NAME=WORD
  std::optional<std::string> tension, ends, start_rate, end_rate, period;
  bool closed = false;
};

[[nodiscard]] inline bool any_given(const MethodOptions& o) {
  return !o.settings.empty() || o.tension || o.ends || o.start_rate || o.end_rate || o.period || o.closed;
}

/// A method with what the command line says to it.
struct MethodRequest {
  const FamilyInfo* family = nullptr;
  CurveOptions options;
};

[[nodiscard]] Expected<MethodRequest> method_request(const std::string& method, const MethodOptions& options);

/// Several methods, by names or lists of names with commas between them, all shaped alike.
[[nodiscard]] Expected<std::vector<MethodRequest>> method_requests(const std::vector<std::string>& lists,
                                                                   const MethodOptions& options);

/// How a file is read for these methods: with the columns that one of them takes.
[[nodiscard]] io::ReadOptions read_for(std::span<const MethodRequest> methods, io::ReadOptions read);

/// Parameters of the method that the command line leaves to the columns of the key file.
[[nodiscard]] std::vector<std::string> open_parameters(const MethodRequest& request);

/// What the command line says and, where it is silent, the columns of the file.
[[nodiscard]] CurveOptions completed(const MethodRequest& request, const io::KeyFile& file);

/// A line about a loop whose closing step is so much shorter than every other one that its rates are huge; else
/// nothing.
[[nodiscard]] std::optional<std::string> closing_step_warning(const MethodRequest& request, const Keyframes& keys);

/// A line about a handle that turns a full turn or more away from its key, where a curve of slerps loses its
/// continuity; else nothing.
[[nodiscard]] std::optional<std::string> overwound_tangent_warning(const MethodRequest& request, const Keyframes& keys,
                                                              const io::KeyFile& file);

/// Every `NAME=` or `NAME=WORD` that some method takes.
[[nodiscard]] std::vector<std::string> known_settings();
/// Every end rule that some method has.
[[nodiscard]] std::vector<std::string> known_end_rules();

/// The curve through the keys, shaped by the command line and, where that is silent, by the columns of the file.
///
/// A value that the file is to blame for is bad_data and names its line.
[[nodiscard]] Expected<PoseCurve> shaped_curve(const MethodRequest& request, const Keyframes& keys,
                                               const io::KeyFile& file);

}  // namespace orispline::cli
