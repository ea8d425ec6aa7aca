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
#include <orispline/jobs/curve_of_keys.hpp>

namespace orispline::cli {

/// How the user wants a method to be shaped, as typed.
struct MethodOptions {
  std::vector<std::string> settings;  ///< NAME=X[,X…] or NAME=WORD
  std::optional<std::string> tension, ends, start_rate, end_rate, period;
  std::vector<std::string> blending;  ///< files of methods of the user's own
  bool closed = false;
};

/// The first option that is given, such as `--tension`; empty if there is none.
[[nodiscard]] std::string_view first_given(const MethodOptions& options);
[[nodiscard]] inline bool any_given(const MethodOptions& options) { return !first_given(options).empty(); }

using OwnFamilies = std::vector<std::shared_ptr<const OwnFamily>>;

/// The families that files state.
[[nodiscard]] Expected<OwnFamilies> own_families(const std::vector<std::string>& files);

/// `NAME` or `NAME:SETTING=VALUE:…` behind that option, shaped by the other options as well. Every error names its
/// option.
[[nodiscard]] Expected<Method> method_request(std::string_view method, const MethodOptions& options,
                                              std::string_view option = "--method");

/// The method that was named, already shaped; else the one of jobs::chosen_method(), shaped by the options where they
/// say something. Errors: those of method_request(), and of a recipe that cannot be read.
[[nodiscard]] Expected<jobs::ChosenMethod> chosen_method(const std::optional<Method>& named,
                                                         const MethodOptions& options, const io::KeyInput& keys,
                                                         const jobs::UsualMethod& usual);

/// The texts of methods that were typed behind an option, each time one method or a list of them.
[[nodiscard]] Expected<std::vector<std::string>> method_texts(std::string_view option,
                                                              const std::vector<std::string>& typed,
                                                              const OwnFamilies& own);
/// Error: one that stands twice, which nobody could tell from itself.
[[nodiscard]] Expected<void> check_differ(std::string_view option, std::span<const std::string> methods);

/// Several methods that were typed behind `--method`, all shaped alike.
[[nodiscard]] Expected<std::vector<Method>> method_requests(const std::vector<std::string>& typed,
                                                            const MethodOptions& options);

/// The method of that name, or absent.
[[nodiscard]] Expected<std::optional<Method>> named_method(const std::optional<std::string>& text,
                                                           const MethodOptions& options);

/// With the rates and inner quaternions of the keys that the method takes, beside those that are read already.
[[nodiscard]] io::ReadOptions with_columns_of(const Method& method, io::ReadOptions read);

/// How a file is read for these methods: with the columns that one of them takes.
[[nodiscard]] io::ReadOptions read_for(std::span<const Method> methods, io::ReadOptions read);

/// Parameters of the method that the command line leaves to the columns of the key file.
[[nodiscard]] std::vector<std::string> open_parameters(const Method& method);
/// The columns in which smoothed keys carry their band too.
void read_band(io::ReadOptions& read);

/// Every `NAME=` or `NAME=WORD` that some method takes.
[[nodiscard]] std::vector<std::string> known_settings();
/// Every end rule that some method has.
[[nodiscard]] std::vector<std::string> known_end_rules();

}  // namespace orispline::cli
