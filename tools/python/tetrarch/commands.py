# SPDX-License-Identifier: GPL-2.0-or-later
"""Every command of the program as a function: options are keyword arguments of the same names, defaults and help.

The functions are made from the program's own table of commands. `commands.pyi` spells them out for type checkers, and a test compares
the two.
"""
from __future__ import annotations

import difflib
import functools
import inspect
import json
import keyword
import operator
import re
import shlex
from typing import Any, Callable, Dict, List, Optional, Tuple

from . import _tetrarch
from .errors import InputError, PreconditionError, shown
from .groups import FundamentalGroup
from .inputs import _is_array, content_of, held, is_text, text_of
from .progress import Progress, reporting
from .results import Result, attribute_name

#: Statuses of the program that are values here.
_VERDICTS = {0: "yes", 1: "no", 4: "undecided"}
#: What may stand for a file in an option.
_CONTENT_OPTIONS = {"SURFACE", "MESH", "X"}
#: What errors and pages call an argument that has no name of its own.
_SPOKEN = {"X": "manifold", "Y": "other manifold", "FIRST": "first surface", "SECOND": "second surface"}
#: Python's prompt is the shell.
NOT_IN_PYTHON = {"shell": "at Python's prompt every command is a function, and names are variables"}


@functools.lru_cache(maxsize=None)
def table() -> Dict[str, Any]:
    """What `tetrarch help --json` prints: commands, their options, the fields of their results.

    >>> import tetrarch as tt
    >>> [argument["name"] for argument in tt.commands.table()["commands"][0]["arguments"]]
    ['X']
    """
    described: Dict[str, Any] = json.loads(_tetrarch.describe())
    return described


@functools.lru_cache(maxsize=None)
def _commands() -> Dict[str, Dict[str, Any]]:
    return {command["name"]: command for command in table()["commands"]}


def function_name(command: str) -> str:
    """"census list" is the function census_list.

    >>> from tetrarch import commands
    >>> commands.function_name("census list")
    'census_list'
    """
    return command.replace(" ", "_").replace("-", "_")


def keyword_name(option: Dict[str, Any]) -> str:
    """The option -o, --output is the keyword output."""
    name: str = max(option["names"], key=len).lstrip("-").replace("-", "_")
    return name + "_" if keyword.iskeyword(name) else name


def _options(command: Dict[str, Any]) -> Dict[str, Dict[str, Any]]:
    """Its own options by their keywords, then those that all have; how to print is not for us."""
    options = {keyword_name(option): option for option in command["options"]}
    for option in table()["common"]:
        if keyword_name(option) not in ("json", "quiet"):
            options.setdefault(keyword_name(option), option)
    return options


class _Values:
    """What stands for the names in a line of words: what the caller keeps, and what is made for this call alone."""

    def __init__(self) -> None:
        self.kept: Dict[str, _tetrarch.Content] = {}
        self.passing: Dict[str, _tetrarch.Content] = {}

    def add(self, key: str, value: Any) -> None:
        content = held(value)
        if content is not None:
            self.kept[key] = content
            return
        content = content_of(value, key)
        (self.kept if content.kind in ("triangulation", "group") else self.passing)[key] = content


def _number_text(value: Any) -> Optional[str]:
    if isinstance(value, (int, float)):
        return repr(value)
    if getattr(value, "shape", None) != ():
        return None
    try:  # a number of NumPy's
        return repr(operator.index(value))
    except TypeError:
        pass
    try:
        return repr(float(value))
    except (TypeError, ValueError, OverflowError):
        return None


def _word(value: Any, name: str) -> str:
    if is_text(value):
        return text_of(value)
    text = None if isinstance(value, bool) else _number_text(value)
    if text is None:
        raise InputError("%s is a %s (expected a text or a number)" % (name, type(value).__name__))
    return text


def _is_list(value: Any) -> bool:
    return isinstance(value, (list, tuple, range)) or (_is_array(value) and len(value.shape) == 1)


def _joined(value: Any, name: str, option: Dict[str, Any]) -> str:
    """A list within an option: 3,17,20, or a range 9..10, of which either end may be None."""
    if option["value"] == "A..B" and _is_list(value):
        return "..".join("" if item is None else _word(item, name) for item in value)
    return ",".join(_word(item, name) for item in value) if _is_list(value) else _word(value, name)


