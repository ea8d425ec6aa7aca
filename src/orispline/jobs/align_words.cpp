// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/align_words.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

std::string rotation_text(const Eigen::Quaterniond& q) {
  return formatted("qw {:.12f}  qx {:.12f}  qy {:.12f}  qz {:.12f}, a turn of {:.6g}°", q.w(), q.x(), q.y(), q.z(),
                   angular_distance(q, Eigen::Quaterniond::Identity()) * degrees);
}

std::string sigmas_text(const Eigen::Vector3d& sigmas, double unit, std::string_view name) {
  if (sigmas.isZero(0.0)) return "";
  return formatted(" ± {:.2g}{}, {:.2g}{}, {:.2g}{}", sigmas.x() * unit, name, sigmas.y() * unit, name,
                   sigmas.z() * unit, name);
}

std::string sigma_text(double sigma, std::string_view name) {
  return sigma == 0.0 ? "" : formatted(" ± {:.2g}{}", sigma, name);
}

Json vector_json(const Eigen::Vector3d& v) {
  Json list = Json::array();
  for (const double component : v) list.push_back(component);
  return list;
}

}}}  // namespace orispline::jobs
