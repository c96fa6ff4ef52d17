# slurm.py - chunks, and rounds of the slurm engine, with an sbatch that loses and damages
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.slurm FOLDER         FOLDER is made
       python3 -m lab.checks.slurm FOLDER KEY     one job of it"""
import contextlib
import io
import os
import random
import sys

from ..jobs import plan, run, slurm, store

# Runs a whole array before it returns, but for chunk $LOST; then what stands in $AFTER, once.
SBATCH = """#!/bin/sh
[ -z "$REFUSE" ] || { echo "sbatch: error: $REFUSE" >&2; exit 1; }
n=1
for word; do
    case $word in --array=1-*) n=${word#--array=1-} ;; esac
    script=$word
done
case $script in
*/start*)
    for i in $(seq "$n"); do
        if [ "$i" = "$LOST" ] && [ ! -e "$HERE/lost" ]; then : >"$HERE/lost"
        else SLURM_ARRAY_TASK_ID=$i sh "$script" >>"$HERE/log" 2>&1; fi
    done
    [ -e "$HERE/after" ] || sh -c "$AFTER"
    : >"$HERE/after"
    echo "array $n" >>"$HERE/sent" ;;
*) sh "$script" ;;
esac
echo 17
"""


def cuts():
    """Chunks have every job once, and cost what is promised."""
    random.seed(1)
    assert slurm.cut([]) == []
    for n in (1, 7, 10000):
        jobs = [{"key": str(i), "cost": random.choice((0.1, 3, 29, 31, 59, 60, 61, 900)) *
                 random.random()} for i in range(n)]
        cut = slurm.cut(jobs)
        assert sorted(j["key"] for c in cut for j in c) == sorted(j["key"] for j in jobs)
        small = 0
        for chunk in cut:
            cost = sum(j["cost"] for j in chunk)
            assert cost <= slurm.MOST + 1e-9 or len(chunk) == 1, chunk
            small += cost < slurm.LEAST
        assert small <= 1, small


def key_of(i):
    return f"n={i}"


def one(folder, key):
    """A job: the square of its number."""
    if store.look(f"{folder}/results", key)[1] is not None:
        n = int(key.split("=")[1])
        if n < 0:
            sys.exit("no such number")
        store.save(f"{folder}/results", key, [], {"square": n * n}, 0.01)


def engine(folder, numbers, **environment):
    """Exit code and what was printed."""
    for name in ("lost", "after", "log", "sent"):
        with contextlib.suppress(FileNotFoundError):
            os.remove(f"{folder}/{name}")
    os.environ.update(dict(LOST="", AFTER=":", REFUSE="", HERE=folder), **environment)
    results, said = f"{folder}/results", io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        plan.write(f"{folder}/list", results,
                   [plan.job(results, key_of(i), ["python3", "-m", "lab.checks.slurm", folder,
                                                  key_of(i)], 25) for i in numbers], "squares")
        try:
            code = run.main("slurm", f"{folder}/list")
        except SystemExit as e:
            said.write(str(e.code))
            code = 1
    return code, said.getvalue()


def there(folder, numbers):
    for i in numbers:
        result, why = store.look(f"{folder}/results", key_of(i))
        assert result == {"square": i * i}, (i, why)


def faults(folder):
    """A chunk that is lost, half a file, a digit changed, the result of another job."""
    of = [store.path(f"{folder}/results", key_of(i)) for i in range(9)]
    code, said = engine(folder, range(9), LOST="1", AFTER=f"""
        head -c 40 '{of[4]}' >'{of[4]}.half' && mv '{of[4]}.half' '{of[4]}'
        sed -i 's/"square": 25/"square": 26/' '{of[5]}'
        cp '{of[8]}' '{of[6]}'""")
    assert code == 0, said
    there(folder, range(9))
    assert "round 1: 9 jobs in 5 chunks" in said and "round 2: 5 jobs in 3 chunks" in said, said
    assert said.count("is damaged") == 3 and said.count("never run") == 2, said
    stamps = [os.stat(name).st_mtime_ns for name in of]
    code, said = engine(folder, range(9))
    assert code == 0 and "0 to run" in said and not os.path.exists(f"{folder}/sent"), said
    assert stamps == [os.stat(name).st_mtime_ns for name in of]
    assert sorted(os.listdir(f"{folder}/results")) == sorted(os.path.basename(n) for n in of)
    assert store.seconds(f"{folder}/results", key_of(3), 9) == 0.01  # cheaper than was guessed


def ends(folder):
    """A job that always fails, no sbatch, an sbatch that takes nothing: it says so, and ends."""
    code, said = engine(folder, [10, -1, 11])
    assert code == 1 and "1 of 3 results are missing" in said and "n=-1: never run" in said, said
    assert "round 3" in said and "round 4" not in said, said
    there(folder, [10, 11])
    code, said = engine(folder, [12], REFUSE="invalid partition specified: x")
    assert code == 1 and "sbatch: error: invalid partition specified: x" in said, said
    path, os.environ["PATH"] = os.environ["PATH"], folder + "/nothing"
    code, said = engine(folder, [12])
    os.environ["PATH"] = path
    assert code == 1 and "there is no sbatch here" in said and "make slurm-setup" in said, said


def arrays(folder):
    """More chunks than an array takes."""
    slurm.ARRAY = 2
    code, said = engine(folder, range(20, 31))
    assert code == 0 and "in 6 chunks" in said, said
    there(folder, range(20, 31))
    with open(f"{folder}/sent", encoding="utf-8") as f:
        assert f.read() == "array 2\n" * 3


def files(folder):
    """A file that belongs to a result: as it was, changed, gone."""
    name = f"{folder}/made"
    for text in ("one", "two"):
        with open(name, "w", encoding="utf-8") as f:
            f.write(text)
        if text == "one":
            store.save(f"{folder}/results", "file", [], 1, files=[name])
            assert store.look(f"{folder}/results", "file") == (1, None)
    assert store.look(f"{folder}/results", "file") == (None, f"{name} is damaged")
    os.remove(name)
    assert store.look(f"{folder}/results", "file") == (None, f"{name} is damaged")


def sources(folder):
    """A file that a result was made of: as it was, changed."""
    name = f"{folder}/source"
    for text in ("one", "two"):
        with open(name, "w", encoding="utf-8") as f:
            f.write(text)
        if text == "one":
            store.save(f"{folder}/results", "of", [name], 1)
            assert store.look(f"{folder}/results", "of") == (1, None)
    assert store.look(f"{folder}/results", "of") == (None, "sources changed")


def main(folder):
    slurm.POLL = 0.05
    os.makedirs(folder + "/bin")
    for name, text in (("sbatch", SBATCH), ("scancel", "#!/bin/sh\n")):
        slurm.put(f"{folder}/bin/{name}", text)
    os.environ["PATH"] = f"{folder}/bin:" + os.environ["PATH"]
    cuts()
    faults(folder)
    ends(folder)
    arrays(folder)
    files(folder)
    sources(folder)


if __name__ == "__main__":
    one(*sys.argv[1:]) if len(sys.argv) == 3 else main(os.path.abspath(sys.argv[1]))
