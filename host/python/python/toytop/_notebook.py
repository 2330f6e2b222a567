"""A notebook shows the page with the top in motion."""

from __future__ import annotations

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
