# intact.py - several processes write one file at once: it is one of their texts at every moment
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.intact FOLDER"""
import multiprocessing
import os
import sys

from .. import intact

ROUNDS, LETTERS = 200, "abcd"


def writer(path, letter):
    for n in range(ROUNDS):
        intact.write(path, letter * (100000 + 997 * n))


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


main(sys.argv[1])
