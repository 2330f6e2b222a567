"""The notebooks run, and the axes of their figures are labelled."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

NOTEBOOKS = Path(__file__).parents[1] / "notebooks"
# modules of host/comparisons
LOCAL = ("top", "lie_group")


@pytest.mark.parametrize("path", sorted(NOTEBOOKS.glob("*.ipynb")), ids=lambda path: path.stem)
def test_a_notebook(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cells = [cell for cell in json.loads(path.read_text())["cells"] if cell["cell_type"] == "code"]
    sources = ["".join(cell["source"]) for cell in cells]
    for library in re.findall(r"^(?:import|from) (\w+)", "\n".join(sources), re.MULTILINE):
        if library not in LOCAL:
            pytest.importorskip(library, reason=f"{library} is not installed")
    matplotlib: Any = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    monkeypatch.chdir(path.parent)
    names: dict[str, Any] = {}
    for source in sources:
        exec(compile(source, path.name, "exec"), names)
    axes = [axes for number in plt.get_fignums() for axes in plt.figure(number).axes]
    plt.close("all")
    assert axes
    for one in axes:
        # the axis of a colour bar has one label
        assert one.get_ylabel() and (one.get_xlabel() or one.get_label() == "<colorbar>")
