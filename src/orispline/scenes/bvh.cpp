// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <orispline/scenes/bvh_reader.hpp>
#include <orispline/scenes/bvh_writer.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace {

constexpr std::array<std::string_view, 1> bvh_extensions{".bvh"};

}  // namespace

constinit const SceneFormat bvh_format{.id = "bvh",
                                       .title = "BVH",
                                       .file = "a BVH file",
                                       .summary = "motion capture as a hierarchy and a table of angles",
                                       .extensions = bvh_extensions,
                                       .read = bvh::read,
                                       .write = bvh::write};

}}}  // namespace orispline::scenes
