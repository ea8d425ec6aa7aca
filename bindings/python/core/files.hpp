// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nanobind/nanobind.h>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/files.hpp>

namespace orispline::python {

/// An error of a file in the words of Python: `(drop_duplicates=True keeps the first)`.
[[nodiscard]] Error in_words(Error error);

/// Warnings, each once, as message, code and numbers.
[[nodiscard]] nanobind::list told(const std::vector<Warning>& warnings);

/// The file at a path; with bytes these, as those of a file of that name.
[[nodiscard]] io::Input input_of(const std::string& path, const std::optional<nanobind::bytes>& bytes);

/// A format by its word; null for an empty one.
[[nodiscard]] const io::FormatInfo* format_of(std::string_view word);

/// The frames that options of reading state. Raises what they may not be.
[[nodiscard]] FrameChange frames_of(const io::StatedOptions& stated);

void add_key_origins(nanobind::module_& module);
void add_key_writing(nanobind::module_& module);
void add_sample_writing(nanobind::module_& module);

}  // namespace orispline::python
