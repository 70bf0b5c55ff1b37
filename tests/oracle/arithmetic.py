"""Section "Arithmetic" of docs/contract.md, for the oracle and its lobes."""

from fractions import Fraction
from math import floor


class Refused(Exception):
    """A profile or a number that the contract does not admit; or a tool that cannot be run."""


def rnd(x, k):
    return (x + (1 << (k - 1))) >> k if k > 0 else x


def quantize(x, k):
    """The code of the real number x (a Fraction) at k fraction bits, halves away from zero."""
    return floor(x * 2**k + Fraction(1, 2)) if x >= 0 else -floor(-x * 2**k + Fraction(1, 2))


def cosine_code(x, F):
    if not abs(x) < 2:
        raise Refused(f"cosine {float(x)} is not legal: |x| < 2")
    return min(quantize(x, F), 2 ** (F + 1) - 1)
