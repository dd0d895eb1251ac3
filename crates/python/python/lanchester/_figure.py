"""A figure that a notebook shows, whether or not pyplot was imported there."""

from __future__ import annotations

from io import BytesIO

from matplotlib.figure import Figure

__all__ = ["ShownFigure"]


class ShownFigure(Figure):  # type: ignore[misc]
    """A figure of Matplotlib. IPython draws figures only once pyplot is there; this one draws itself."""

    def _repr_png_(self) -> bytes:
        drawn = BytesIO()
        self.savefig(drawn, format="png")
        return drawn.getvalue()
