# intact.py - a file is one of the texts of its writers at every moment, whatever fails
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.intact FOLDER"""
import multiprocessing
import os
import secrets
import sys
from unittest import mock

from .. import intact

ROUNDS, LETTERS = 20, "abcd"


def writer(path, letter):
    for n in range(ROUNDS):
        intact.write(path, letter * (100000 + 997 * n))


def failing(folder, path):
    """Each call of the system fails once: that is told, and what was there stays."""
    intact.write(path, "old")
    for call in ("open", "fsync", "replace"):
        with mock.patch.object(os, call, side_effect=OSError(5, "told", path)):
            try:
                intact.write(path, "new")
            except OSError as error:
                assert error.errno == 5, error
            else:
                raise AssertionError(f"os.{call} failed, and nobody was told")
        with open(path, encoding="utf-8") as f:
            assert f.read() == "old", call
        assert os.listdir(folder) == ["result"], f"os.{call} failed: something is left behind"


def planted(path):
    """A link at the temporary name is not followed."""
    victim, link = path + ".victim", ".".join((path, "known", "tmp"))
    intact.write(victim, "old")
    os.symlink(victim, link)
    with mock.patch.object(secrets, "token_hex", return_value="known"):
        try:
            intact.write(path, "new")
        except FileExistsError:
            pass
        else:
            raise AssertionError("a planted link was followed")
    with open(victim, encoding="utf-8") as f:
        assert f.read() == "old", "the target of a link was overwritten"
    assert os.path.islink(link), "what somebody else has was removed"
    os.remove(victim)
    os.remove(link)


def main(folder):
    path = os.path.join(folder, "result")
    intact.write(path, "a")
    writers = [multiprocessing.Process(target=writer, args=(path, letter)) for letter in LETTERS]
    for process in writers:
        process.start()
    while any(process.is_alive() for process in writers):
        with open(path, encoding="utf-8") as f:
            text = f.read()
        assert text and text == text[0] * len(text), f"mixed: {len(text)} of {set(text)}"
    assert all(process.exitcode == 0 for process in writers), "a writer failed"
    assert os.listdir(folder) == ["result"], "something is left behind"
    failing(folder, path)
    planted(path)


main(sys.argv[1])
