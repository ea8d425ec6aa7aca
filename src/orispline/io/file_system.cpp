// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_system.hpp>

#include <algorithm>
#include <filesystem>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace fs = std::filesystem;

Place place_at(const std::string& path) {
  std::error_code reason;
  const fs::file_status status = fs::status(path, reason);
  if (!fs::status_known(status)) return {PlaceKind::unknown, reason};
  if (!fs::exists(status)) return {PlaceKind::nothing};
  if (fs::is_directory(status)) return {PlaceKind::folder};
  if (!fs::is_regular_file(status)) return {PlaceKind::other};
  const std::uintmax_t size = fs::file_size(path, reason);
  return {PlaceKind::file, {}, reason ? 0 : static_cast<std::size_t>(size)};
}

std::string behind_links(const std::string& path) {
  constexpr int most_links = 40;  // as of Linux
  fs::path place = path;
  std::error_code unknown;
  for (int i = 0; i < most_links && !fs::exists(place, unknown) && fs::is_symlink(fs::symlink_status(place, unknown));
       ++i)
    place = place.parent_path() / fs::read_symlink(place, unknown);
  const fs::path target = fs::canonical(place, unknown);  // of links to pipes, which the system names, there is none
  return unknown ? place.string() : target.string();
}

std::error_code put_in_place(const std::string& part, const std::string& target) {
  std::error_code reason;
  const fs::file_status old = fs::status(target, reason);
  if (fs::exists(old)) fs::permissions(part, old.permissions(), reason);
  fs::rename(part, target, reason);
  return reason;
}

bool stays_within(const std::string& folder, const std::string& file) {
  std::error_code none;
  const fs::path outer = fs::canonical(folder.empty() ? fs::path(".") : fs::path(folder), none);
  const fs::path inner = none ? fs::path() : fs::canonical(file, none);
  return none || std::ranges::mismatch(outer, inner).in1 == outer.end();
}

bool are_in_one_folder(const std::string& one, const std::string& other) {
  std::error_code none;
  const fs::path here = fs::absolute(one, none).parent_path(), there = fs::absolute(other, none).parent_path();
  return here.lexically_normal() == there.lexically_normal();
}

}}}  // namespace orispline::io
