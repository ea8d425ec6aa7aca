// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdio>

#include <orispline/base/file_name.hpp>
#include <orispline/io/file_system.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

std::string folder_of(const std::string& file) { return file.substr(0, file.size() - file_name_of(file).size()); }

}  // namespace

Place place_at(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (!file) return {PlaceKind::nothing};
  std::fclose(file);
  return {PlaceKind::file};
}

std::string behind_links(const std::string& path) { return path; }

std::error_code put_in_place(const std::string& part, const std::string& target) {
  errno = 0;
  if (std::rename(part.c_str(), target.c_str()) == 0) return {};
  return {errno, std::generic_category()};
}

bool stays_within(const std::string&, const std::string&) { return true; }

bool are_in_one_folder(const std::string& one, const std::string& other) { return folder_of(one) == folder_of(other); }

}}}  // namespace orispline::io
