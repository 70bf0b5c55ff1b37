#!/usr/bin/env python3
"""docs/lobes/bps.md against itself: each table, worked example and figure of it, recomputed by the oracle. That the worked
examples are those of the oracle, check_lobes.py checks.

Exit status: 0 all hold, 1 some do not, 2 the document cannot be read.
"""

import itertools
import math
import random
import re
import subprocess
import sys
from fractions import Fraction

import oracle
from arithmetic import quantize, rnd
from checks import by_name
from document import Unreadable, check, contract_of, integer, plain
from lobes.bps import Lobe
from oracle import Profile

SHIPPED = [Profile("bps", name) for name in oracle.SHIPPED]


def significant(text):
    """A number printed with so many decimals, and half a unit of its last one."""
    decimals = len(text.split(".")[1]) if "." in text else 0
    return Fraction(text), Fraction(1, 2 * 10**decimals)


def prints_as(x, text):
    value, half = significant(text)
    return abs(x - value) <= half


def check_rule_4(document, checks):
    refused, total = document.find(r"nothing else: ([0-9]+) of the ([0-9]+) triples")
    said = document.find(r"Rule 4 refuses (.*), and nothing else")[0]
    families = [tuple(map(int, x)) for x in re.findall(r"`O = K = ([0-9]+)` with `S >= ([0-9]+)`", said)]
    checks.true("rule 4 names formats", families)
    found, tried = [], 0
    for O in range(4, 29):
        for S, K in itertools.product(range(O, 31), repeat=2):
            tried += 1
            if Lobe(30, (S, K), O).refusal():
                found.append((S, K, O))
    checks.equal("triples (S, K, O)", tried, int(total))
    checks.equal("refused triples", len(found), int(refused))
    checks.equal("refused by name", found, sorted(((S, O, O) for O, least in families for S in range(least, 31)),
                                                  key=lambda x: (x[2], x[0], x[1])))
    numbers, y, one = document.find(r"`([0-9]+,[0-9]+,[0-9]+,4)`, for one, would answer ([0-9]+) where 1.0 is ([0-9]+)")
    F, S, K, O = map(int, numbers.split(","))
    checks.equal(numbers, (Lobe(F, (S, K), O).greatest_y(), 1 << O), (int(y), int(one)))
    # The search over stretches and the bound that `refusal` trusts, against every quotient one by one.
    for O, S in itertools.product(range(4, 12), range(4, 12)):
        for K in (*range(O, 13), 30):
            if S >= O:
                lobe = Lobe(S, (S, K), O)
                greatest = max(lobe.steps(1, q)[-1] for q in range(2**S + 1))
                checks.equal(f"greatest y of S={S} K={K} O={O}", greatest > 1 << O, lobe.refusal() is not None)
                if K <= 9:
                    checks.equal(f"stretches of S={S} K={K} O={O}", lobe.greatest_y(), greatest)


def bound(expression, K):
    """A range's end of the real-number table, such as `1.375 + 1.5 u`, with u = 2^-K."""
    match = re.fullmatch(r"(-?[0-9.]+)(?: ([+-]) ([0-9.]*) ?u(/2)?)?", expression.strip())
    if not match:
        raise Unreadable(f"contract: '{expression}' is not a bound")
    base, sign, factor, half = match.groups()
    if sign is None:
        return Fraction(base)
    return Fraction(base) + (1 if sign == "+" else -1) * Fraction(factor or 1) * Fraction(1, 2**K) / (2 if half else 1)


def check_real_function(document, checks):
    low, high = document.find(r"negative for `s` between ([0-9.]+) and ([0-9.]+);")
    start, depth, bottom, end = document.find(
        r"falls from ([0-9.]+) at `s = 0` to its minimum (-[0-9.]+) at `s = ([0-9.]+)`, "
        r"and rises from there to ([0-9.]+)")
    a, b, c1, d0 = Lobe.published.values()

    def f(s):
        return ((a * s + b) * s + c1) * s + d0

    def slope(s):
        return (3 * a * s + 2 * b) * s + c1

    def changes_sign(g, text):
        value, half = significant(text)
        return g(value - half) * g(value + half) < 0

    for zero in (low, high):
        checks.true(f"f_bps changes sign at {zero}", changes_sign(f, zero))
    checks.true(f"f_bps turns at {bottom}", changes_sign(slope, bottom))
    checks.true(f"minimum {depth}", prints_as(f(Fraction(bottom)), depth))
    checks.true("no other turning point in [0, 1]", slope(Fraction(1)) > 0 and slope(Fraction(0)) < 0 and a < 0)
    checks.equal("f_bps(0)", f(Fraction(0)), Fraction(start))
    checks.equal("f_bps(1)", f(Fraction(1)), Fraction(end))
    steepest = document.find(r"`abs\(f_bps'\) <= ([0-9.]+)` on \[0, 1\]")[0]
    checks.true(f"slope within {steepest}", c1 - b * b / (3 * a) <= Fraction(steepest) and -c1 <= Fraction(steepest))


