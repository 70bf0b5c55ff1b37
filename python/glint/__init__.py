"""The golden models of Glint: specular highlights in fixed point, bit for bit those of the Verilog (docs/python.md).

    >>> import glint
    >>> int(glint.lobe("bps", "p12")(50, 256901))
    1448

Codes are integers: a cosine code is c 2^F, a result y / 2^O. Arrays of the dtype that a function works with (n uint16,
cosine and port codes int32) are taken without a copy where they are contiguous; other integers are converted, and refused
where they do not fit. Arguments broadcast as in numpy. What is not legal raises glint.Error, a ValueError. Functions let
other threads run while they compute.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Error, effects, lobes

__version__: str = _core.version
__all__ = ["Effect", "EffectResult", "Error", "Lobe", "Port", "Sweep", "Vectors", "effect", "effects", "lobe", "lobes", "unpack"]

Range = Union[int, str, range]


class Vectors(NamedTuple):
    """Inputs that the ports of a lobe can carry, with what they show: the corners, then random ones."""

    n: NDArray[np.uint16]
    cos_code: NDArray[np.int32]
    y: NDArray[np.uint32]
    clamped: NDArray[np.bool_]


class Sweep(NamedTuple):
    """Errors per n and in total, with the columns of `glint sweep --csv`; -1 where nothing was seen."""

    rows: NDArray[np.void]
    total: np.void


class Port(NamedTuple):
    """A port of an effect: value = code / 2^fraction_bits; codes outside low .. high are corrected, and raise `clamped`."""

    name: str
    bits: int
    is_signed: bool
    fraction_bits: int
    low: int
    high: int


class EffectResult(NamedTuple):
    """What the ports of an effect's unit show."""

    values: dict[str, NDArray[np.int32]]
    clamped: NDArray[np.bool_]


_COLUMNS = np.dtype([
    ("n", np.int32), ("inputs", np.uint64), ("rounding_max_ulp", float), ("rounding_cos_code", np.int32), ("rounding_rms_ulp", float),
    ("error_max", float), ("error_cos_code", np.int32), ("error_rms", float), ("error_exact_cosine_max", float),
    ("error_exact_cosine_cos_code", np.int32), ("epicentre_max", float), ("epicentre_cos_code", np.int32)])


def _codes(values: ArrayLike, dtype: Any, what: str) -> NDArray[Any]:
    """An array of the dtype: the same one where it is of it."""
    array = np.asarray(values)
    if array.dtype == dtype:
        return array
    if array.size and array.dtype.kind not in "iu":
        raise Error(f"{what} is not legal: {array.dtype}, where integers are wanted")
    limits = np.iinfo(dtype)
    if array.size and (array.min() < limits.min or array.max() > limits.max):
        wrong = array[(array < limits.min) | (array > limits.max)].flat[0]
        raise Error(f"{what} {wrong} is not legal: {limits.min} to {limits.max} at most")
    return array.astype(dtype)


def _flat(array: NDArray[Any], shape: tuple[int, ...]) -> NDArray[Any]:
    return np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1)


def _range(value: Range) -> str:
    if isinstance(value, range):
        return f"{value.start}:{value[-1] if value else value.start - 1}:{value.step}"
    return str(value)


def unpack(packed: NDArray[np.uint32]) -> tuple[NDArray[np.uint32], NDArray[np.bool_]]:
    """y and clamped of what Lobe.port returns."""
    return packed & np.uint32(0x7FFFFFFF), (packed >> np.uint32(31)).astype(bool)


