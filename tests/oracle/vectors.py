"""What the effects from two vectors have in common, from docs/effects/cosine.md and bps_vectors.md."""


def products(given, W):
    """p, aa, bb, s and j of the inputs a and b; j is 0 where s is."""
    a, b = ([given[f"{name}_{axis}"] for axis in "xyz"] for name in "ab")
    p, aa, bb = (sum(u * v for u, v in zip(*pair)) for pair in ((a, b), (a, a), (b, b)))
    s = aa * bb
    return p, aa, bb, s, (4 * W - s.bit_length()) // 4 if s else 0


def inputs():
    """Parallel, opposite and perpendicular vectors of all lengths, and their neighbours; the highlight; every n."""
    for length in (*range(1, 60), *(2**k + off for k in range(8, 15) for off in (-1, 0, 1)), 32767):
        for other in (1, 3, length, 32767):
            for off in (-1, 0, 1):
                n = (length * 7 + other + off) % 1024
                yield length, 0, 0, other, off, 0, 1023
                yield 0, -length, 0, 0, other, off, n
                yield length, length, -length, other, other, max(-32768, off - other), 1000
                yield length, -1, 0, 1, max(-32768, min(32767, length + off)), 0, n
    for n in range(1024):
        yield 20000, 10000, 20000, 20000 + n % 199, 10000 - n % 97, 20001, n
        yield 16384, 0, 0, 16384, 16384 // (1 + n), n, n
