// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/pages/task_pages.hpp>

namespace orispline {

inline const pages::PageHead head{.command = "a command", .date = "a day", .notes = {"A note."}};

}  // namespace orispline
