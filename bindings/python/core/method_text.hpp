// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <nanobind/nanobind.h>

#include <orispline/curve/method.hpp>
#include <orispline/families/blending/blending_family.hpp>

#include "text.hpp"

// A method as Python has it is its text form; of a family of one's own it is a text that carries the family
// (orispline._blending.OwnMethod). All that takes or gives methods does so here.

namespace orispline::python {

/// A family of one's own as Python holds it: shared, for it never changes.
struct Blending {
  std::shared_ptr<const BlendingFamily> family;
};

struct MethodText {
  std::string words;
  std::shared_ptr<const BlendingFamily> own{};  ///< null for a method of the registry

  [[nodiscard]] static MethodText of(const Method& method);
  /// Raises the errors of method_from_text().
  [[nodiscard]] Method method() const;
};

/// What a family says about itself.
[[nodiscard]] nanobind::typed<nanobind::dict, nanobind::str, nanobind::any> info_of(const FamilyInfo& family);

/// The family that a text of Python carries, or null.
[[nodiscard]] std::shared_ptr<const BlendingFamily> family_carried_by(nanobind::handle words) noexcept;
/// The text that carries the family. Raises what Python raises.
[[nodiscard]] nanobind::object carrying(const MethodText& method);

}  // namespace orispline::python

namespace nanobind::detail {

template <>
struct type_caster<orispline::python::MethodText> {
  NB_TYPE_CASTER(orispline::python::MethodText, const_name("str"))

  bool from_python(handle source, std::uint32_t flags, cleanup_list* cleanup) noexcept {
    make_caster<std::string> words;
    if (!words.from_python(source, flags, cleanup)) return false;
    value = {std::move(words.value), orispline::python::family_carried_by(source)};
    return true;
  }

  static handle from_cpp(const orispline::python::MethodText& method, rv_policy, cleanup_list*) noexcept {
    try {
      return method.own ? orispline::python::carrying(method).release()
                        : orispline::python::text(method.words).release();
    } catch (python_error& error) {
      error.restore();
      return {};
    }
  }
};

}  // namespace nanobind::detail
