// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What Python's objects are made of: a triangulation, mesh or group that never changes, and arrays that look
/// into it.

#include "tetrarch/workshop/open.hpp"
#include "tetrarch/workshop/tree.hpp"

#include <cstddef>
#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

namespace tetrarch::python {

namespace py = pybind11;
using workshop::Tree;

using ContentPointer = std::shared_ptr<const workshop::Content>;

/// A triangulation, a mesh or a group.
struct Content {
  ContentPointer value;
  /// The same while nothing else looks at it, so that it may be taken away; else null.
  std::shared_ptr<workshop::Content> fresh = nullptr;
};

Content content_of(format::Document document);
Content content_of(Triangulation triangulation, std::string name = {});

/// Throws InputError unless it holds one.
const format::Document& document_in(const Content& content);
const format::MeshDocument& mesh_in(const Content& content);
/// The triangulation, which owns what it is part of.
std::shared_ptr<const Triangulation> triangulation_in(const Content& content);
/// Of the triangulation, in tetrahedra.
std::size_t size_of(const Content& content);

/// To be called before anything of pybind11's for arrays. Its table of NumPy's functions is made on first
/// use, behind a guard that a thread must not wait for while it holds the interpreter's lock: the thread that
/// makes it may have let go of the lock inside.
void need_numpy();

/// An array that looks at `data`, which `owner` keeps; nobody can write to it.
template <class T>
py::array view(const T* data, std::vector<py::ssize_t> shape, std::shared_ptr<const void> owner) {
  need_numpy();
  auto* const kept = new std::shared_ptr<const void>(std::move(owner));
  const py::capsule base(kept, [](void* p) { delete static_cast<std::shared_ptr<const void>*>(p); });
  py::array array(py::dtype::of<T>(), std::move(shape), data, base);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// An array that owns its numbers.
template <class T>
py::array_t<T> owned(std::vector<T> values, std::vector<py::ssize_t> shape) {
  need_numpy();
  auto* const kept = new std::vector<T>(std::move(values));
  const py::capsule base(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(std::move(shape), kept->data(), base);
}

inline py::ssize_t length(std::size_t n) {
  return static_cast<py::ssize_t>(n);
}

/// What a tree says as Python's own lists, dictionaries, numbers and texts.
py::object object_of(const Tree& tree);

void bind_content(py::module_& module);
void bind_topology(py::module_& module);
void bind_commands(py::module_& module);

} // namespace tetrarch::python
