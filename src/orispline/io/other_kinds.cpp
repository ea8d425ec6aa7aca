// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/other_kinds.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

struct OtherKind {
  std::string_view beginning, name, cure;
};

constexpr std::array other_kinds{
    OtherKind{"CCSDS_AEM_VERS", "an attitude ephemeris (AEM) of CCSDS, which is not read",
              "write the rows between DATA_START and DATA_STOP into a file of their own, below a header with blanks as "
              "they have, such as 't qx qy qz qw'"},
    OtherKind{"CCSDS_OEM_VERS", "an orbit ephemeris (OEM) of CCSDS, which holds no orientations and is not read",
              "the attitude is in another file"},
    OtherKind{
        "Trajectories", "an export of Vicon, whose rows stand below several headers and which is not read as it is",
        "keep the line that begins with Frame and the rows of numbers below it, without that of units, and read these "
        "with `fps` and `columns` t=Frame,rx_rad=RX,ry_rad=RY,rz_rad=RZ, or rx_deg if the angles are in degrees"},
    OtherKind{"Type Orientations",
              "a file of orientations (.ori) of MEGAlib, which holds directions of axes and is not read",
              "make a rotation of the directions of its x and z axes, and write rows below a header, t,qw,qx,qy,qz"},
    OtherKind{"HIERARCHY", "a BVH file, which is not read as rows",
              "it is read with `input_format` bvh, or without that option under a name that ends in .bvh"},
    OtherKind{"glTF", "a glTF file, which is not read as rows",
              "it is read with `input_format` gltf, or without that option under a name that ends in .glb"},
    OtherKind{"DAFETF", "a transfer file of SPICE, which is not read",
              "write the quaternions of the C-kernel as rows below a header, t,qw,qx,qy,qz"},
    OtherKind{"PK\x03\x04", "an archive, as .npz is, which is not read",
              "save one array of rows as .npy, or in Python give the arrays to Keys: a = numpy.load(FILE), "
              "Keys(a['t'], a['q'])"},
    OtherKind{"{", "a JSON file, which is not read as rows",
              "glTF is read with `input_format` gltf, or without that option under a name that ends in .gltf; of other "
              "JSON write the keys as rows below a header, t,qw,qx,qy,qz"},
    OtherKind{"[", "a JSON file, which is not read", "write the keys as rows below a header, t,qw,qx,qy,qz"}};

}  // namespace

std::optional<std::string> other_kind(std::string_view first_row) {
  const auto found =
      std::ranges::find_if(other_kinds, [&](const OtherKind& kind) { return first_row.starts_with(kind.beginning); });
  if (found == other_kinds.end()) return std::nullopt;
  return formatted("found {}; {}", found->name, found->cure);
}

}}}  // namespace orispline::io
