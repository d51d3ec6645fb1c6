// SPDX-License-Identifier: GPL-2.0-or-later

/// The program's commands, from words and values to results.

#include "content.hpp"
#include "job.hpp"

#include "tools/tetrarch/describe.hpp"
#include "tools/tetrarch/finish.hpp"
#include "tools/tetrarch/parse.hpp"
#include "tools/tetrarch/version.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/new_files.hpp"
#include "tetrarch/workshop/element.hpp"

#include <pybind11/stl.h>

namespace tetrarch::python {
namespace {

constexpr const char* program_name = "tetrarch";

using Passing = std::map<std::string, std::shared_ptr<program::Value>, std::less<>>;

/// Parses, runs, and writes the files, unless it was stopped before.
program::Result ran(const std::vector<std::string>& words, const program::Values& values, Passing& passing,
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
  context.passing = &passing;
  result = parsed.job->run(context);
  program::finish(result, *context.reads);
  std::set<std::filesystem::path> paths;
  program::require_different(result.files, paths);
  if (progress.stop_requested()) throw Stopped();
  std::vector<format::NewFile> files;
  for (const program::Result::File& file : result.files) files.push_back({file.path, file.content});
  format::write_files_atomically(files);
  for (program::Result::File& file : result.files) file.content = {};
  return result;
}

/// What the caller keeps of a dictionary of values, and what can be taken out of it.
struct Named {
  program::Values values;
  Passing passing;
};

Named named(const py::dict& kept, const py::dict& passing) {
  Named list;
  for (const auto& [name, content] : kept)
    list.values[py::cast<std::string>(name)] = py::cast<const Content&>(content).value;
  for (const auto& [name, content] : passing) {
    const auto& made = py::cast<const Content&>(content);
    if (made.fresh)
      list.passing[py::cast<std::string>(name)] = made.fresh;
    else
      list.values[py::cast<std::string>(name)] = made.value;
  }
  return list;
}

/// (status, tree, text, warnings, value or None, paths of the files written). What is in `passing` was made
/// for this call: the dictionary is emptied, and who reads a mesh takes it.
py::tuple run(const std::vector<std::string>& words, const py::dict& kept, py::dict passing,
              const py::object& report) {
  const auto list = std::make_shared<Named>(named(kept, passing));
  passing.clear();
  const program::Result result = interruptible(report, [words, list](const Progress& progress) {
    return ran(words, list->values, list->passing, progress);
  });
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
    list.append(py::make_tuple(element.name,
                               element.error ? py::none() : py::cast(content_of(std::move(element.document))),
                               element.error ? element.error->what() : ""));
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
