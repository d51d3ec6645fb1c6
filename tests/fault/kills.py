#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Long jobs struck by KILL, INT, TERM and HUP at random moments: old outputs whole, nothing left over, ended within a second.

Usage: kills.py PROGRAM SOURCE_DIR [--times N] [--seed N]

By hand, for it takes long: N strikes (default 100) by each signal of each job, at moments spread evenly at random over the job's
length, and the example of each command's help page by TERM, a tenth as often. Prints a table, and every fault as a line; the exit status is 1 if there is any.
"""
import argparse
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

OLD = b"what was there before\n"
SIGNALS = (signal.SIGKILL, signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def jobs(source):
    mesh = os.path.join(source, "tests/data/mesh")
    ring, double = os.path.join(mesh, "ring_two_holes.off"), os.path.join(mesh, "double_torus.off")
    solid = os.path.join(source, "tests/data/knotted_y_8k.mesh")
    return {
        "simplify": ("simplify", solid, "--audit", "-o", "out.json"),
        "slit": ("slit", ring, "--domain", "free", "-o", "out.obj", "-o", "out.svg"),
        "bundle": ("bundle", double, "--fiber", "60", "-o", "out.json"),
        "product": ("product", os.path.join(source, "tests/data/genus4_ridges.mesh"), "--labels", "1,2", "--hex", "20",
                    "-o", "out.vtu"),
        "hex": ("hex", double, "--cells", "1000", "-o", "out.mesh"),
        "census": ("census", "enumerate", "--tetrahedra", "3", "--work", "work", "-o", "out.jsonl"),
    }


def outputs(job):
    return [job[k + 1] for k, word in enumerate(job) if word == "-o"]


def start(program, job, folder):
    for name in outputs(job):
        with open(os.path.join(folder, name), "wb") as file:
            file.write(OLD)
    return subprocess.Popen([program, *job], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def contents(job, folder):
    found = {}
    for name in outputs(job):
        with open(os.path.join(folder, name), "rb") as file:
            found[name] = file.read()
    return found


def whole(program, job):
    """What an undisturbed run writes, and how long it takes."""
    with tempfile.TemporaryDirectory() as folder:
        began = time.monotonic()
        done = start(program, job, folder)
        done.communicate()
        if done.returncode not in (0, 1, 4):
            raise SystemExit(f"{job}: status {done.returncode}")
        return contents(job, folder), time.monotonic() - began


def strike(program, job, number, moment, good):
    """(what was wrong or nothing, whether the job was over before, seconds from the signal to the end)."""
    with tempfile.TemporaryDirectory() as folder:
        struck = start(program, job, folder)
        time.sleep(moment)
        over = struck.poll() is not None
        began = time.monotonic()
        struck.send_signal(number)
        _, said = struck.communicate()
        took = time.monotonic() - began
        found, names = contents(job, folder), set(os.listdir(folder)) - set(outputs(job)) - {"work"}
        old = all(content == OLD for content in found.values())
        new = found == good
        # Two files take their places one after the other: whoever dies between them leaves one new and one old, each whole.
        parted = number == signal.SIGKILL and all(content in (OLD, good[name]) for name, content in found.items())
        if not old and not new and not parted:
            return "outputs are neither the old ones nor the new ones", over, took
        if number == signal.SIGKILL:
            left = [name for name in names if not name.endswith(".part")]
            return f"left over: {left}" if left else None, over, took
        if names:
            return f"left over: {sorted(names)}", over, took
        if struck.returncode == 130 and said == b"tetrarch: interrupted while files were written\n":
            return None, over, took  # all of them, or none: see above
        if struck.returncode == 130 and (not old or said != b"tetrarch: interrupted; nothing was written\n"):
            return f"interrupted, but said {said!r}, old outputs: {old}", over, took
        if struck.returncode == -number and old:
            return None, over, took  # it came before the program had asked for signals
        if struck.returncode not in (130, 0, 1, 4) or (struck.returncode != 130 and not new):
            return f"status {struck.returncode}, new outputs: {new}", over, took
        return None, over, took


def struck_examples(program, times, rng):
    """Every command of the help pages, as its example has it, struck by one TERM at random moments: [fault]."""
    told = json.loads(subprocess.run([program, "help", "--json"], capture_output=True, check=True).stdout)
    faults, strikes, longest = [], 0, (0.0, "")
    for command in told["commands"]:
        words = [word.strip("'") for word in command["example"].split()[1:]]
        with tempfile.TemporaryDirectory() as folder:
            began = time.monotonic()
            subprocess.run([program, *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, check=False)
            length = time.monotonic() - began
        for _ in range(times):
            with tempfile.TemporaryDirectory() as folder:
                # A prompt or a pipe waits for as long as nobody types.
                job = subprocess.Popen([program, *words], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                time.sleep(rng.uniform(0, length))
                began = time.monotonic()
                job.terminate()
                job.communicate()
                took = time.monotonic() - began
                strikes, longest = strikes + 1, max(longest, (took, command["name"]))
                left = [name for name in os.listdir(folder) if name.endswith(".part")]
                if took > 2 or left or job.returncode not in (130, 0, 1, 4, -signal.SIGTERM):
                    faults.append(f"{command['name']}: status {job.returncode} after {took:.2f} s, left over: {left}")
    print(f"examples of {len(told['commands'])} commands, {strikes} strikes by TERM: the longest end {longest[0]:.2f} s ({longest[1]})")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("source")
    parser.add_argument("--times", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    program, rng = os.path.abspath(options.program), random.Random(options.seed)
    faults = 0
    wrong = struck_examples(program, max(1, options.times // 10), rng)
    faults += len(wrong)
    for fault in wrong:
        print(f"  {fault}", flush=True)
    print(f"{'job':10} {'length s':>8} {'strikes':>8} {'in time':>8} {'longest end s':>14} {'faults':>7}")
    for name, job in jobs(os.path.abspath(options.source)).items():
        good, length = whole(program, job)
        strikes, working, longest, wrong = 0, 0, 0.0, []
        for number in SIGNALS:
            for _ in range(options.times):
                moment = rng.uniform(0, length)
                fault, over, took = strike(program, job, number, moment, good)
                strikes += 1
                working += not over
                longest = max(longest, took)
                if fault:
                    wrong.append(f"{name}, {number.name} after {moment:.3f} s: {fault}")
        print(f"{name:10} {length:8.2f} {strikes:8} {working:8} {longest:14.2f} {len(wrong):7}", flush=True)
        for fault in wrong:
            print(f"  {fault}", flush=True)
        faults += len(wrong)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
