// SPDX-License-Identifier: GPL-2.0-or-later
#include "options.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <type_traits>
#include <utility>

namespace tetrarch::program {
namespace {

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <class T>
struct ElementOf {
  using Type = T;
};
template <class T>
struct ElementOf<std::vector<T>> {
  using Type = T;
};
template <class T>
struct ElementOf<std::optional<T>> {
  using Type = T;
};

template <class T>
std::string type_name() {
  using Element = typename ElementOf<T>::Type;
  if constexpr (std::is_same_v<Element, bool>)
    return {};
  else if constexpr (std::is_floating_point_v<Element>)
    return "FLOAT";
  else if constexpr (std::is_unsigned_v<Element>)
    return "UINT";
  else if constexpr (std::is_integral_v<Element>)
    return "INT";
  else
    return "TEXT";
}

std::vector<std::string> split(std::string_view names) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= names.size();) {
    const std::size_t end = std::min(names.find(',', start), names.size());
    parts.emplace_back(names.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

} // namespace

Option& Option::required(bool yes) {
  is_required = yes;
  return *this;
}

Option& Option::with_default() {
  shows_default = true;
  return *this;
}

Option& Option::value_name(std::string name) {
  value = std::move(name);
  return *this;
}

Option& Option::output_file(std::function<void(const std::string&)> require) {
  is_output = true;
  require_name = std::move(require);
  return value_name("FILE");
}

Option& Option::one_of(std::initializer_list<const char*> allowed) {
  choices.assign(allowed.begin(), allowed.end());
  return *this;
}

Option& Option::in_range(double least, double most) {
  range = Range{least, most};
  return *this;
}

Option& Option::not_negative() {
  return in_range(0, std::numeric_limits<double>::max());
}

Option& Option::positive() {
  return in_range(std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
}

Option& Option::excludes(std::string other) {
  excluded = std::move(other);
  return *this;
}

Option& Option::takes(int count) {
  words = count;
  return *this;
}

Option& Option::may_stand_alone(std::string value_alone) {
  implied = std::move(value_alone);
  return *this;
}

bool Option::repeats() const {
  return std::visit([](auto* variable) { return IsVector<std::remove_pointer_t<decltype(variable)>>::value; },
                    target);
}

bool Option::has_name(std::string_view name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string Option::type() const {
  if (!value.empty()) return value;
  return std::visit([](auto* variable) { return type_name<std::remove_pointer_t<decltype(variable)>>(); },
                    target);
}

std::string Option::default_text() const {
  if (!shows_default) return {};
  std::ostringstream text;
  std::visit(
      [&text](auto* variable) {
        // A default of nothing, or of many values, is never shown.
        if constexpr (std::is_same_v<typename ElementOf<std::remove_pointer_t<decltype(variable)>>::Type,
                                     std::remove_pointer_t<decltype(variable)>>)
          text << *variable;
      },
      target);
  return text.str();
}

Option& OptionTable::add(std::string_view names, Target target, std::string help) {
  Option& option = options_.emplace_back();
  option.names = split(names);
  option.target = target;
  option.help = std::move(help);
  return option;
}

const Option* OptionTable::find(std::string_view name) const {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [name](const Option& option) { return option.has_name(name); });
  return found == options_.end() ? nullptr : &*found;
}

} // namespace tetrarch::program
