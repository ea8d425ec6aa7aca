// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/input.hpp>

#include <algorithm>

#include <orispline/io/file_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

struct Input::Memory {
  std::string bytes;
  std::vector<Input> beside;
};

Input Input::in_memory(std::string name, std::string bytes, std::vector<Input> beside) {
  Input input(std::move(name));
  input.memory_ = std::make_shared<const Memory>(Memory{std::move(bytes), std::move(beside)});
  return input;
}

bool Input::is_standard_input() const noexcept { return !memory_ && name_ == standard_stream; }

std::string_view Input::bytes() const noexcept { return memory_ ? std::string_view(memory_->bytes) : ""; }

const Input* Input::beside(std::string_view name) const noexcept {
  if (!memory_) return nullptr;
  const auto found = std::ranges::find(memory_->beside, name, &Input::name);
  return found == memory_->beside.end() ? nullptr : &*found;
}

}}}  // namespace orispline::io
