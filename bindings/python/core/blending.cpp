// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>

#include <orispline/families/method_text.hpp>
#include <orispline/files.hpp>

#include "errors.hpp"
#include "keys.hpp"
#include "method_text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

MethodText MethodText::of(const Method& method) {
  return {text_of(method), std::dynamic_pointer_cast<const BlendingFamily>(method.own)};
}

Method MethodText::method() const {
  const std::shared_ptr<const OwnFamily> families[]{own};
  return value_of(method_from_text(words, std::span(families).first(own ? 1 : 0)));
}

std::shared_ptr<const BlendingFamily> family_carried_by(nb::handle words) noexcept {
  if (PyUnicode_CheckExact(words.ptr())) return nullptr;
  const nb::object core = nb::steal(PyObject_GetAttrString(words.ptr(), "_core"));
  PyErr_Clear();
  Blending held;
  return core.is_valid() && nb::try_cast(core, held) ? held.family : nullptr;
}

nb::object carrying(const MethodText& method) {
  return nb::module_::import_("orispline._blending").attr("carried")(text(method.words), Blending{method.own});
}

namespace {

/// What is not as it should be is the fault of `code`: of a file or of an argument.
Blending made(Expected<BlendingData> data, ErrorCode code, const std::string& file) {
  auto family = std::move(data).and_then(&BlendingFamily::make).map_error([&](Error error) {
    if (error.code != ErrorCode::bad_access) error.code = code;
    error.where.file = file;
    return error;
  });
  return {value_of(std::move(family))};
}

Blending of_text(const std::string& json) { return made(io::blending_from_json(json), ErrorCode::bad_argument, ""); }

Blending of_file(const std::string& path) {
  return made(
      [&] {
        const nb::gil_scoped_release release;
        return io::read_blending(path);
      }(),
      ErrorCode::bad_data, path);
}

/// Promise, order, why, where, sentence and what it wants of each.
nb::list findings_of_blending(const Blending& blending) {
  nb::list list;
  for (const BlendingFinding& found : blending.family->findings())
    list.append(nb::make_tuple(text(promise_name(found.promise)), found.order, text(found.why), text(found.where),
                               text(sentence_of(found)), text(found.provided)));
  return list;
}

}  // namespace

void add_blending(nb::module_& module) {
  nb::class_<Blending>(module, "Blending")
      .def(nb::new_(&of_text), "json"_a)
      .def_static("read", &of_file, "path"_a)
      .def_prop_ro("name", [](const Blending& blending) { return blending.family->data().name; })
      .def_prop_ro("title", [](const Blending& blending) { return blending.family->data().title; })
      .def_prop_ro("json", [](const Blending& blending) { return io::blending_json(blending.family->data()); })
      .def_prop_ro("info", [](const Blending& blending) { return info_of(blending.family->info()); })
      .def_prop_ro("findings", &findings_of_blending);
}

}  // namespace orispline::python