def check_constants(document, checks):
    rows = document.table("Contract", "constants", "K")
    checks.equal("constants of", [row[0] for row in rows[1:]], list(oracle.SHIPPED))
    for row, profile in zip(rows[1:], SHIPPED):
        checks.equal(profile.name, [integer(x) for x in row[1:]], [profile.guards[1], *profile.lobe.constants.values()])
    formula = document.blocks("Contract")[0]
    for name, value in re.findall(r"(\w+) = (-?[0-9.]+)", formula[1]):
        checks.equal(f"published {name}", Fraction(value), Lobe.published[name])
    for name, x in Lobe.published.items():
        for k in range(31):
            scaled = x * 2**k
            checks.true(f"{name} is no half at {k} bits", (scaled - math.floor(scaled)) != Fraction(1, 2))
            checks.equal(f"{name} as a double at {k} bits", quantize(Fraction(float(x)), k), quantize(x, k))
    guards = document.table("Contract", "guard bits", "of")
    checks.equal("profiles of guard bits", guards[0][2:], list(oracle.SHIPPED))
    checks.equal("guard bits", {row[0]: tuple(map(integer, row[2:])) for row in guards[1:]},
                 dict(zip(Lobe.guards, zip(*Lobe.shipped.values()))))


def quotient_steps(lobe, q):
    """Every value of the range tables at a quotient, by the name it has there."""
    _, quotient, h1, h2, r, y = lobe.of_quotient.steps(1, q)
    a, d0 = lobe.constants["a"], lobe.constants["d0"]
    return {"quotient": quotient, "a * quotient": a * q, "h1": h1, "h1 * quotient": h1 * q, "h2": h2,
            "h2 * quotient": h2 * q, "h2 * quotient + d0 2^S": h2 * q + (d0 << lobe.S), "r": r, "y": y}


def check_real_ranges(document, checks):
    """The table of real numbers, for small S at every quotient and for all S and K at the ends of 64 bits."""
    rows = {row[0]: row[2] for row in document.table("Ranges", "value", "fraction bits")[1:]}
    for S, K in itertools.product(range(4, 11), (*range(4, 13), 16, 30)):
        for O in (4, min(S, K)):
            lobe = Lobe(S, (S, K), O)
            ranges = {}
            for q in range(2**S + 1):
                for name, x in quotient_steps(lobe, q).items():
                    low, high = ranges.get(name, (x, x))
                    ranges[name] = min(low, x), max(high, x)
            fraction_bits = {"quotient": S, "h1": K, "h2": K, "y": O}
            for name, (low, high) in ranges.items():
                if name == "r" or (name == "y" and lobe.refusal()):
                    continue
                least, greatest = (bound(x, K) for x in rows[name].split(".. "))
                one = 2 ** fraction_bits.get(name, K + S)
                checks.true(f"{name} at S={S} K={K} O={O}", least * one <= low and high <= greatest * one)
    checks.equal("rows of real ranges", set(rows), {"C", "D"} | set(ranges) - {"r"})
    for S, K in itertools.product(range(4, 31), repeat=2):
        constants = Lobe(30, (S, K), 4).constants.values()
        checks.true(f"constants below 4 at K={K}", all(abs(x) < 4 * 2**K for x in constants))
        greatest = max(abs(bound(x, K)) for name in rows if name not in ("C", "D") for x in rows[name].split(".. "))
        # Added before a shift: 2^(S-1), and 2^(S+K-O-1) with O >= 4, which is the greater.
        checks.true(f"64 bits at S={S} K={K}", greatest * 2 ** (S + K) + 2 ** (S + K - 5) < 2**63)
    checks.true("C 2^S and D in 64 bits", 2**30 * 2**30 < 2**63 and 1023 * 2**30 < 2**63)


