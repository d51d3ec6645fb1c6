// SPDX-License-Identifier: GPL-2.0-or-later

/// The program's commands, from words and values to results.

#include "content.hpp"
#include "job.hpp"

#include "tools/tetrarch/describe.hpp"
#include "tools/tetrarch/finish.hpp"
#include "tools/tetrarch/parse.hpp"
#include "tools/tetrarch/version.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/workshop/element.hpp"

#include <pybind11/stl.h>

namespace tetrarch::python {
namespace {

constexpr const char* program_name = "tetrarch";

/// Parses, runs, and writes the files, unless it was stopped before.
program::Result ran(const std::vector<std::string>& words, const program::Values& values,
                    const Progress& progress) {
  const program::Parsed parsed =
      program::parse(words, program::commands(), program_name, program::usual_options());
  program::Result result;
  if (!parsed.job) {
    result.text = parsed.text;
    return result;
  }
  program::Context context;
  static_cast<program::Common&>(context) = parsed.job->common;
  context.progress = progress;
  context.values = &values;
  result = parsed.job->run(context);
  program::finish(result, *context.reads);
  std::set<std::filesystem::path> paths;
  program::require_different(result.files, paths);
  if (progress.stop_requested()) throw Stopped();
  for (const program::Result::File& file : result.files)
    format::write_file_atomically(file.path, file.content);
  for (program::Result::File& file : result.files) file.content = {};
  return result;
}

/// (status, tree, text, warnings, value or None, paths of the files written).
py::tuple run(const std::vector<std::string>& words, const std::map<std::string, Content>& values,
              const py::object& report) {
  program::Values named;
  for (const auto& [name, content] : values) named[name] = content.value;
  const program::Result result =
      interruptible(report, [words, named](const Progress& progress) { return ran(words, named, progress); });
  std::vector<std::string> paths;
  for (const program::Result::File& file : result.files) paths.push_back(file.path);
  return py::make_tuple(static_cast<int>(result.status),
                        result.json.is_null() ? py::none() : object_of(result.json), result.text,
                        result.warnings, result.value ? py::cast(Content{result.value}) : py::none(), paths);
}

/// Name, content or None, error of each triangulation in a file.
py::list collection(const std::string& path, const py::object& report) {
  format::Collection read =
      interruptible(report, [path](const Progress&) { return workshop::read_collection(path); });
  py::list list;
  for (format::Element& element : read.elements)
    list.append(py::make_tuple(
        element.name, element.error.empty() ? py::cast(content_of(std::move(element.document))) : py::none(),
        element.error));
  return list;
}

} // namespace

void bind_commands(py::module_& module) {
  module.def("run", run);
  module.def("collection", collection);
  module.def("describe", [] { return program::describe(program::commands(), program_name).dump(); });
  module.def("version", [] { return program::version_text(); });
}

} // namespace tetrarch::python
