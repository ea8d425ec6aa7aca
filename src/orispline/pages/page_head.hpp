// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// What a page says about its making, which only the caller knows.
struct PageHead {
  std::string title{};               ///< in the place of the one that the page gives itself; empty: that one
  std::string command{};             ///< the command line that makes the page again
  std::string date{};                ///< of the making, as it is to be read
  std::vector<std::string> notes{};  ///< sentences that stand before those of the page, such as warnings
};

}}}  // namespace orispline::pages