def check_quotients(document, checks):
    """Exact ranges, turning points and the bound of the rounding error, over all quotients of the shipped profiles."""
    rows = document.table("Ranges", "value", *oracle.SHIPPED)
    ends = document.find(r"the first after them, are (.*?)\. At fixed `n`")[0]
    ends = {name: (int(x), int(y)) for x, y, name in re.findall(r"([0-9]+) and ([0-9]+) \(`(\w+)`\)", ends)}
    errors = {plain(row[0]): row for row in document.table("Errors", "profile", "worst rounding error, ulp")[1:]}
    checks.equal("profiles with turning points", set(ends), set(oracle.SHIPPED))
    checks.equal("profiles with a promise", set(errors), set(oracle.SHIPPED))
    for profile in SHIPPED:
        checks.equal(f"inputs of {profile.name}", errors[profile.name][3].replace(" ", ""),
                     f"{1023 * ((1 << profile.F) + 1)}(all)")
    for column, profile in enumerate(SHIPPED, 1):
        lobe, S, O = profile.lobe, profile.lobe.S, profile.O
        real = lobe.of_quotient.real
        ranges, falls, rises, before, bounds = {}, [], [], None, []
        unit = real(1, 0)[1]  # at n = 1 all denominators are this one
        exact = real(1, 0)[0]
        for q in range(2**S + 1):
            values = quotient_steps(lobe, q)
            for name, x in values.items():
                low, high = ranges.get(name, (x, x))
                ranges[name] = x if x < low else low, x if x > high else high
            y = values["y"]
            if before is not None and y != before:
                (falls if y < before else rises).append(q)
            before = y
            following = real(1, q + 1)[0] if q < 2**S else exact
            bounds.append(max(abs(y * unit - (exact << O)), abs(y * unit - (following << O))))
            exact = following
        checks.equal(f"rows of {profile.name}", [row[0] for row in rows[1:]], list(ranges))
        for row in rows[1:]:
            checks.equal(f"{row[0]} of {profile.name}", tuple(map(integer, row[column].split(".. "))), ranges[row[0]])
        checks.true(f"{profile.name} falls only before 0.066, rises only after it",
                    falls[-1] < 0.066 * 2**S < rises[0])
        zeros = (falls[-1] - 1, rises[0])
        checks.equal(f"zeros of {profile.name}", zeros, ends[profile.name])
        checks.true(f"{profile.name} is 0 between", lobe.of_quotient.steps(1, falls[-1])[-1] == 0)
        checks.equal(f"h1 of {profile.name} at 2^S", ranges["h1"][0], lobe.constants["a"] + lobe.constants["b"])
        check_promise(checks, profile, errors[profile.name], bounds, unit)


def rounding_error(profile, n, C):
    """The rounding error of section "Errors" in ulp, exactly."""
    numerator, denominator = profile.lobe.real(n, C)
    return abs(profile.lobe.steps(n, C)[-1] - Fraction(numerator << profile.O, denominator))


