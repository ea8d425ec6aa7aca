// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/meshopt.hpp>

#include <meshoptimizer.h>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

const unsigned char* octets(std::string_view bytes) { return reinterpret_cast<const unsigned char*>(bytes.data()); }

void undo(MeshoptFilter filter, std::string& bytes, const MeshoptElements& elements) {
  switch (filter) {
    case MeshoptFilter::none:
      break;
    case MeshoptFilter::octahedral:
      meshopt_decodeFilterOct(bytes.data(), elements.count, elements.stride);
      break;
    case MeshoptFilter::quaternion:
      meshopt_decodeFilterQuat(bytes.data(), elements.count, elements.stride);
      break;
    case MeshoptFilter::exponential:
      meshopt_decodeFilterExp(bytes.data(), elements.count, elements.stride);
      break;
  }
}

}  // namespace

std::optional<std::string> from_meshopt(std::string_view compressed, const MeshoptElements& elements) {
  std::string bytes(elements.count * elements.stride, '\0');
  if (meshopt_decodeVertexBuffer(bytes.data(), elements.count, elements.stride, octets(compressed),
                                 compressed.size()) != 0)
    return std::nullopt;
  undo(elements.filter, bytes, elements);
  return bytes;
}

std::string to_meshopt(std::string_view bytes, std::size_t stride) {
  const std::size_t count = bytes.size() / stride;
  meshopt_encodeVertexVersion(0);  // which all versions of the library read, and EXT_meshopt_compression asks for
  std::string compressed(meshopt_encodeVertexBufferBound(count, stride), '\0');
  compressed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(compressed.data()), compressed.size(),
                                               bytes.data(), count, stride));
  return compressed;
}

}}}  // namespace orispline::scenes::gltf