def _option_words(name: str, option: Dict[str, Any], value: Any, values: _Values) -> List[str]:
    spelled = max(option["names"], key=len)
    if value is None or value is False:
        return []
    if option["value"] is None:
        if value is not True:
            raise InputError("%s is %s (expected True or False)" % (name, shown(value)))
        return [spelled]
    if value is True:
        if not option["optional_value"]:
            raise InputError("%s is True (expected a value: %s)" % (name, option["help"]))
        return [spelled]
    if option["value"] in _CONTENT_OPTIONS and not is_text(value):
        key = "the value of " + name
        values.add(key, value)
        return ["%s=%s" % (spelled, key)]
    if option["words"] > 1:
        if not _is_list(value) or len(value) != option["words"]:
            raise InputError("%s is %s (expected %d values)" % (name, shown(value), option["words"]))
        return [spelled, *(_word(item, name) for item in value)]
    if option["repeats"] and _is_list(value):
        return ["%s=%s" % (spelled, _joined(item, name, option)) for item in value]
    return ["%s=%s" % (spelled, _joined(value, name, option))]


def _argument_words(arguments: List[Dict[str, Any]], given: Tuple[Any, ...], values: _Values) -> List[str]:
    words: List[str] = []
    waiting = list(given)
    for argument in arguments:
        taken, waiting = (waiting, []) if argument["repeats"] else (waiting[:1], waiting[1:])
        if argument["required"] and not taken:
            raise TypeError("the argument %s is missing (%s)" % (argument["name"], argument["help"]))
        for value in taken:
            # Points and elements may also stand one after the other.
            if _is_array(value) and len(value.shape) == 2 and waiting and not argument["repeats"]:
                value = (value, waiting.pop(0))
            if is_text(value):
                words.append(text_of(value))
                continue
            number = None if isinstance(value, bool) or not argument["repeats"] else _number_text(value)
            if number is not None:
                words.append(number)
                continue
            key = "the " + _SPOKEN.get(argument["name"], argument["name"].lower())
            values.add(key, value)
            words.append(key)
    if waiting:
        raise TypeError("there is an argument too many: %s" % shown(waiting[0]))
    return words


def value_of(content: Optional[_tetrarch.Content]) -> Any:
    """A Triangulation, Mesh or FundamentalGroup; None of None."""
    from .meshes import Mesh
    from .triangulation import Triangulation

    if content is None:
        return None
    if content.kind == "triangulation":
        return Triangulation._of(content)
    if content.kind == "group":
        return FundamentalGroup(*content.group())
    return Mesh._of(content)


def _run_once(command: Dict[str, Any], words: List[str], values: _Values, progress: Progress) -> Result:
    with reporting(progress) as report:
        status, tree, text, warnings, value, files = _tetrarch.run(words, values.kept, values.passing, report)
    kind = _result_class(command["name"])
    fields = tree if isinstance(tree, dict) else None
    return kind(fields, _VERDICTS[status], text, warnings, files, value_of(value))  # type: ignore[no-any-return]


