"""What the package for Node answers, beside what tests of Python have in common."""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
#: The project's own copy, or the directory that FROND_KNOWN names.
KNOWN = Path(os.environ.get("FROND_KNOWN", ROOT / "tests" / "known"))
#: The modules as they were built.
PACKAGE = Path(os.environ.get("FROND_PACKAGE", ROOT / "www" / "pkg"))

KINDS = {
    "Float32Array": np.float32,
    "Float64Array": np.float64,
    "Uint8Array": np.uint8,
    "Uint8ClampedArray": np.uint8,
}


def known(name: str) -> Any:
    """The exact answers of a file of tests/known."""
    return json.loads((KNOWN / f"{name}.json").read_text())


def _read(value: Any) -> Any:
    if isinstance(value, list):
        return [_read(one) for one in value]
    if not isinstance(value, dict):
        return value
    if set(value) == {"number"}:
        return float(value["number"].replace("Infinity", "inf"))
    if set(value) == {"array", "bytes"}:
        return np.frombuffer(base64.b64decode(value["bytes"]), KINDS[value["array"]])
    return {key: _read(one) for key, one in value.items()}


def node(calls: list[list[Any]]) -> list[Any]:
    """What the package in Node answers to calls, [name, argument ..]; of a call that throws, its code and message."""
    program = shutil.which("node")
    if program is None or not (PACKAGE / "node" / "index.js").is_file():
        pytest.fail("Node and www/pkg are needed: `cargo xtask test python` sees to both")
    done = subprocess.run(
        [program, str(HERE / "node.mjs"), str(PACKAGE)],
        input=json.dumps(calls),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    answers = json.loads(done.stdout)
    return [_read(found["answer"]) if "answer" in found else found for found in answers]


def same(found: Any, wanted: Any) -> None:
    """Bit for bit."""
    found, wanted = np.asarray(found), np.asarray(wanted)
    assert found.shape == wanted.shape
    assert found.dtype == wanted.dtype
    assert found.tobytes() == wanted.tobytes()
