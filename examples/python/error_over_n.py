#!/usr/bin/env python3
"""Draws the largest error of lobes against n: error_over_n.py PICTURE [LOBE...]. Needs glint and matplotlib."""

import sys

import glint
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def main() -> None:
    picture, *names = sys.argv[1:] or ["error_over_n.png"]
    figure, axes = plt.subplots(figsize=(8, 4.5), layout="constrained")
    for name in names or ["bps", "cayley", "blinn_phong"]:
        rows = glint.lobe(name, "p12").sweep(n=range(1, 1001, 3), cos="0:262144:16").rows
        axes.semilogy(rows["n"], rows["error_max"], label=name)
        worst = rows[rows["error_max"].argmax()]
        print(f"{name}: largest error {worst['error_max']:.4g} at n = {worst['n']}, cosine code {worst['error_cos_code']}")
    axes.set(xlabel="n", ylabel="largest error against $c^n$", title="Lobes at p12, every 16th cosine code")
    axes.grid(which="both", alpha=0.3)
    axes.legend()
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main()