def run(command: str, *arguments: Any, progress: Progress = None, **options: Any) -> Any:
    """Runs a command of the program: options are keywords, --keep-boundary as keep_boundary=True.

    An argument is a text as on the command line, or a Manifold, Triangulation, Mesh, arrays (V, F), an object of Regina, SnapPy,
    meshio or PyVista. A text "FILE#*" means all triangulations of a file, and the results come as a list. An option that may be
    repeated takes a list; a list such as 3,17,20 is a tuple of numbers. Returns a Result; a proved no and an undecided answer are
    values, bad input is an InputError.

    >>> import tetrarch as tt
    >>> tt.run("hyperbolize", "cPcbbbihq", attempts=10).volume                # doctest: +ELLIPSIS
    6.45199027083...
    >>> tt.run("isometric", tt.Manifold("m004"), "m003").verdict
    'no'
    """
    known = _commands()
    if not isinstance(command, str) or command not in known:
        near = difflib.get_close_matches(str(command), list(known), 1)
        raise InputError("unknown command %s%s" % (shown(command), " (did you mean %r?)" % near[0] if near else ""))
    if command in NOT_IN_PYTHON:
        raise PreconditionError("%s is no function: %s" % (command, NOT_IN_PYTHON[command]))
    entry = known[command]
    names = _options(entry)
    values = _Values()
    words: List[str] = []
    for name, value in options.items():
        if name not in names:
            near = difflib.get_close_matches(name, list(names), 1)
            raise TypeError("%s has no option %r%s" % (command, name, " (did you mean %r?)" % near[0] if near else ""))
        words += _option_words(name, names[name], value, values)
    head = command.split() + words + ["--"]
    tail = _argument_words(entry["arguments"], arguments, values)
    mapped = [k for k, word in enumerate(tail) if word.endswith("#*")]
    if not mapped or any(word in values.kept or word in values.passing for word in tail):
        return _run_once(entry, head + tail, values, progress)
    path = tail[mapped[0]][:-2]
    count = len(_tetrarch.collection(path, None))
    return [_run_once(entry, head + [word if k != mapped[0] else "%s#%d" % (path, number) for k, word in enumerate(tail)], values,
                      progress) for number in range(1, count + 1)]


# -- results with documented fields

def field_name(field: Dict[str, Any]) -> str:
    """The attribute of a field: its name, as far as Python takes it for one (from_ for from, below_0_2 for below_0.2)."""
    return attribute_name(field["name"])


def _field_doc(field: Dict[str, Any]) -> str:
    return "%s%s" % (field["meaning"], " (%s)" % field["unit"] if field["unit"] else "")


@functools.lru_cache(maxsize=None)
def _result_class(command: str) -> Any:
    """A Result whose fields are documented as `tetrarch help --json` documents them."""
    fields = _commands()[command].get("result") or []
    if not fields:
        return Result

    def attribute(name: str, field: Dict[str, Any]) -> property:
        def read(self: Result) -> Any:
            return self.__getattr__(name)

        return property(read, doc=_field_doc(field))

    taken = {*dir(Result), *Result.__annotations__}  # how it came out: the field is result["warnings"]
    members: Dict[str, Any] = {field_name(field): attribute(field_name(field), field) for field in fields
                               if field_name(field) not in taken}
    members["__doc__"] = "What `tetrarch %s` found.\n\n" % command + "\n".join(
        "%s: %s" % (field_name(field), _field_doc(field)) for field in fields)
    members["__reduce__"] = lambda self: (_restored, (command, self.__dict__.copy()))
    members["__module__"] = __name__
    return type("".join(word.capitalize() for word in re.split(r"[ -]", command)) + "Result", (Result,), members)


def _restored(command: str, state: Dict[str, Any]) -> Result:
    made: Result = Result.__new__(_result_class(command))
    made.__dict__.update(state)
    return made


# -- functions

def _default_of(option: Dict[str, Any]) -> Any:
    text = option["default"]
    if option["value"] is None:
        return False
    if text is None:
        return None
    if option["value"] == "FLOAT":
        return float(text)
    return int(text) if option["value"] in ("INT", "UINT") else text


def annotation_of(option: Dict[str, Any]) -> str:
    """How the stubs spell the type of an option."""
    if option["value"] is None:
        return "bool"
    if option["choices"]:
        kind = "Literal[%s]" % ", ".join(json.dumps(choice) for choice in option["choices"])
    elif option["value"] in _CONTENT_OPTIONS:
        return "Any"
    else:
        kind = {"INT": "int", "UINT": "int", "FLOAT": "float", "GB": "float"}.get(option["value"], "Word")
    if option["optional_value"]:
        kind = "Union[bool, %s]" % kind
    if option["repeats"] or option["words"] > 1:
        kind = "Union[%s, Sequence[%s]]" % (kind, kind)
    return kind if _default_of(option) is not None else "Optional[%s]" % kind


