"""A notebook shows the page with the top in motion, and the curve of its tip."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import final


@final
@dataclass(frozen=True, repr=False)
class Page:
    """Page that shows a top in motion. A notebook draws it where it ends a cell.

    Attributes:
        html: text of the page, HTML that needs no other file and no network.
    """

    html: str

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the page to a file for a browser.

        Raises:
            OSError: the file cannot be written.
        """
        Path(path).write_text(self.html, encoding="utf-8", newline="")

    def _repr_html_(self) -> str:
        page = self.html.replace("&", "&amp;").replace('"', "&quot;")
        return f'<iframe srcdoc="{page}" width="100%" height="720" style="border:0"></iframe>'

    def __repr__(self) -> str:
        return f"<Page of {len(self.html.encode()) // 1000} KB>"


def tip_curve(points: Sequence[Sequence[float]], radii: Sequence[float]) -> str:
    """Curve of the tip as SVG, between its circles and from its start, with the second fixed axis upwards."""
    side = 320
    middle = side // 2
    largest = max([*radii, *(math.hypot(x, y) for x, y in points)], default=0.0)
    scale = 0.45 * side / largest if largest > 0.0 else 1.0
    places = [f"{middle + scale * x:.2f},{middle - scale * y:.2f}" for x, y in points]
    circle = f'<circle cx="{middle}" cy="{middle}" r="{{:.2f}}" fill="none" stroke="#8a8a8a"/>'
    circles = "".join(circle.format(scale * radius) for radius in radii)
    x, y = places[0].split(",")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{side}" height="{side}" viewBox="0 0 {side} {side}">'
        f'<rect width="100%" height="100%" fill="#fff"/>{circles}'
        f'<polyline points="{" ".join(places)}" fill="none" stroke="#1f4e8c" stroke-width="1.5"/>'
        f'<circle cx="{x}" cy="{y}" r="3.5" fill="#c0392b"/></svg>'
    )
