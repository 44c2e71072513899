# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program within limits, and says what is wrong with how it ended."""
import resource
import subprocess
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Optional

SECONDS = 60
MEMORY = 6 * 2**30  # [bytes], of addresses
SENTENCE = 300  # [characters]
CODES = range(6)  # as the programs' --help has them
JARGON = ["[json.exception", "filesystem error", "terminate called", "OpenCV(", "libpng ", "JPEG data", "stod",
          "std::", "autofixing", "bad_alloc", "MRPT_", "what():", "cURL", "CLI::", "AddressSanitizer",
          "TRuntimeClassId", "Assert condition", "MRPT exception"]


@dataclass
class Case:
    """An input that is hostile or unlucky."""

    name: str
    command: list  # program and arguments
    prepare: Callable[[], None] = lambda: None  # makes the input, in the current folder
    output: Optional[str] = None  # file that the program writes if it succeeds
    mayHaveSaved: bool = field(default=False)  # the output may be there although it failed
    secret: Optional[str] = None  # must not be printed


@dataclass
class Ended:
    """How a run ended; a code below 0 is a signal, None the end of patience."""

    code: Optional[int]
    errors: str
    output: str = ""

    def shown(self):
        return f"code {self.code}: {self.errors[-500:]!r}"


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(programs, command):
    try:
        ended = subprocess.run([str(programs / command[0])] + command[1:], capture_output=True,
                               stdin=subprocess.DEVNULL, timeout=SECONDS, preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return Ended(None, "")
    return Ended(ended.returncode, ended.stderr.decode("utf-8", "surrogateescape"),
                 ended.stdout.decode("utf-8", "surrogateescape"))


def hasControls(text):
    return any(ord(c) < 32 or 127 <= ord(c) < 160 or 0xDC80 <= ord(c) <= 0xDCFF for c in text)


def verdict(ended, before, case):
    """What is wrong; nothing if all is right."""
    if ended.code is None:
        return f"ran for more than {SECONDS} s"
    if ended.code not in CODES:
        return "ended by a signal" if ended.code < 0 else "an exit code that is not documented"
    lines = ended.errors.splitlines()
    if any(hasControls(line) for line in ended.errors.split("\n")):
        return "control characters, or text that is no UTF-8"
    if any(word in ended.errors for word in JARGON):
        return "the words of a library"
    if case.secret and case.secret in ended.errors + ended.output:
        return "what is to be hidden"
    if ended.code != 0:
        if not lines or not lines[-1].startswith(case.command[0] + ": "):
            return "no sentence"
        if len(lines[-1]) > SENTENCE:
            return f"a sentence of {len(lines[-1])} characters"
    new = {path.name for path in set(Path(".").rglob("*")) - before}
    if any(".part" in name for name in new):
        return f"left behind: {sorted(new)}"
    if ended.code != 0 and case.output and not case.mayHaveSaved and Path(case.output).exists():
        return "an output in spite of the failure"
    return None
