// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/track_file.hpp>

namespace orispline::cli {

/// How the user wants a method to be shaped, as typed.
struct MethodOptions {
  std::vector<std::string> settings;  ///< NAME=X[,X…] or NAME=WORD
  std::optional<std::string> tension, ends, start_rate, end_rate, period;
  bool closed = false;
};

/// The first option that is given, such as `--tension`; empty if there is none.
[[nodiscard]] std::string_view first_given(const MethodOptions& options);
[[nodiscard]] inline bool any_given(const MethodOptions& options) { return !first_given(options).empty(); }

/// `NAME` or `NAME:SETTING=VALUE:…`, shaped by the other options as well. Every error names its option.
[[nodiscard]] Expected<Method> method_request(std::string_view method, const MethodOptions& options);

/// The method whose curve the keys are for.
struct ChosenMethod {
  Method method{};
  std::vector<Warning> warnings{};  ///< that the file names another one
};

/// The method where neither the user nor the file names one that fits.
struct OtherMethod {
  std::string_view name;
  bool (*fits)(const FamilyInfo&) = nullptr;  ///< what the file may name; null: anything
};

/// The method that was named, already shaped; else the one that the file of the keys names, shaped by the options where
/// they say something; else `otherwise`, with a warning where the one of the file does not fit. Errors: those of
/// method_request(), and of a recipe that cannot be read.
[[nodiscard]] Expected<ChosenMethod> chosen_method(const std::optional<Method>& named, const MethodOptions& options,
                                                   const io::KeyInput& keys, const OtherMethod& otherwise);

/// Several methods, by names or lists of names with commas between them, all shaped alike.
[[nodiscard]] Expected<std::vector<Method>> method_requests(const std::vector<std::string>& lists,
                                                            const MethodOptions& options);

/// The family of a method that was understood.
[[nodiscard]] const FamilyInfo& family_of(const Method& method);

/// The method of that name, or absent.
[[nodiscard]] Expected<std::optional<Method>> named_method(const std::optional<std::string>& text,
                                                           const MethodOptions& options);

/// How a file is read for these methods: with the columns that one of them takes.
[[nodiscard]] io::ReadOptions read_for(std::span<const Method> methods, io::ReadOptions read);

/// Parameters of the method that the command line leaves to the columns of the key file.
[[nodiscard]] std::vector<std::string> open_parameters(const Method& method);

/// What the command line says and, where it is silent, the columns of the file.
[[nodiscard]] Method completed(const Method& method, const Track& track);

/// Every `NAME=` or `NAME=WORD` that some method takes.
[[nodiscard]] std::vector<std::string> known_settings();
/// Every end rule that some method has.
[[nodiscard]] std::vector<std::string> known_end_rules();

/// The curve through the keys, shaped by the command line and, where that is silent, by the columns of the file.
///
/// A value that the file is to blame for is bad_data and names its line.
[[nodiscard]] Expected<PoseCurve> shaped_curve(const Method& method, const Track& track);

/// The error with its place in the file, unless the command line alone is at fault.
[[nodiscard]] Error placed(const Track& track, Error error);

}  // namespace orispline::cli
