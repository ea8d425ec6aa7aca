// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/table_layout.hpp>

#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

std::size_t width_of(std::span<const std::string_view> cells) noexcept {
  while (!cells.empty() && cells.back().empty()) cells = cells.first(cells.size() - 1);
  return cells.size();
}

std::optional<std::string_view> header_option(const ReadOptions& options) {
  if (!options.columns.empty()) return "columns";
  if (options.orientation.representation) return "representation";
  if (options.orientation.euler) return "euler";
  if (options.orientation.angle_unit) return "angle_unit";
  return std::nullopt;
}

tl::unexpected<Error> misplaced(const TextTable& table, std::string_view option, std::string message) {
  auto refused = bad_option(option, std::move(message));
  refused.value().where = table.here();
  return refused;
}

Expected<KeyColumns> located(const TextTable& table, Expected<KeyColumns> columns) {
  if (!columns) columns.error().where = table.here();
  return columns;
}

}}}  // namespace orispline::io