class Lobe:
    """A lobe at a profile. Immutable; threads may share it."""

    def __init__(self, name: str, profile: str = "p12") -> None:
        self._core = _core.Lobe(name, profile)
        self.name: str = self._core.name
        self.profile: str = self._core.profile
        self.F: int = self._core.F  #: fraction bits of the cosine
        self.O: int = self._core.O  #: fraction bits of the result

    def __repr__(self) -> str:
        return f"glint.lobe({self.name!r}, {self.profile!r})"

    def _eval(self, n: ArrayLike, cos_codes: ArrayLike, ports: bool, out: Optional[NDArray[np.uint32]]) -> NDArray[np.uint32]:
        exponents = _codes(n, np.uint16, "n")
        codes = _codes(cos_codes, np.int32, "cos_code")
        shape = np.broadcast_shapes(exponents.shape, codes.shape)
        if out is None:
            out = np.empty(shape, np.uint32)
        elif out.shape != shape or out.dtype != np.uint32 or not out.flags.c_contiguous:
            raise Error(f"out is not legal: a contiguous array of uint32 with the shape {shape} is wanted")
        one_n = exponents.size == 1  # for all
        self._core.eval(exponents.reshape(-1) if one_n else _flat(exponents, shape), _flat(codes, shape), out.reshape(-1), ports)
        return out

    def __call__(self, n: ArrayLike, cos_codes: ArrayLike, out: Optional[NDArray[np.uint32]] = None) -> NDArray[np.uint32]:
        """y for legal arguments: n in 1 .. 1023, cos_codes in 0 .. 2^F. `out`: an array to write into."""
        return self._eval(n, cos_codes, False, out)

    def port(self, n: ArrayLike, cos_codes: ArrayLike, out: Optional[NDArray[np.uint32]] = None) -> NDArray[np.uint32]:
        """What the ports show, y in bits 30 .. 0 and clamped in bit 31, for all that they can carry: n in 0 .. 1023,
        cos_codes in -2^(F+1) .. 2^(F+1) - 1."""
        return self._eval(n, cos_codes, True, out)

    def reference(self, n: float, c: ArrayLike) -> NDArray[np.float64]:
        """The real function of the lobe at one n, for every c."""
        values = np.asarray(c, np.float64)
        out = np.empty(values.shape, np.float64)
        self._core.reference(n, np.ascontiguousarray(values).reshape(-1), out.reshape(-1))
        return out

    def sweep(self, n: Range = "all", cos: Range = "all", threads: int = 0) -> Sweep:
        """Errors over ranges of n and of the cosine code, as `glint sweep`; threads 0: one a core."""
        rows = np.array(self._core.sweep(_range(n), _range(cos), threads), _COLUMNS)
        return Sweep(rows[:-1], rows[-1])

    def vectors(self, count: int, seed: int = 1) -> Vectors:
        """The vectors of `glint vectors`."""
        n, cos_code, y, clamped = zip(*self._core.vectors(count, seed))
        return Vectors(np.array(n, np.uint16), np.array(cos_code, np.int32), np.array(y, np.uint32), np.array(clamped, bool))


class Effect:
    """An effect at a profile. Immutable; threads may share it."""

    def __init__(self, name: str, profile: str = "p12", lobe: str = "bps") -> None:
        self._core = _core.Effect(name, profile, lobe)
        self.name: str = self._core.name
        self.profile: str = self._core.profile
        self.F: int = self._core.F
        self.O: int = self._core.O
        self.inputs: tuple[Port, ...] = tuple(Port(*port) for port in self._core.inputs)
        self.outputs: tuple[Port, ...] = tuple(Port(*port) for port in self._core.outputs)

    def __repr__(self) -> str:
        return f"glint.effect({self.name!r}, {self.profile!r})"

    def __call__(self, **codes: ArrayLike) -> EffectResult:
        """What the ports show; a code or an array of codes for each input port, by its name."""
        names = [port.name for port in self.inputs]
        if set(codes) != set(names):
            raise Error(f"inputs {sorted(codes)} are not legal: {names}")
        columns = [_codes(codes[name], np.int32, name) for name in names]
        shape = np.broadcast_shapes(*(column.shape for column in columns))
        outputs = [np.empty(shape, np.int32) for _ in self.outputs]
        clamped = np.empty(shape, np.uint8)
        self._core.eval([_flat(column, shape) for column in columns], [out.reshape(-1) for out in outputs], clamped.reshape(-1))
        return EffectResult({port.name: out for port, out in zip(self.outputs, outputs)}, clamped.astype(bool))

    def vectors(self, count: int, seed: int = 1) -> tuple[dict[str, NDArray[np.int64]], EffectResult]:
        """Inputs by port, and what the ports show for them: the vectors of `glint vectors`."""
        inputs, outputs, clamped = zip(*self._core.vectors(count, seed))
        columns = np.array(inputs, np.int64).T
        values = np.array(outputs, np.int32).T
        return ({port.name: column for port, column in zip(self.inputs, columns)},
                EffectResult({port.name: value for port, value in zip(self.outputs, values)}, np.array(clamped, bool)))


def lobe(name: str, profile: str = "p12") -> Lobe:
    """A lobe: "bps", "polynomial:symmetric:0:0:3:-2", ... at "p8", "p12", "p16" or numbers such as "18,14,14,12"."""
    return Lobe(name, profile)


def effect(name: str, profile: str = "p12", lobe: str = "bps") -> Effect:
    """An effect: "lambert", "ward", ...; `lobe` is the lobe of phong, blinn_phong and shade."""
    return Effect(name, profile, lobe)
