// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_file.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/format_choice.hpp>
#include <orispline/io/key_rows.hpp>

namespace orispline::io {
namespace {

Expected<std::vector<KeyFile>> keys_in(KeyRowsSource source, const ReadOptions& options) {
  auto& [format, table, layout] = source;
  KeyRows rows(table.path(), *format, std::move(layout.columns), options);
  Expected<bool> more = layout.first_row == TableLayout::FirstRow::header ? table.next() : true;
  for (; more && *more; more = table.next())
    if (auto added = rows.add(table); !added) return tl::unexpected(std::move(added.error()));
  if (!more) return tl::unexpected(more.error());
  return std::move(rows).finish().map([&](KeyFile file) {
    if (options.keep_table) file.table.names = std::move(layout.names);
    std::vector<KeyFile> one;
    one.push_back(std::move(file));
    return one;
  });
}

Expected<std::vector<KeyFile>> keys_in(TracksSource source, const ReadOptions& options) {
  return source.format->reading.tracks(std::move(source.lines), options);
}

}  // namespace

Expected<std::vector<KeyFile>> read_all_keys(const std::string& path, const ReadOptions& options) {
  return open_keys(path, options).and_then([&](auto source) {
    return std::visit([&](auto&& open) { return keys_in(std::move(open), options); }, std::move(source));
  });
}

Expected<KeyFile> read_keys(const std::string& path, const ReadOptions& options) {
  return read_all_keys(path, options).and_then([&](std::vector<KeyFile> tracks) -> Expected<KeyFile> {
    if (tracks.size() == 1) return std::move(tracks.front());
    return failure(ErrorCode::bad_data, formatted("found {} tracks, wanted a file of one", tracks.size()),
                   {.file = path});
  });
}

Error located(const KeyFile& file, Error error) {
  error.where.file = file.path;
  if (error.where.key && *error.where.key < file.lines.size()) error.where.line = file.lines[*error.where.key];
  return error;
}

}  // namespace orispline::io
