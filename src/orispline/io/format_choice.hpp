// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/key_input.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// The format that a row is most like, at least that much; of equals the first. Null: none.
[[nodiscard]] const FormatInfo* likest(std::span<const FormatInfo* const> formats, const TextTable& table,
                                       const ReadOptions& options, Likeness least);

/// A table of keys that stands at its first row.
struct KeyRowsSource {
  const FormatInfo* format;
  TextTable table;
  TableLayout layout;
};

/// Keys of another kind: a text from its beginning.
struct TracksSource {
  const FormatInfo* format;
  LineReader lines;
};

/// Settles how an opened file is read: by the options, by its extension where only one format has it, else by what it
/// is like. Errors: those of read_keys() before the first key.
[[nodiscard]] Expected<std::variant<KeyRowsSource, TracksSource>> open_keys(KeyInput input, const ReadOptions& options);

}}}  // namespace orispline::io