def signature_of(command: Dict[str, Any]) -> inspect.Signature:
    """Its arguments, then its options as keywords."""
    kind = inspect.Parameter
    parameters = []
    for argument in command["arguments"]:
        if argument["repeats"]:
            parameters.append(kind(argument["name"], kind.VAR_POSITIONAL))
        else:
            parameters.append(kind(argument["name"], kind.POSITIONAL_ONLY, default=kind.empty if argument["required"] else None))
    for name, option in _options(command).items():
        default = kind.empty if option["required"] else _default_of(option)
        leads = option["required"] and not command["arguments"]
        parameters.append(kind(name, kind.POSITIONAL_OR_KEYWORD if leads else kind.KEYWORD_ONLY, default=default))
    parameters.sort(key=lambda parameter: parameter.kind)
    parameters.append(kind("progress", kind.KEYWORD_ONLY, default=None))
    return inspect.Signature(parameters)


def example_of(command: Dict[str, Any]) -> str:
    """The example of the command's help, as a call."""
    words = shlex.split(command["example"])[1 + len(command["name"].split()):]
    by_name = {name: (key, option) for key, option in _options(command).items() for name in option["names"]}
    arguments: List[str] = []
    options: Dict[str, Any] = {}
    while words:
        word = words.pop(0)
        if word not in by_name:
            arguments.append(repr(int(word) if word.isdigit() else word))
            continue
        key, option = by_name[word]
        value: Any = True
        if option["value"] is not None:
            text = words.pop(0)
            value = int(text) if re.fullmatch(r"-?\d+", text) else text
        options[key] = value
    arguments += ["%s=%r" % item for item in options.items()]
    return "tt.%s(%s)" % (function_name(command["name"]), ", ".join(arguments))


def _documentation(command: Dict[str, Any]) -> str:
    summary = command["summary"]
    lines = [summary[0].upper() + summary[1:] + ".", ""]
    for argument in command["arguments"]:
        lines.append("%s: %s" % (argument["name"], argument["help"]))
    for name, option in _options(command).items():
        lines.append("%s: %s" % (name, option["help"]))
    lines += ["", "Returns a Result; see `run` for what may stand for an argument."]
    for field in command.get("result") or []:
        lines.append("    .%s: %s" % (field_name(field), _field_doc(field)))
    lines += ["", ">>> import tetrarch as tt", ">>> result = " + example_of(command), ">>> isinstance(result, tt.Result)", "True"]
    return "\n".join(lines)


def _missing(signature: inspect.Signature, options: Dict[str, Any]) -> Optional[str]:
    for name, parameter in signature.parameters.items():
        if parameter.kind in (parameter.KEYWORD_ONLY, parameter.POSITIONAL_OR_KEYWORD) and parameter.default is parameter.empty and name not in options:
            return name
    return None


@functools.lru_cache(maxsize=None)
def function(command: str) -> Callable[..., Any]:
    """The function of a command. `tetrarch.NAME` is the same."""
    entry = _commands()[command]

    # census_enumerate(3): where there are no arguments, what is required may stand for one.
    leading = [] if entry["arguments"] else [name for name, option in _options(entry).items() if option["required"]]

    def twin(*arguments: Any, progress: Progress = None, **options: Any) -> Any:
        for name in leading[:len(arguments)]:
            if name not in options:
                options[name], arguments = arguments[0], arguments[1:]
        missing = _missing(signature, options)
        if missing is not None:
            raise TypeError("%s needs the option %s (%s)" % (command, missing, _options(entry)[missing]["help"]))
        return run(command, *arguments, progress=progress, **options)

    signature = signature_of(entry)
    twin.__name__ = twin.__qualname__ = function_name(command)
    twin.__module__ = __name__
    twin.__doc__ = _documentation(entry)
    twin.__signature__ = signature  # type: ignore[attr-defined]
    return twin


@functools.lru_cache(maxsize=None)
def functions() -> Dict[str, str]:
    """The names of all functions, and the commands that they run.

    >>> from tetrarch import commands
    >>> commands.functions()["census_list"]
    'census list'
    """
    return {function_name(name): name for name in _commands() if name not in NOT_IN_PYTHON}


def __getattr__(name: str) -> Any:
    if not name.startswith("_") and name in functions():
        return function(functions()[name])
    raise AttributeError("module %r has no attribute %r" % (__name__, name))


def __dir__() -> List[str]:
    return sorted({*globals(), *functions()})
