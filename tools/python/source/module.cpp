// SPDX-License-Identifier: GPL-2.0-or-later

/// The module tetrarch._tetrarch: what the package's Python code is written with. People use the package.

#include "content.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/numeric/sparse_cholesky.hpp"

#include <exception>
#include <optional>
#include <system_error>
#include <utility>

namespace tetrarch::python {
namespace {

/// The package's classes of errors; never released.
py::handle input_error;
py::handle precondition_error;

void set_error_types(const py::object& input, const py::object& precondition) {
  input_error = py::object(input).release();
  precondition_error = py::object(precondition).release();
}

void raise(const py::handle& type, const std::string& message, std::optional<Cause> cause = {},
           const std::string& file = {}, int line = 0) {
  constexpr std::size_t most = 1000; // a file's name may be longer than anybody reads
  const std::string line_of_text =
      printable(message.size() <= most ? message : message.substr(0, most) + " ...");
  const py::object error =
      type(line_of_text, file.empty() ? py::object(py::none()) : py::object(py::str(printable(file))),
           line > 0 ? py::object(py::int_(line)) : py::object(py::none()));
  if (cause) error.attr("code") = py::str(std::string(code_of(*cause)));
  PyErr_SetObject(type.ptr(), error.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const InputError& e) {
    raise(input_error, e.what(), e.cause, e.place.source, e.place.line);
  } catch (const PreconditionError& e) {
    raise(precondition_error, e.what());
  } catch (const numeric::MatrixTooLarge& e) {
    raise(input_error, e.what(), Cause::memory);
  } catch (const std::system_error& e) { // the file system is not what the call took it for
    raise(input_error, e.what(), Cause::file);
  } catch (const Stopped& e) {
    PyErr_SetString(PyExc_KeyboardInterrupt, e.what());
  }
}

} // namespace

PYBIND11_MODULE(_tetrarch, module) {
  py::register_exception_translator(translate);
  module.def("set_error_types", set_error_types);
  bind_content(module);
  bind_topology(module);
  bind_commands(module);
}

} // namespace tetrarch::python
