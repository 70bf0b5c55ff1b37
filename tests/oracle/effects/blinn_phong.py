"""docs/effects/blinn_phong.md in exact integers, with the lobe bps: phong with another cosine."""

from effects.phong import Effect

__all__ = ["Effect"]
