#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the notebooks of the guide and compares what comes out with what stands there.

    notebooks.py [--write] [FILE ...]      --write puts what comes out in its place

Cells are run by Python alone, in an empty folder. What a cell prints and the text of its last expression are compared exactly; pages,
which a notebook would show in place of that text, must be there and are not kept.
"""
import ast
import contextlib
import io
import json
import os
import sys
import tempfile

GUIDE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "guide")


def lines_of(text):
    return text.splitlines(keepends=True)


def run(source, names, number):
    """The outputs of a cell, as the format of notebooks has them."""
    tree, printed, outputs, value = ast.parse(source), io.StringIO(), [], None
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell %d" % number, "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), "cell %d" % number, "eval"), names)
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines_of(printed.getvalue())})
    if value is not None:
        page = getattr(value, "_repr_html_", None)
        if page is not None and not page().startswith("<iframe"):
            raise SystemExit("cell %d has no page" % number)
        outputs.append({"data": {"text/plain": lines_of(repr(value))}, "execution_count": number, "metadata": {},
                        "output_type": "execute_result"})
    return outputs


def main(arguments):
    write = "--write" in arguments
    files = [os.path.abspath(name) for name in arguments if name != "--write"]
    files = files or sorted(os.path.join(GUIDE, name) for name in os.listdir(GUIDE) if name.endswith(".ipynb"))
    differing = 0
    for path in files:
        with open(path, encoding="utf-8") as file:
            notebook = json.load(file)
        names, number = {"__name__": "__main__"}, 0
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            for cell in notebook["cells"]:
                if cell["cell_type"] != "code":
                    continue
                number += 1
                outputs = run("".join(cell["source"]), names, number)
                if outputs != cell["outputs"] and not write:
                    differing += 1
                    print("%s, cell %d\n  there: %s\n  now:   %s" % (os.path.basename(path), number, cell["outputs"], outputs))
                cell.update(outputs=outputs, execution_count=number)
            os.chdir("/")
        if write:
            with open(path, "w", encoding="utf-8") as file:
                json.dump(notebook, file, indent=1, ensure_ascii=False)
                file.write("\n")
    print("%d notebooks, %d cells differ" % (len(files), differing))
    return 1 if differing or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
