"""The module against `glint`: module_test.py GLINT, in an environment that has the module."""

import csv
import subprocess
import sys
import threading
import time
from pathlib import Path

import glint
import numpy as np


def refused(text, function, *arguments, **settings):
    try:
        function(*arguments, **settings)
    except glint.Error as error:
        assert text in str(error), error
        return
    raise AssertionError(f"{arguments} was not refused")


def results(program):
    """All lobes, legal inputs and all that ports carry, against `glint eval --stdin --port`; vectors; a sweep."""
    random = np.random.default_rng(1)
    for name in glint.lobes():
        for profile in ("p8", "p12", "p16"):
            lobe = glint.lobe(name, profile)
            n = random.integers(0, 1024, 3000, dtype=np.uint16)
            cos = random.integers(-(2 << lobe.F), 2 << lobe.F, 3000, dtype=np.int32)
            text = subprocess.run([program, "eval", "--lobe", name, "--profile", profile, "--stdin", "--port"], capture_output=True, text=True,
                                  check=True, input="".join(f"{a} {b}\n" for a, b in zip(n, cos))).stdout
            want = np.array([line.split() for line in text.splitlines()], int)
            y, clamped = glint.unpack(lobe.port(n, cos))
            assert (y == want[:, 0]).all() and (clamped == want[:, 1]).all(), name
            legal = ~clamped
            assert (lobe(n[legal], cos[legal]) == y[legal]).all()
            vectors = lobe.vectors(2000, 3)
            y, clamped = glint.unpack(lobe.port(vectors.n, vectors.cos_code))
            assert (y == vectors.y).all() and (clamped == vectors.clamped).all() and clamped.any()
    for name in glint.effects():
        effect = glint.effect(name, "p12")
        columns, want = effect.vectors(3000, 2)
        got = effect(**columns)
        assert all((got.values[key] == want.values[key]).all() for key in want.values) and (got.clamped == want.clamped).all(), name
    subprocess.run([program, "sweep", "--profile", "p8", "--n", "1:1000:50", "--csv", "sweep.csv"], check=True, capture_output=True)
    sweep = glint.lobe("bps", "p8").sweep(n=range(1, 1001, 50))
    rows = list(csv.DictReader(Path("sweep.csv").open(encoding="utf-8")))
    for row, mine in zip(rows, [*sweep.rows, sweep.total]):
        for column in sweep.rows.dtype.names[1:]:
            if row[column]:
                assert abs(float(row[column]) - mine[column]) <= 1e-8 * abs(mine[column]), (row["n"], column)
    assert len(rows) == 21


def refusals():
    lobe = glint.lobe("bps", "p12")
    assert lobe(50, 256901) == 1448 and lobe([[50], [8]], [256901, 5]).shape == (2, 2) and lobe([], []).shape == (0,)
    for n, cos, text in ((0, 5, "n[0] 0"), (1024, 5, "n[0] 1024 is not legal: 1 to 1023"), (5, -1, "cos_code[0] -1"), (5, 262145, "262145"),
                         (70000, 5, "n 70000"), (5, 2**40, "cos_code 1099511627776"), (1.5, 5, "integers"), ([1, 2], [1, 2, 3], "")):
        try:
            refused(text, lobe, n, cos)
        except ValueError:
            assert text == ""  # numpy's own, for shapes
    cos = np.zeros(10000, np.int32)
    cos[9000] = -1
    refused("cos_code[9000] -1 is not legal: 0 to 262144", lobe, 5, cos)
    n = np.ones(10000, np.uint16)
    n[9999] = 1024
    refused("n[9999] 1024", lobe.port, n, 0)
    refused("-524289", lobe.port, 5, -524289)
    refused("lobe 'none'", glint.lobe, "none")
    refused("p9", glint.lobe, "bps", "p9")
    refused("out is not legal", lobe, 5, 5, out=np.empty(2, np.uint32))
    refused("inputs", glint.effect("lambert"), x=1)
    refused("is not legal", lobe.sweep, n="0:5")


def no_copies_and_threads():
    lobe = glint.lobe("cayley", "p16")
    n, cos, out = np.full(1 << 20, 50, np.uint16), np.arange(1 << 20, dtype=np.int32), np.empty(1 << 20, np.uint32)
    assert lobe(n, cos, out=out) is out
    import tracemalloc

    tracemalloc.start()
    lobe(n, cos, out=out)
    assert tracemalloc.get_traced_memory()[1] < 100000, "an array was copied"
    tracemalloc.stop()
    # While one thread computes, this one counts.
    worker = threading.Thread(target=lambda: [lobe(n, cos, out=out) for _ in range(5)])
    counted, start = 0, time.perf_counter()
    worker.start()
    while worker.is_alive():
        counted += 1
    seconds = time.perf_counter() - start
    assert counted > 100, f"{counted} in {seconds} s: the lock was held"


def speed():
    for name in ("bps", "cayley"):
        lobe = glint.lobe(name, "p12")
        n, out = np.full(1 << 20, 50, np.uint16), np.empty(1 << 20, np.uint32)
        cos = np.random.default_rng(1).integers(0, (1 << 18) + 1, 1 << 20, dtype=np.int32)

        def seconds(work):
            start = time.perf_counter()
            work()
            return time.perf_counter() - start

        best = [9.9] * 3
        for _ in range(15):  # in turn, so that all meet the same machine
            best[0] = min(best[0], lobe._core.batch_seconds(n, cos, out))
            best[1] = min(best[1], seconds(lambda: lobe(50, cos, out=out)))
            best[2] = min(best[2], seconds(lambda: lobe(n, cos, out=out)))
        print(f"{name}: a million inputs in {best[0] * 1000:.2f} ms by C++, in {best[1] * 1000:.2f} ms with a scalar n "
              f"({best[1] / best[0]:.2f}), in {best[2] * 1000:.2f} ms with an array ({best[2] / best[0]:.2f})")
        assert best[2] < 1.5 * best[0], "the module is slow"


if __name__ == "__main__":
    results(sys.argv[1])
    refusals()
    no_copies_and_threads()
    speed()
    print("module: all lobes, effects, refusals, no copies, threads")