def check_promise(checks, profile, row, bounds, unit):
    """The worst rounding error and its place, over every legal input: an input's error is at most the bound of its
    quotient, so that only the few quotients whose bound reaches the worst error can hold a worse one; and on the codes
    of one quotient the error is greatest at the first or the last, as the real function is monotone there."""
    S, one = profile.lobe.S, 1 << profile.F
    n, code = map(integer, row[2].split(","))
    worst = rounding_error(profile, n, code)
    stated = checks.true(f"error of {profile.name} at {n}, {code} is {float(worst):.9f}", prints_as(worst, row[1]))
    greatest = Fraction(max(bounds), unit)
    checks.true(f"bound of {profile.name} is {float(greatest):.9f}", prints_as(greatest, row[4]))
    checks.true(f"{profile.name} stays below 1 ulp", greatest < 1)
    if not stated:
        return  # a search from too small an error would take hours
    candidates = [q for q, x in enumerate(bounds) if Fraction(x, unit) >= worst]
    found, place, tried = Fraction(-1), None, 0
    for exponent in range(1, 1024):
        for q in candidates:
            # quotient >= q where C 2^S >= q D, that is C (2^S + (n-1) q) >= n q 2^F
            first = -(-exponent * q * one // (2**S + (exponent - 1) * q))
            last = -(-exponent * (q + 1) * one // (2**S + (exponent - 1) * (q + 1))) - 1
            for C in {first, min(last, one)} if first <= min(last, one) else ():
                tried += 1
                checks.equal(f"quotient of {exponent}, {C}", profile.lobe.steps(exponent, C)[1], q)
                error = rounding_error(profile, exponent, C)
                if error > found or (error == found and (exponent, C) < place):
                    found, place = error, (exponent, C)
    checks.equal(f"place of the worst error of {profile.name}", place, (n, code))
    checks.equal(f"worst error of {profile.name} over all legal inputs", found, worst)
    print(f"  {profile.name}: {len(candidates)} quotients can hold the worst error, {tried} inputs tried: "
          f"{float(found):.9f} ulp at {place[0]}, {place[1]}; bound {float(greatest):.9f}")
    # Without that argument: no input tried is worse.
    generator = random.Random(f"promise {profile.name}")
    inputs = oracle.corners(profile) + oracle.random_inputs(profile, generator, 20000)
    legal = [x for x in inputs if oracle.is_legal(profile, *x)]
    for x in legal:
        checks.true(f"error of {x} at {profile.name}", rounding_error(profile, *x) <= worst)
    check_doubles(checks, profile, legal)


def check_doubles(checks, profile, inputs):
    """Binary64 measures the rounding error within 2^-49, as section "Errors" derives it."""
    a, b, c1, d0 = map(float, Lobe.published.values())
    for n, C in inputs:
        c = C / 2**profile.F
        s = c / (c + n * (1 - c))
        measured = abs(profile.lobe.steps(n, C)[-1] / 2**profile.O - max(0.0, s * (c1 + s * (b + a * s)) + d0))
        off = abs(Fraction(measured) - rounding_error(profile, n, C) / 2**profile.O)
        checks.true(f"error of {n}, {C} in doubles at {profile.name}", off < Fraction(1, 2**49))


def check_examples(document, checks):
    examples = document.examples()
    checks.equal("profiles with examples", list(examples), list(oracle.SHIPPED))
    for profile, text in zip(SHIPPED, re.findall(r"-[0-9]+\.5", document.find(
            r"a half that rounds up from a negative number \(`rnd\(a \* quotient, S\)`: ([^)]*)\)")[0]), strict=True):
        half = Fraction(text) * 2**profile.lobe.S
        quotients = [row["quotient"] for row in examples[profile.name]]
        checks.true(f"{profile.name} shows {text}", half in [profile.lobe.constants["a"] * q for q in quotients])


def check_example_in_full(document, checks):
    block = document.blocks("Worked examples")[0]
    profile = Profile("bps", "p12")
    F, S, K, O = profile.F, profile.lobe.S, profile.lobe.K, profile.O
    n, code = 50, oracle.cosine_code(Fraction("0.98"), F)
    a, b, c1, d0 = profile.lobe.constants.values()
    D, q, h1, h2, r, y = profile.lobe.steps(n, code)
    x = oracle.intermediates(profile, n, code)
    last = S + K - O
    numerator, denominator = profile.lobe.real(n, code)
    expected = [
        f"cos_code = floor(0.98 * 2^{F} + 1/2) = {code} C = {x['C']}, clamped = {x['clamped']}",
        f"D = {n} * {1 << F} - {n - 1} * {code} = {D}",
        f"quotient = floor({code} * 2^{S} / {D}) = floor({code << S} / {D}) = {q}",
        f"h1 = {b} + rnd({a} * {q}, {S}) = {b} + rnd({a * q}, {S}) = {b} - {-rnd(a * q, S)} = {h1}",
        f"h2 = {c1} + rnd({h1} * {q}, {S}) = {c1} + rnd({h1 * q}, {S}) = {c1} + {rnd(h1 * q, S)} = {h2}",
        f"r = rnd({h2} * {q} + {d0} * 2^{S}, {last}) = rnd({h2 * q} + {d0 << S}, {last}) "
        f"= rnd({h2 * q + (d0 << S)}, {last}) = {r}",
        f"y = {y} {y} / 2^{O} = {y / 2**O:.5f}; f_bps = {numerator / denominator:.5f}",
    ]
    checks.equal("lines of the example in full", [" ".join(line.split()) for line in block], expected)


def check_program(document, checks):
    """The document's own program: that it runs, and prints the figures of the tables."""
    blocks = document.blocks("Ranges", "python")
    done = subprocess.run([sys.executable, "-"], input="\n".join(blocks[0]), capture_output=True, text=True)
    checks.equal("exit status of the program", done.returncode, 0)
    lines = done.stdout.splitlines()
    checks.equal("lines of the program", len(lines), 2 * len(SHIPPED))
    ranges = document.table("Ranges", "value", *oracle.SHIPPED)[1:]
    errors = document.table("Errors", "profile", "worst rounding error, ulp")[1:]
    for column, profile in enumerate(SHIPPED, 1):
        first, second = lines[2 * column - 2 : 2 * column]
        for row in ranges[1:]:
            low, high = map(integer, row[column].split(".. "))
            checks.true(f"the program prints {row[0]} of {profile.name}", f"({low}, {high})" in first)
        bound_text = re.search(r"error at most ([0-9.]+) ulp", second)[1]
        said = errors[column - 1][4]
        checks.true(f"the program prints the bound of {profile.name}", prints_as(Fraction(bound_text), said))


PARTS = by_name(check_rule_4, check_real_function, check_constants, check_real_ranges, check_quotients, check_examples,
                check_example_in_full, check_program)

if __name__ == "__main__":
    sys.exit(check(PARTS, contract_of("bps")))
